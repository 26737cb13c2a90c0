// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "dot/frame/strip_wave.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Removes the bands that lamps on mains cause. Their light changes 100 or 120 times a second. A rolling shutter
/// exposes one row after another, so each row has its own brightness, and in the next frame another one. No gain of the
/// whole image explains that.
///
/// The light is nearly a sinusoid over the rows, and its period stays: that of the lamps over the time of a row. The
/// logarithm of the ratio of two images is then a sinusoid of that period, too, and the same in all columns. What moves
/// in the scene is neither. The ratio of a strip of rows is the median of those of its cells, so a mover does not
/// count. A sinusoid is believed if it explains most of these ratios. Each image is brought to the light of the one
/// before. The light of the first one fades, because the mean over time has no bands.
class FlickerRemoval {
 public:
  /// Compares the next image with the one before. @param follows whether there is one.
  /// @return whether the image must be corrected.
  bool compare(const Pyramid& image, bool follows) {
    std::swap(cells_, last_);
    const bool can_compare = follows && measured_;
    if (!follows) forget();
    measured_ = measure(image);
    if (can_compare && measured_ && cells_ != last_) update();  // an image that comes again has the same light
    return light_ != Strips{};
  }

  /// Removes the bands from a row of the image. Saturated pixels stay: how bright they are is not known.
  /// @param y of `height` rows.
  void correct(int y, int height, std::uint8_t* row, int width) const {
    const float place = (static_cast<float>(y) + 0.5f) * kStrips / static_cast<float>(height) - 0.5f;
    const float at = std::clamp(place, 0.f, static_cast<float>(kStrips - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(at), kStrips - 2);
    const float share = at - static_cast<float>(i);
    const float gain = std::exp(-((1 - share) * light_[i] + share * light_[i + 1]));
    for (int x = 0; x < width; ++x) {
      const float value = std::min(255.f, gain * static_cast<float>(row[x]) + 0.5f);
      row[x] = row[x] == 255 ? row[x] : static_cast<std::uint8_t>(value);
    }
  }

  /// Forgets the light.
  void forget() noexcept {
    light_ = {};
    measured_ = false;
    periods_ = 0;
    missed_ = 0;
  }

 private:
  static constexpr std::size_t kStrips = StripWave::kStrips, kColumns = 16;
  static constexpr float kDark = 16, kBright = 235;  ///< grey values: beyond, offsets and saturation spoil a ratio
  static constexpr std::size_t kLeastCells = 4;      ///< of a strip
  static constexpr double kFewest = 1, kMost = 8;    ///< periods in an image; shorter ones have under six strips
  static constexpr double kLeastAmplitude = 0.03;    ///< of the ratio's logarithm: the alignment bears less
  static constexpr double kSure = 0.75;              ///< explained, of a new period
  static constexpr double kLikely = 0.5;             ///< explained, of the known period
  static constexpr double kSamePeriod = 0.25;        ///< by which two measurements of one period differ
  static constexpr double kAdaption = 0.1;           ///< of the period, per frame
  static constexpr int kForgotten = 30;              ///< frames without it after which a period is no longer known
  static constexpr float kLeak = 0.05f;              ///< of the light per frame, so that errors do not add up
  static constexpr float kNegligible = 0.004f;       ///< of the light: one grey value

  using Strips = StripWave::Values;
  using Cells = std::array<float, kStrips * kColumns>;

  /// Sets the mean grey values of all cells, on the coarsest level with enough rows. @return whether there is one.
  bool measure(const Pyramid& image) {
    int level = image.size() - 1;
    while (level >= 0 && image.levels[static_cast<std::size_t>(level)].height() < static_cast<int>(kStrips)) --level;
    if (level < 0) return false;
    const Image<std::uint8_t>& grey = image.levels[static_cast<std::size_t>(level)];
    const auto begin = [](std::size_t i, std::size_t n, int size) {
      return static_cast<int>(i * static_cast<std::size_t>(size) / n);
    };
    for (std::size_t s = 0; s < kStrips; ++s) {
      const int top = begin(s, kStrips, grey.height()), bottom = begin(s + 1, kStrips, grey.height());
      for (std::size_t c = 0; c < kColumns; ++c) {
        const int left = begin(c, kColumns, grey.width()), right = begin(c + 1, kColumns, grey.width());
        int sum = 0;
        for (int y = top; y < bottom; ++y) sum = std::accumulate(grey.row(y) + left, grey.row(y) + right, sum);
        const int n = (right - left) * (bottom - top);
        cells_[s * kColumns + c] = n ? static_cast<float>(sum) / static_cast<float>(n) : 0;
      }
    }
    return true;
  }

  /// Logarithm of the ratio of each strip's brightness to that in the image before.
  Strips ratios() const {
    Strips out;
    for (std::size_t s = 0; s < kStrips; ++s) {
      std::array<float, kColumns> ratio;
      std::size_t n = 0;
      const auto is_usable = [](float v) { return v > kDark && v < kBright; };
      for (std::size_t i = s * kColumns; i < (s + 1) * kColumns; ++i)
        if (is_usable(cells_[i]) && is_usable(last_[i])) ratio[n++] = cells_[i] / last_[i];
      const auto end = ratio.begin() + static_cast<std::ptrdiff_t>(n);
      out[s] = n < kLeastCells ? StripWave::kNone : std::log(median(ratio.begin(), end));
    }
    return out;
  }

  /// Adds the change since the last image to the light.
  void update() {
    for (float& l : light_) l *= 1 - kLeak;
    const Strips change = ratios();
    const bool known = periods_ > 0;
    StripWave wave = StripWave::fit(change, known ? std::max(kFewest, periods_ - kSamePeriod) : kFewest,
                                    known ? std::min(kMost, periods_ + kSamePeriod) : kMost, kLeastAmplitude);
    if (wave.amplitude() >= kLeastAmplitude && wave.explained >= (known ? kLikely : kSure)) {
      periods_ = known ? periods_ + kAdaption * (wave.periods - periods_) : wave.periods;
      missed_ = 0;
      wave.periods = periods_;
      wave.refine(change);
      for (std::size_t s = 0; s < kStrips; ++s) light_[s] += static_cast<float>(wave.at(StripWave::middle(s)));
    } else if (++missed_ > kForgotten) {
      periods_ = 0, missed_ = 0;
    }
    const auto is_negligible = [](float l) { return std::abs(l) < kNegligible; };
    if (std::all_of(light_.begin(), light_.end(), is_negligible)) light_ = {};
  }

  Cells cells_{}, last_{};
  bool measured_ = false;  ///< whether the cells are of the image looked at last
  Strips light_{};         ///< logarithm of each strip's brightness, to be removed
  double periods_ = 0;     ///< how many fit into the image; 0: not known
  int missed_ = 0;         ///< images since it was seen
};

DOT_END_NAMESPACE
