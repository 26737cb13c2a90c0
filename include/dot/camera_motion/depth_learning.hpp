// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "dot/camera/concept.hpp"
#include "dot/camera/depth_bias.hpp"
#include "dot/camera/depth_noise.hpp"
#include "dot/camera_motion/scale_jitter.hpp"
#include "dot/containers/recycling_list.hpp"
#include "dot/image/image.hpp"
#include "dot/lie/se3.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Learns the size of the depth noise from the static background.
///
/// Patches of about the size of a car are cut from the background of each frame. In a later frame a patch's inverse
/// depth differs from the prediction by the camera motion. The median difference of a patch is an error that its pixels
/// share, the scatter about the median is the error of single pixels. Over the patches the shared errors have heavier
/// tails than a normal distribution, so their sigma is taken from the 85 % quantile. Smoothed over time, the errors
/// scale the priors of DepthNoise: `change` against the previous frame, `common` against one about 0.4 s back. A
/// standing camera sees the same errors again. So the image must have moved by kMinMotion pixels. What all patches of a
/// frame have in common is an error of its scale, see ScaleJitter.
struct DepthLearning {
  static constexpr int kWidth = 40;                                      ///< pixels: patch
  static constexpr int kHeight = 30;                                     ///< pixels: patch
  static constexpr int kStep = 4;                                        ///< pixels: from one sample to the next
  static constexpr int kSamples = (kWidth / kStep) * (kHeight / kStep);  ///< of a patch
  static constexpr int kMinSamples = 40;                                 ///< that must be measured
  static constexpr int kPatches = 180;                                   ///< enough patches of a frame
  static constexpr double kMinMotion = 1.5;                              ///< pixels, median over the samples
  static constexpr double kSharedQuantile = 0.85;    ///< of the patches' errors, whose tails are heavy
  static constexpr float kSigmasOfQuantile = 1.44f;  ///< |x| / sigma of a normal at that quantile
  static constexpr std::size_t kMinPatches = 5;      ///< of a comparison
  static constexpr double kOtherSurface = 7;         ///< sigmas of one pixel; a larger difference is another surface
  static constexpr double kRelief = 0.3;             ///< largest depth range of one surface, share of its distance
  static constexpr double kLeastPixelScale = 0.2;    ///< smallest `pixel` that is believed
  static constexpr double kMostPixelScale = 2;       ///< largest `pixel` that is believed

  /// Sampled patches of a frame.
  struct Patches {
    std::vector<float> x;                 ///< ray (x, y, 1) of each sample, camera axes
    std::vector<float> y;                 ///< ray (x, y, 1) of each sample, camera axes
    std::vector<float> q;                 ///< inverse depth of each sample, 1/m
    std::vector<int> begin;               ///< first sample of each patch, and the end
    std::vector<DepthBias::Terms> place;  ///< bias terms at each patch's middle
    DepthBias bias;                       ///< that was subtracted from q
    double timestamp = 0;                 ///< of the frame, seconds
    SE3d T_cur_ref;                       ///< camera motion from the frame to the newest one
  };

  /// One scale: the median of the values of up to kFrames frames. A single frame can be far off when something passes
  /// by.
  struct Scale {
    static constexpr std::size_t kFrames = 20;  ///< that count
    std::vector<float> said;                    ///< values of the last frames, in any order
    std::size_t next = 0;                       ///< place of the next value in `said`

    /// Forgets all values.
    void clear() noexcept {
      said.clear();
      next = 0;
    }
    /// Adds the value of a frame.
    void add(float v) {
      if (said.size() < kFrames)
        said.push_back(v);
      else
        said[next] = v;
      next = (next + 1) % kFrames;
    }
    /// The median. @pre a value was added
    double value() const {
      std::array<float, kFrames> v{};
      std::copy(said.begin(), said.end(), v.begin());
      return static_cast<double>(lower_median(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(said.size())));
    }
    /// Blended with the prior 1, which counts as one frame. Raised by a quarter, because a median hides large values.
    double blended() const {
      if (said.empty()) return 1;
      constexpr double kHiddenByMedian = 1.25;
      const double n = static_cast<double>(said.size()), v = value();
      return kHiddenByMedian * std::sqrt((n * v * v + 1) / (n + 1));
    }
  };

  double reference_seconds = 0.4;  ///< age of the frame for `common`
  RecyclingList<Patches> history;  ///< newest first
  Scale change;                    ///< of the shared error, against the previous frame
  Scale common;                    ///< of the shared error, against the older frame
  Scale pixel;                     ///< of the error of each pixel
  ScaleJitter scale_jitter;        ///< of the scale of whole frames

  /// Drops the frames, but keeps the learnt scales.
  void clear() noexcept { history.clear(); }
  /// Drops both.
  void forget() noexcept {
    clear();
    change.clear(), common.clear(), pixel.clear();
    scale_jitter = {};
    first_ = 0;
  }

  /// Cuts patches from the frame's background. `background` is zero where objects are.
  /// @param bias that was subtracted from the depth. It may be known better when the frame is compared.
  template <typename Camera>
  void remember(const Camera& camera, const Image<float>& inverse_depth, const Image<std::uint8_t>& background,
                double timestamp, const DepthBias& bias = {}) {
    thin_newest(history, reference_seconds);
    Patches& p = history.push_front();
    p.x.clear(), p.y.clear(), p.q.clear(), p.begin.clear(), p.place.clear();
    p.timestamp = timestamp;
    p.bias = bias;
    p.T_cur_ref = {};
    const int columns = inverse_depth.width() / kWidth, rows = inverse_depth.height() / kHeight;
    const int every = std::max(1, columns * rows / kPatches);
    first_ = (first_ + 1) % every;  // other patches in each frame
    for (int row = 0; row < rows; ++row)
      for (int column = (row + first_) % every; column < columns; column += every) {
        const int x0 = column * kWidth, y0 = row * kHeight;
        const std::size_t begin = p.q.size();
        for (int y = y0 + kStep / 2; y < y0 + kHeight; y += kStep)
          for (int x = x0 + kStep / 2; x < x0 + kWidth; x += kStep) {
            const float q = inverse_depth(x, y);
            if (q <= 0 || !background(x, y)) continue;
            const Vector3<float> ray =
                camera.template unproject<float>(Vector2<float>(static_cast<float>(x), static_cast<float>(y)));
            p.x.push_back(ray.x()), p.y.push_back(ray.y()), p.q.push_back(q);
          }
        if (p.q.size() - begin >= kMinSamples) {
          p.begin.push_back(static_cast<int>(begin));
          p.place.push_back(DepthBias::terms((2.0 * x0 + kWidth) / inverse_depth.width() - 1,
                                             (2.0 * y0 + kHeight) / inverse_depth.height() - 1));
        } else {
          p.x.resize(begin), p.y.resize(begin), p.q.resize(begin);
        }
      }
    p.begin.push_back(static_cast<int>(p.q.size()));
    while (history.size() > 1 && timestamp - history.back().timestamp > reference_seconds + 1e-6) history.pop_back();
  }

  /// Compares the new frame with the newest and the oldest remembered one, and scales `noise`.
  /// @param bias that was subtracted from the depth.
  template <typename Camera>
  void learn(const Camera& camera, const SE3d& T_cur_prev, const Image<float>& inverse_depth, double timestamp,
             DepthNoise& noise, const DepthBias& bias = {}) {
    for (Patches& p : history) p.T_cur_ref = T_cur_prev * p.T_cur_ref;
    if (history.empty()) return;
    compare(camera, history.front(), inverse_depth, noise, bias, change, &pixel);
    const Patches& oldest = history.back();
    if (timestamp - oldest.timestamp > 0.5 * reference_seconds)
      compare(camera, oldest, inverse_depth, noise, bias, common, nullptr);
    noise.shared_drift_scale = change.blended();
    noise.shared_scale = common.blended();
    noise.pixel_scale = pixel.said.empty() ? 1 : std::clamp(pixel.value(), kLeastPixelScale, kMostPixelScale);
  }

 private:
  template <typename Camera>
  void compare(const Camera& camera, const Patches& p, const Image<float>& inverse_depth, const DepthNoise& noise,
               const DepthBias& bias, Scale& shared, Scale* single) {
    const Matrix3<float> R = p.T_cur_ref.R.cast<float>();
    const Vector3<float> t = p.T_cur_ref.t.cast<float>();
    medians_.clear();
    ratios_.clear();
    scatters_.clear();
    motion_.clear();
    const DepthBias::Terms learnt = bias.coefficients - p.bias.coefficients;
    for (std::size_t k = 0; k + 1 < p.begin.size(); ++k)
      compare_patch(camera, p, k, static_cast<float>(p.place[k].dot(learnt)), R, t, inverse_depth, noise,
                    single != nullptr);
    if (single) scale_jitter.add(ratios_);
    if (medians_.size() < kMinPatches || static_cast<double>(lower_median(motion_.begin(), motion_.end())) < kMinMotion)
      return;
    shared.add(quantile(medians_.begin(), medians_.end(), kSharedQuantile) / kSigmasOfQuantile);
    if (single) single->add(lower_median(scatters_.begin(), scatters_.end()));
  }

  /// Adds the errors of one patch, if it is seen again and is one surface.
  /// @param bias of its inverse depths, 1/m, that has become known since. @param scatter whether to add the scatter of
  /// single pixels.
  template <typename Camera>
  void compare_patch(const Camera& camera, const Patches& p, std::size_t k, float bias, const Matrix3<float>& R,
                     const Vector3<float>& t, const Image<float>& inverse_depth, const DepthNoise& noise,
                     bool scatter) {
    std::array<float, kSamples> differences;
    std::size_t count = 0;
    float q_min = 1e9f, q_max = 0;
    Vector3<float> last_ray = Vector3<float>::Zero();
    Vector2<float> last_position = Vector2<float>::Zero();
    for (auto i = static_cast<std::size_t>(p.begin[k]); i < static_cast<std::size_t>(p.begin[k + 1]); ++i) {
      const float q = p.q[i] - bias;
      const Vector3<float> ray(p.x[i], p.y[i], 1), X = R * ray + q * t;
      if (X.z() < 1e-3f) continue;
      const Vector2<float> position = camera.template project<float>(X);
      // The nearest pixel. It exists up to half a pixel beyond the outermost one.
      const float x = position.x() + 0.5f, y = position.y() + 0.5f;
      if (!(x >= 0 && y >= 0 && x < static_cast<float>(inverse_depth.width()) &&
            y < static_cast<float>(inverse_depth.height())))
        continue;
      const float measured = inverse_depth(static_cast<int>(x), static_cast<int>(y));
      if (measured <= 0) continue;
      const float predicted = q / X.z();
      differences[count++] = measured - predicted;
      last_ray = ray, last_position = position;
      q_min = std::min(q_min, predicted);
      q_max = std::max(q_max, predicted);
    }
    if (static_cast<int>(count) < kMinSamples) return;
    const auto end = differences.begin() + static_cast<std::ptrdiff_t>(count);
    const double middle = 0.5 * static_cast<double>(q_min + q_max);
    const double other_surface = kOtherSurface * noise.prior_pixel_sigma(middle);
    const double relief = std::max(other_surface, kRelief * middle);
    if (static_cast<double>(q_max - q_min) > relief) return;  // more than one surface
    const float m = lower_median(differences.begin(), end);
    // Before what is too much for the noise is left out: a wrong scale may be more.
    if (static_cast<double>(std::abs(m)) < kRelief * middle) ratios_.push_back(m / static_cast<float>(middle));
    if (static_cast<double>(std::abs(m)) > other_surface) return;  // something nearer hides it now
    motion_.push_back((last_position - camera.template project<float>(last_ray)).norm());
    medians_.push_back(static_cast<float>(std::abs(m) / noise.prior_shared_sigma(middle)));
    if (!scatter) return;
    std::for_each(differences.begin(), end, [m](float& d) { d = std::abs(d - m); });
    scatters_.push_back(static_cast<float>(static_cast<double>(kSigmaOfMedian) *
                                           static_cast<double>(lower_median(differences.begin(), end)) /
                                           std::sqrt(2.0) / noise.prior_pixel_sigma(middle)));
  }

  int first_ = 0;  ///< patch of the first row
  std::vector<float> medians_, ratios_, scatters_, motion_;
};

DOT_END_NAMESPACE
