// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/lanes.hpp"

DOT_BEGIN_NAMESPACE

/// Tells whether depth and image are of the same frame: the left and right ends of near things in the depth are edges
/// of the image. On some rows, the strength of the image's edges around each such end is summed up for each lag between
/// the two, over the frames. It has a peak at the true lag alone, once camera or things have moved.
class DepthStep {
 public:
  static constexpr int kMaxLag = 2;     ///< frames
  static constexpr int kMaxOffset = 8;  ///< pixels
  static constexpr int kRowStep = 8;    ///< pixels from row to row

  /// The next frame, at the same level of the pyramids.
  /// @param least_jump 1/m; smaller steps of the inverse depth are noise.
  void add(const Image<std::uint8_t>& image, const Image<float>& inverse_depth, float least_jump) {
    if (image.width() != width_ || image.height() != height_) resize(image.width(), image.height());
    if (image.width() < 2 * (kMargin + 1)) return;
    newest_ = (newest_ + 1) % kFrames;
    Frame& now = frames_[newest_];
    keep_rows(image, inverse_depth, least_jump, now);
    count_ = std::min(count_ + 1, kFrames);
    for (auto& of_lag : sums_)
      for (Sum& sum : of_lag) sum.fade();
    compare(now, now, 0);
    for (std::size_t lag = 1; lag < count_; ++lag) {
      const Frame& then = frames_[(newest_ + kFrames - lag) % kFrames];
      compare(now, then, static_cast<int>(lag));
      compare(then, now, -static_cast<int>(lag));
    }
  }

  /// Frames by which the depth is late; 0 if it is in step, or if that cannot be told.
  int lag() const {
    constexpr double kEdges = 1500;   // ends of things: fewer say little
    constexpr double kClearly = 1.4;  // over the peak of no lag, and over those of all others
    constexpr double kHigh = 0.2;     // of the mean strength of edges
    double heights[2 * kMaxLag + 1];
    for (int lag = -kMaxLag; lag <= kMaxLag; ++lag) heights[lag + kMaxLag] = height(lag);
    int best = 0;
    for (int lag = -kMaxLag; lag <= kMaxLag; ++lag)
      if (heights[lag + kMaxLag] > heights[best + kMaxLag]) best = lag;
    const double highest = heights[best + kMaxLag];
    if (best == 0 || highest < kHigh || sums_[index(best, kMaxLag)][0].edges < kEdges) return 0;
    for (int lag = -kMaxLag; lag <= kMaxLag; ++lag)
      if (lag != best && highest < kClearly * heights[lag + kMaxLag]) return 0;
    return best;
  }

  /// Frames are not consecutive any more.
  void clear() noexcept {
    count_ = 0;
    for (auto& of_lag : sums_)
      for (Sum& sum : of_lag) sum = {};
  }

  /// Number of pixels in the last frame's sampled rows.
  int pixels() const { return pixels_; }
  /// Number of those that have depth.
  int measured() const { return measured_; }
  /// Mean inverse depth of these, 1/m.
  double mean_inverse_depth() const { return measured_ > 0 ? inverse_sum_ / measured_ : 0; }

 private:
  static constexpr std::size_t kFrames = kMaxLag + 1;
  static constexpr std::size_t kMostEdges = 1024;  ///< of a frame and a side
  static constexpr int kSurroundings = 16;         ///< pixels whose edges are those to compare with
  static constexpr int kMargin = kSurroundings + 1;
  static constexpr int kBlock = 4 * PortableLanes::W;  ///< pixels that are looked at at once
  static constexpr int kLargestHole = 12;              ///< pixels without depth at the end of a thing

  struct Edge {
    std::uint16_t row, x;
  };
  struct Frame {
    std::vector<std::uint8_t> rows;  ///< sampled ones of the image, one after the other
    std::vector<Edge> ends[2];       ///< left, right
  };
  struct Sum {
    std::array<double, 2 * kMaxOffset + 1> strength{};
    double edges = 0;

    void fade() {
      constexpr double kKept = 0.98;  // of what a frame has said, with the next one
      for (double& s : strength) s *= kKept;
      edges *= kKept;
    }
  };

  void resize(int width, int height) {
    width_ = width, height_ = height;
    clear();
    for (Frame& frame : frames_)
      for (auto& ends : frame.ends) ends.reserve(kMostEdges);
  }

  void keep_rows(const Image<std::uint8_t>& image, const Image<float>& inverse_depth, float least_jump, Frame& out) {
    out.rows.clear();
    out.ends[0].clear(), out.ends[1].clear();
    pixels_ = measured_ = 0;
    inverse_sum_ = 0;
    int row = 0;
    for (int y = kRowStep / 2; y < height_; y += kRowStep, ++row) {
      out.rows.insert(out.rows.end(), image.row(y), image.row(y) + width_);
      find_ends(inverse_depth.row(y), row, least_jump, out);
    }
  }

  /// A hole belongs to what is farther away: a second camera, or a projector, does not see it.
  void find_ends(const float* q, int row, float least_jump, Frame& out) {
    constexpr float kJump = 0.15f;  // of the nearer surface's inverse depth
    int last = -1, rough = 1;       // up to `rough` there is a step or a hole
    pixels_ += width_;
    for (int x = 0; x < width_; ++x) {
      if (x >= rough && last == x - 1) {
        x += smooth_pixels(q, x, least_jump, kJump);
        last = x - 1, rough = x + kBlock;
        if (x == width_) return;
      }
      if (q[x] <= 0) continue;
      ++measured_;
      inverse_sum_ += static_cast<double>(q[x]);
      if (last >= 0 && x - last <= kLargestHole && x >= kMargin + kMaxOffset && x + kMargin + kMaxOffset < width_) {
        const float step = q[x] - q[last], needed = std::max(least_jump, kJump * std::max(q[x], q[last]));
        if (step > needed) add_end(out.ends[0], row, x);
        if (-step > needed) add_end(out.ends[1], row, last);
      }
      last = x;
    }
  }

  /// Counts and sums up blocks of pixels from x on that all have depth, and no step, after one that has depth.
  /// @return their number.
  int smooth_pixels(const float* q, int first, float least_jump, float jump) {
    using V = PortableLanes;
    V::F sum = V::set(0);
    int x = first;
    for (; x + kBlock <= width_; x += kBlock) {
      V::F of_block = V::set(0);
      V::M smooth = V::less(V::set(-1), V::set(0));
      for (int i = x; i < x + kBlock; i += V::W) {
        const V::F now = V::load(q + i), before = V::load(q + i - 1);
        const V::F needed = V::max(V::set(least_jump), V::mul(V::set(jump), V::max(now, before)));
        const V::M is_step = V::less(needed, V::abs(V::sub(now, before)));
        smooth = V::both(smooth, V::without(V::less(V::set(0), now), is_step));
        of_block = V::add(of_block, now);
      }
      if (V::count(smooth) < V::W) break;
      sum = V::add(sum, of_block);
    }
    measured_ += x - first;
    inverse_sum_ += static_cast<double>(V::sum(sum));
    return x - first;
  }
  static void add_end(std::vector<Edge>& ends, int row, int x) {
    if (ends.size() < kMostEdges && x >= kMargin + kMaxOffset)
      ends.push_back({static_cast<std::uint16_t>(row), static_cast<std::uint16_t>(x)});
  }

  /// Index of a value from -most to most.
  static std::size_t index(int value, int most) {
    const int from_zero = value + most;
    return static_cast<std::size_t>(from_zero);
  }

  /// Adds the image's edges at the ends of things in the depth.
  void compare(const Frame& depth, const Frame& image, int lag) {
    for (std::size_t side = 0; side < 2; ++side) {
      Sum& sum = sums_[index(lag, kMaxLag)][side];
      for (const Edge& end : depth.ends[side]) {
        const std::uint8_t* row = image.rows.data() + static_cast<std::size_t>(end.row * width_ + end.x);
        int strengths[2 * kSurroundings + 1], total = 0;
        for (int i = -kSurroundings; i <= kSurroundings; ++i)
          total += strengths[i + kSurroundings] = std::abs(row[i + 1] - row[i - 1]);
        constexpr float kNoise = 2;  // grey values
        const float mean = static_cast<float>(total) / (2 * kSurroundings + 1) + kNoise;
        for (int o = -kMaxOffset; o <= kMaxOffset; ++o)
          sum.strength[index(o, kMaxOffset)] += std::min(3.0f, static_cast<float>(strengths[o + kSurroundings]) / mean);
        sum.edges += 1;
      }
    }
  }

  /// Highest strength over the mean one, both sides together.
  double height(int lag) const {
    double height = 0;
    for (const Sum& sum : sums_[index(lag, kMaxLag)]) {
      if (sum.edges <= 0) continue;
      double total = 0, highest = 0;
      for (const double s : sum.strength) total += s, highest = std::max(highest, s);
      height += (highest - total / static_cast<double>(sum.strength.size())) / sum.edges;
    }
    return height;
  }

  int width_ = 0, height_ = 0;
  std::array<Frame, kFrames> frames_;
  std::size_t newest_ = 0, count_ = 0;
  std::array<std::array<Sum, 2>, 2 * kMaxLag + 1> sums_{};
  int pixels_ = 0, measured_ = 0;
  double inverse_sum_ = 0;
};

DOT_END_NAMESPACE
