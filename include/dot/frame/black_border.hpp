// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Fills the black border that undistortion, rotation or another aspect ratio leave about a picture. The picture's edge
/// has depth on its inner side, and stays where it is. With points on it, or near it on a coarse level, the camera
/// seems to stand. So the border gets the values of the picture's pixels in the same row or column.
///
/// The border is black without texture, has no depth, and reaches to an end of its row or column. Shadows can do so,
/// too. But they are ragged, and they move: the border's edge is straight over some rows or columns, and stays.
class BlackBorder {
 public:
  /// @param image level 0, is changed. @param inverse_depth of the same size. @param follows the frame before.
  /// @return whether there is a border.
  bool fill(Image<std::uint8_t>& image, const Image<float>& inverse_depth, bool follows) {
    const int width = image.width(), height = image.height();
    const auto fill_lines = [&](Side& side, int lines, int length,
                                auto&& place) {  // (x, y) of the i-th pixel of a line
      const auto is_border = [&](int line, int i) {
        const auto [x, y] = place(line, i);
        const auto [x0, y0] = place(line, 0);
        return image(x, y) <= kBlack && std::abs(image(x, y) - image(x0, y0)) <= kFlat && !(inverse_depth(x, y) > 0);
      };
      if (!side.measure(lines, length, is_border, follows)) return false;
      for (int line = 0; line < lines; ++line) {
        const int end = side.width(line);
        const auto [from_x, from_y] = place(line, end);
        for (int i = 0; i < end; ++i) {
          const auto [x, y] = place(line, i);
          image(x, y) = image(from_x, from_y);
        }
      }
      return true;
    };
    using PixelPlace = std::pair<int, int>;
    // The columns second: those beside the picture are wholly black until its rows are filled.
    bool any = fill_lines(left_, height, width, [](int y, int i) { return PixelPlace(i, y); });
    any |= fill_lines(right_, height, width, [=](int y, int i) { return PixelPlace(width - 1 - i, y); });
    any |= fill_lines(top_, width, height, [](int x, int i) { return PixelPlace(x, i); });
    any |= fill_lines(bottom_, width, height, [=](int x, int i) { return PixelPlace(x, height - 1 - i); });
    return any;
  }

 private:
  static constexpr int kBlack = 16;         ///< grey value of black in video of limited range
  static constexpr int kFlat = 3;           ///< grey values: noise of a codec
  static constexpr int kLeast = 3;          ///< pixels of a border
  static constexpr int kEdge = 6;           ///< pixels of the picture's edge: blur, interpolation, noise of a codec
  static constexpr int kStraight = 17;      ///< rows or columns
  static constexpr float kRagged = 1.5f;    ///< pixels from a straight line
  static constexpr float kSteepest = 1.2f;  ///< pixels a line; else the edge is measured along the other direction
  static constexpr int kMoved = 2;          ///< pixels by which the border's edge is another one
  static constexpr int kFrames = 10;        ///< in which it must have stayed, or in all so far

  /// The border at one side of the image. Its lines are rows or columns.
  class Side {
   public:
    /// @param length pixels of a line. @param is_border is_border(line, i): the i-th pixel from this side.
    /// @return whether there is any. A line that is wholly black has none.
    template <typename IsBorder>
    bool measure(int lines, int length, IsBorder&& is_border, bool follows) {
      runs_.resize(static_cast<std::size_t>(lines));
      follows = follows && places_.size() == runs_.size();
      places_.resize(runs_.size());
      if (!follows) stayed_.assign(runs_.size(), kFrames);
      std::fill(runs_.begin(), runs_.end(), 0);
      bool goes_on = true;
      for (int i = 0; i < length && goes_on; ++i) {  // all lines at once: columns are not contiguous
        goes_on = false;
        for (int line = 0; line < lines; ++line)
          if (run(line) == i && is_border(line, i)) ++run(line), goes_on = true;
      }
      for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (runs_[i] < kLeast || runs_[i] + kEdge >= length) runs_[i] = 0;
        const bool moved = std::abs(runs_[i] - places_[i]) > kMoved;
        if (follows) stayed_[i] = moved ? 0 : std::min(stayed_[i] + 1, kFrames);
        if (moved || !follows) places_[i] = runs_[i];
      }
      widths_.assign(runs_.size(), 0);
      bool any = false;
      for (std::size_t first = 0; first + kStraight <= runs_.size(); ++first) {
        if (!is_straight(first)) continue;
        any = true;
        for (std::size_t i = first; i < first + kStraight; ++i) widths_[i] = runs_[i] + kEdge;
      }
      return any;
    }

    /// Pixels of the border in a line, with the picture's edge.
    int width(int line) const { return widths_[static_cast<std::size_t>(line)]; }

   private:
    int& run(int line) { return runs_[static_cast<std::size_t>(line)]; }

    /// Whether the border's edge is straight over some lines, and has stayed there.
    bool is_straight(std::size_t first) const {
      constexpr std::size_t kSteps = kStraight - 1;
      const auto begin = static_cast<float>(runs_[first]), end = static_cast<float>(runs_[first + kSteps]);
      const float slope = (end - begin) / kSteps;
      if (std::abs(slope) > kSteepest) return false;
      for (std::size_t i = 0; i <= kSteps; ++i) {
        const int pixels = runs_[first + i];
        if (pixels == 0 || stayed_[first + i] < kFrames) return false;
        if (std::abs(begin + slope * static_cast<float>(i) - static_cast<float>(pixels)) > kRagged) return false;
      }
      return true;
    }

    std::vector<int> runs_;    ///< of each line: black pixels without depth from this side
    std::vector<int> places_;  ///< the same when it last moved
    std::vector<int> stayed_;  ///< of each line: frames for which its run has stayed, at most kFrames
    std::vector<int> widths_;  ///< of each line, see `width`
  };

  Side left_, right_, top_, bottom_;
};

DOT_END_NAMESPACE
