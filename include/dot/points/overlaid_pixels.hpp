// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// The pixels of an image that show something drawn over it, in squares of so many pixels.
class OverlaidPixels {
 public:
  /// Makes all pixels free. @param square side of a square, pixels; 0: there are no overlays.
  /// @param width, height of the image, squares.
  void set(int square, int width, int height) {
    square_ = square;
    if (square == 0) return;
    squares_.resize(width, height);
    squares_.fill(0);
    spans_.assign(static_cast<std::size_t>(height), Span{});
  }

  /// There are no overlays.
  void clear() noexcept { square_ = 0; }

  /// Adds a square and those beside it: a gradient takes in the pixels beside it.
  void add(int column, int row) {
    const int left = std::max(0, column - 1), right = std::min(squares_.width() - 1, column + 1);
    for (int v = std::max(0, row - 1); v <= std::min(squares_.height() - 1, row + 1); ++v) {
      Span& span = spans_[static_cast<std::size_t>(v)];
      span.first = std::min(span.first, left), span.last = std::max(span.last, right);
      for (int u = left; u <= right; ++u) squares_(u, v) = 1;
    }
  }

  /// Whether there are any.
  bool any() const { return square_ > 0; }

  /// Takes them out of a mask. @param x, y place of the mask in the image, pixels.
  void cut(int x, int y, ImageView<std::uint8_t> mask) const {
    if (!any() || mask.width < 1 || mask.height < 1) return;
    const int last_column = squares_.width() - 1, last_row = squares_.height() - 1;
    // Pixels beyond the last square are as that square.
    for (int row = std::min(y / square_, last_row); row <= std::min((y + mask.height - 1) / square_, last_row); ++row) {
      const int top = std::max(0, row * square_ - y);
      const int bottom = row == last_row ? mask.height : std::min(mask.height, (row + 1) * square_ - y);
      const std::uint8_t* squares = squares_.row(row);
      const Span& span = spans_[static_cast<std::size_t>(row)];
      const int end = std::min({(x + mask.width - 1) / square_, last_column, span.last});
      for (int column = std::max(std::min(x / square_, last_column), span.first); column <= end; ++column) {
        if (!squares[column]) continue;
        const int left = std::max(0, column * square_ - x);
        const int right = column == last_column ? mask.width : std::min(mask.width, (column + 1) * square_ - x);
        for (int v = top; v < bottom; ++v) std::memset(mask.row(v) + left, 0, static_cast<std::size_t>(right - left));
      }
    }
  }

 private:
  /// Of the overlaid squares of a row.
  struct Span {
    int first = std::numeric_limits<int>::max(), last = -1;
  };

  int square_ = 0;
  Image<std::uint8_t> squares_;  ///< non-zero: overlaid
  std::vector<Span> spans_;      ///< of each row
};

DOT_END_NAMESPACE
