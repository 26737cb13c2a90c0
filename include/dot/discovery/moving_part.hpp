// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "dot/discovery/cell_evidence.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// The part of a discovered object's mask that its motion explains better than standing does. A region of the search
/// may contain things that stand beside the mover, and surfaces whose depth flickers.
class MovingPart {
 public:
  static constexpr float kMuch = 4;            ///< squared sigma: evidence of one cell that counts for itself
  static constexpr float kLittle = 1;          ///< squared sigma: least mean evidence of a cell that moves
  static constexpr double kComparable = 0.25;  ///< least share of the cells that can be compared
  static constexpr int kMinCells = 6;          ///< least number of cells that stand, of a mixed region
  static constexpr double kMixed = 0.1;        ///< least share of the decided cells that stand, of a mixed region
  static constexpr float kSurely = 240;        ///< squared sigma: evidence by intensity of a part that moves for sure
  static constexpr float kOtherPart = 0.25;    ///< least evidence of another part, relative to the largest

  CellEvidence evidence;  ///< filled by Discovery::compare

  /// Judges the evidence. @param contradicts (x, y) -> bool: whether a cell of the image contradicts a static scene.
  template <typename Contradicts>
  void find(Contradicts&& contradicts) {
    count();
    smooth(contradicts);
    find_parts();
  }

  /// Whether enough of it could be compared. It could not if its motion is too small in the image.
  bool is_comparable() const { return compared_ >= kComparable * cells_; }
  /// How sure the images make it that a part of it moves, 0 to 1. Depth alone is no evidence, because it may flicker.
  /// A small object has few cells; these are enough if each counts for itself.
  double certainty() const {
    const float enough = std::min(kSurely, kMuch * static_cast<float>(cells_));
    return enough > 0 ? std::clamp(most_ / enough, 0.f, 1.f) : 0;
  }
  /// Whether a part of it stands.
  bool is_mixed() const {
    return is_comparable() && standing_ >= kMinCells && standing_ >= kMixed * (moving_ + standing_);
  }

  /// Keeps what moves of the mask of the evidence, and what lies between: the middle of a uniform side looks the same
  /// when it moves along itself. Keeps all if nothing would be left.
  void cut(Mask& mask) {
    const int width = smoothed_.width(), height = smoothed_.height();
    rows_.assign(static_cast<std::size_t>(height), {});
    columns_.assign(static_cast<std::size_t>(width), {});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int p = part_(x, y);
        if (p == kNone || intensities_[static_cast<std::size_t>(p)] < kOtherPart * most_) continue;
        row(y).add(x);
        column(x).add(y);
      }
    fill_mask(
        {mask.x, mask.y, mask.width(), mask.height()},
        [&](int u, int v) {
          const int x = u / evidence.cell - evidence.x, y = v / evidence.cell - evidence.y;
          return mask.at(u, v) && row(y).contains(x) && column(x).contains(y) && smoothed_(x, y) > -kLittle;
        },
        kept_);
    if (!kept_.empty()) std::swap(mask, kept_);
  }

 private:
  static constexpr int kNone = -1;
  struct Range {
    int first = std::numeric_limits<int>::max(), last = -1;
    void add(int i) { first = std::min(first, i), last = std::max(last, i); }
    bool contains(int i) const { return i >= first && i <= last; }
  };
  Range& row(int y) { return rows_[static_cast<std::size_t>(y)]; }
  Range& column(int x) { return columns_[static_cast<std::size_t>(x)]; }

  bool is_compared(int x, int y) const { return evidence.references(x, y) > 0; }
  float mean_evidence(int x, int y) const { return evidence.total(x, y) / evidence.references(x, y); }

  void count() {
    cells_ = compared_ = moving_ = standing_ = 0;
    for (int y = 0; y < evidence.total.height(); ++y)
      for (int x = 0; x < evidence.total.width(); ++x) {
        cells_ += evidence.belongs(x, y);
        if (!is_compared(x, y)) continue;
        ++compared_;
        moving_ += mean_evidence(x, y) > kMuch;
        standing_ += mean_evidence(x, y) < -kMuch;
      }
  }

  /// The mean evidence of the 3x3 cells about each. A cell that cannot be compared although it has depth moves if it
  /// contradicts a static scene. One that does not may be background that the object has uncovered.
  template <typename Contradicts>
  void smooth(Contradicts&& contradicts) {
    const int width = evidence.total.width(), height = evidence.total.height();
    smoothed_.resize(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (!is_compared(x, y) && evidence.measured(x, y)) {
          smoothed_(x, y) = contradicts(evidence.x + x, evidence.y + y) ? kMuch : 0;
          continue;
        }
        float sum = 0, n = 0;
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
          for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
            if (is_compared(u, v)) sum += std::clamp(mean_evidence(u, v), -kMuch, kMuch), n += 1;
        smoothed_(x, y) = n > 0 ? sum / n : 0;
      }
  }

  /// Numbers the connected parts that move, and adds up the evidence by intensity of each.
  void find_parts() {
    const int width = smoothed_.width(), height = smoothed_.height();
    part_.resize(width, height);
    part_.fill(kNone);
    intensities_.clear();
    most_ = 0;
    const auto reach = [&](int x, int y, int p) {
      if (!part_.contains(x, y) || part_(x, y) != kNone) return;
      if (!evidence.belongs(x, y) || !(smoothed_(x, y) > kLittle)) return;
      part_(x, y) = p;
      front_.push_back({x, y});
    };
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int p = static_cast<int>(intensities_.size());
        reach(x, y, p);
        if (front_.empty()) continue;
        float sum = 0;
        while (!front_.empty()) {
          const auto [u, v] = front_.back();
          front_.pop_back();
          if (is_compared(u, v)) sum += evidence.intensity(u, v) / evidence.references(u, v);
          reach(u - 1, v, p), reach(u + 1, v, p), reach(u, v - 1, p), reach(u, v + 1, p);
        }
        intensities_.push_back(sum);
        most_ = std::max(most_, sum);
      }
  }

  int cells_ = 0, compared_ = 0, moving_ = 0, standing_ = 0;  ///< numbers of cells
  float most_ = 0;                                            ///< largest of `intensities_`
  Image<float> smoothed_;                                     ///< evidence about each cell, squared sigma
  Image<int> part_;                                           ///< number of the part that each cell belongs to
  std::vector<float> intensities_;                            ///< of each part, squared sigma
  std::vector<std::pair<int, int>> front_;                    ///< of the flood fill
  std::vector<Range> rows_, columns_;                         ///< of the parts that are kept
  Mask kept_;
};

DOT_END_NAMESPACE
