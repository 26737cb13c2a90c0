// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Detects repeated images, also if a video codec has changed their noise. Drivers and conversions of the frame rate
/// repeat images.
///
/// In a repeated image nothing moves, not even what moved since the image before it. The change of the image is
/// compared by cells of a grid, each without the change a + b I of its light. What is left of d = I_now - I_before in a
/// cell gives a mean square, and the shift u that explains most of it, d = -g' u with the gradients g. An image is
/// repeated if nearly no cell has a shift beyond its noise, and nearly none changed by more than a quarter of what the
/// most changed ones did between images that were new.
class RepeatedImage {
 public:
  /// Whether an image repeats the one before. @param before null: that is not known.
  bool repeats(const Pyramid& now, const Pyramid* before) {
    if (!before || now.size() != before->size() || now.width() != before->width() || now.height() != before->height()) {
      usual_ = 0;
      return false;
    }
    if (same(now.levels[0], before->levels[0])) return true;
    const std::size_t level = now.size() > 1 ? 1 : 0;
    const float most = compare(now.levels[level], before->levels[level]);
    if (textured_ < kLeastTextured) {
      usual_ = 0;
      return false;
    }
    if (moving_ <= kFew && most < kOfUsual * usual_) return true;
    usual_ = most;
    return false;
  }

  /// Takes a repeated image as new: it stays for longer than any driver repeats it.
  void forget() { usual_ = 0; }

 private:
  static constexpr int kColumns = 16, kRows = 8;  ///< of the grid
  static constexpr int kRowStep = 4;              ///< each so-many-th row is compared
  static constexpr int kBlock = 16;               ///< pixels that SIMD code adds at once
  static constexpr float kCorrelated = 2;         ///< pixels beside each other whose noise is as of one
  static constexpr int kFew = 2;                  ///< cells that may be wrong
  static constexpr int kLeastTextured = 8;        ///< cells; less of an image tells nothing
  static constexpr float kOfUsual = 0.25f;        ///< share of the change between new images
  static constexpr short kLargest = 30;           ///< grey values; a change is not larger where an edge moved far
  static constexpr float kLeastShift = 0.03f;     ///< pixels of the level
  static constexpr float kLeastGradient = 2;      ///< grey values per pixel, root mean square of a cell with texture

  static bool same(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b) {
    const std::size_t size = static_cast<std::size_t>(a.width()) * static_cast<std::size_t>(a.height());
    return a.width() == b.width() && a.height() == b.height() && std::memcmp(a.row(0), b.row(0), size) == 0;
  }

  /// Sums over pixels: of I, of d, of twice the gradient g = (u, v), and of their products.
  struct Sums {
    int i = 0, ii = 0, d = 0, id = 0, dd = 0, uu = 0, uv = 0, vv = 0, ud = 0, vd = 0;
  };

  /// @param above, below the rows beside `before`. All begin at a pixel with one to its left, and go on after `n`.
  static Sums sum(const std::uint8_t* now, const std::uint8_t* above, const std::uint8_t* before,
                  const std::uint8_t* below, int n) {
    Sums s;
    for (int x = 0; x < n; ++x) {  // of 16 bits, and without branches, so that it becomes SIMD code
      const auto i = static_cast<short>(before[x]);
      const auto change = static_cast<short>(now[x] - before[x]);
      const short d = std::min<short>(kLargest, std::max<short>(-kLargest, change));
      const auto u = static_cast<short>(before[x + 1] - before[x - 1]);
      const auto v = static_cast<short>(below[x] - above[x]);
      s.i += i, s.ii += i * i, s.d += d, s.id += i * d, s.dd += d * d;
      s.uu += u * u, s.uv += u * v, s.vv += v * v, s.ud += u * d, s.vd += v * d;
    }
    return s;
  }

  struct Cell {
    float n = 0, i = 0, ii = 0, d = 0, id = 0, dd = 0, uu = 0, uv = 0, vv = 0, ud = 0, vd = 0;

    void add(const Sums& s, int pixels) {
      n += static_cast<float>(pixels);
      i += static_cast<float>(s.i), ii += static_cast<float>(s.ii), d += static_cast<float>(s.d);
      id += static_cast<float>(s.id), dd += static_cast<float>(s.dd);
      uu += 0.25f * static_cast<float>(s.uu), uv += 0.25f * static_cast<float>(s.uv);
      vv += 0.25f * static_cast<float>(s.vv);
      ud += 0.5f * static_cast<float>(s.ud), vd += 0.5f * static_cast<float>(s.vd);
    }
    bool has_texture() const { return uu + vv > kLeastGradient * kLeastGradient * n; }
    /// Sum of the squares of d without the light's change.
    float rest() const {
      const float variance = ii - i * i / n, covariance = id - i * d / n;
      return std::max(0.0f, dd - d * d / n - (variance > 0 ? covariance * covariance / variance : 0));
    }
    /// Mean square change.
    float change() const { return rest() / n; }
    /// Whether a shift explains the change by more than noise would.
    bool moves() const {
      const float det = uu * vv - uv * uv;
      if (!(det > 1e-3f * (uu + vv) * (uu + vv))) return false;
      const float u = (vv * ud - uv * vd) / det, v = (uu * vd - uv * ud) / det;
      const float explained = u * ud + v * vd, unexplained = std::max(0.0f, rest() - explained);
      return u * u + v * v > kLeastShift * kLeastShift &&
             explained * (n / kCorrelated - 2) > static_cast<float>(chi2::k5SigmaOf1) * unexplained;
    }
  };

  /// Sets the number of moving cells. @return the change of the most changed cells but a few.
  float compare(const Image<std::uint8_t>& now, const Image<std::uint8_t>& before) {
    std::array<Cell, kColumns * kRows> cells{};
    const int width = now.width(), height = now.height();
    for (int y = 1; y + 1 < height; y += kRowStep) {
      const std::uint8_t *above = before.row(y - 1), *here = before.row(y), *below = before.row(y + 1);
      Cell* row = cells.data() + (y * kRows / height) * kColumns;
      for (int column = 0; column < kColumns; ++column) {
        const int x = std::max(1, column * width / kColumns);
        int n = std::min(width - 1, (column + 1) * width / kColumns) - x;
        if (n > kBlock) n -= n % kBlock;
        if (n > 0) row[column].add(sum(now.row(y) + x, above + x, here + x, below + x, n), n);
      }
    }
    std::array<float, kColumns * kRows> changes{};
    textured_ = moving_ = 0;
    std::transform(cells.begin(), cells.end(), changes.begin(),
                   [](const Cell& cell) { return cell.has_texture() ? cell.change() : 0.0f; });
    for (const Cell& cell : cells) {
      textured_ += cell.has_texture();
      moving_ += cell.has_texture() && cell.moves();
    }
    std::nth_element(changes.begin(), changes.begin() + kFew, changes.end(), std::greater<>{});
    return changes[kFew];
  }

  float usual_ = 0;  ///< change of the most changed cells between the last two images that were new; 0: not known
  int textured_ = 0, moving_ = 0;  ///< cells of the last comparison
};

DOT_END_NAMESPACE
