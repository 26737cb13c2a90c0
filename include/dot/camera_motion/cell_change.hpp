// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dot/image/image.hpp"
#include "dot/kernel/lanes.hpp"

DOT_BEGIN_NAMESPACE

/// How a cell of 4x4 pixels has changed between two images: the variance of the difference, with a shift and without
/// one.
struct CellChange {
  static constexpr int kSize = 4;  ///< pixels

  float shifted = 0;    ///< grey values squared
  float unshifted = 0;  ///< grey values squared

  /// Whether the shift explains most of it.
  bool is_explained() const { return 2 * shifted < unshifted; }
  /// Whether no shift explains it much better.
  bool is_contradicted() const { return shifted > 2 * unshifted; }

  /// @param counts 1 at the pixels that count, else 0; null: all count. @param column, row of the cell's first pixel.
  /// @param x, y where that pixel was before. The cell must have been wholly inside, with a pixel to the right and
  /// below.
  static CellChange between(const Image<std::uint8_t>& now, const Image<std::uint8_t>& before,
                            const Image<std::uint8_t>* counts, int column, int row, float x, float y) {
    using V = PortableLanes;  // a lane is a row of the cell
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const V::F right = V::set(x - static_cast<float>(left)), below = V::set(y - static_cast<float>(top));
    constexpr float kRows[kSize] = {0, 1, 2, 3};
    const V::I rows = V::muli(V::to_int(V::load(kRows)), V::seti(now.width()));
    Variance shifted, unshifted;
    for (int v = 0; v < kSize; v += V::W) {
      const Columns here(now, column, row + v, rows), there(before, column, row + v, rows);
      const Columns weights = counts ? Columns(*counts, column, row + v, rows) : Columns();
      const Columns above(before, left, top + v, rows), under(before, left, top + v + 1, rows);
      const Columns above_right(before, left + 1, top + v, rows), under_right(before, left + 1, top + v + 1, rows);
      for (int u = 0; u < kSize; ++u) {
        const V::F a = V::fma(right, V::sub(above_right.at[u], above.at[u]), above.at[u]);
        const V::F b = V::fma(right, V::sub(under_right.at[u], under.at[u]), under.at[u]);
        const V::F came_from = V::fma(below, V::sub(b, a), a);
        shifted.add(weights.at[u], V::sub(here.at[u], came_from));
        unshifted.add(weights.at[u], V::sub(here.at[u], there.at[u]));
      }
    }
    return {shifted.value(), unshifted.value()};
  }

 private:
  /// Four columns of an image, a lane for each row.
  struct Columns {
    PortableLanes::F at[4] = {PortableLanes::set(1), PortableLanes::set(1), PortableLanes::set(1),
                              PortableLanes::set(1)};
    Columns() = default;
    /// @param rows places of the rows' first pixels from the first one's.
    Columns(const Image<std::uint8_t>& image, int column, int row, PortableLanes::I rows) {
      using V = PortableLanes;
      const V::I pixels = V::gather4(image.row(row) + column, rows);
      at[0] = V::byte<0>(pixels), at[1] = V::byte<1>(pixels), at[2] = V::byte<2>(pixels), at[3] = V::byte<3>(pixels);
    }
  };

  struct Variance {
    using V = PortableLanes;
    V::F n = V::set(0), sum = V::set(0), squares = V::set(0);
    void add(V::F weight, V::F value) {
      const V::F weighted = V::mul(weight, value);
      n = V::add(n, weight), sum = V::add(sum, weighted), squares = V::fma(weighted, value, squares);
    }
    float value() const {
      const float count = V::sum(n), all = V::sum(sum);
      return count > 0 ? (V::sum(squares) - all * all / count) / count : 0;
    }
  };
};

DOT_END_NAMESPACE
