// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/camera/concept.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/lanes.hpp"
#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Moves cells, the pixels of a coarse pyramid level, between frames.
template <typename Camera>
class CellWarp {
 public:
  /// Where a cell is seen.
  struct Moved {
    float u;  ///< column, cells
    float v;  ///< row, cells
    float q;  ///< inverse depth, 1/m
  };

  /// @param camera of the cells' level.
  void prepare(const Camera& camera) {
    if (x_.width() == camera.width() && x_.height() == camera.height()) return;
    y_.resize(camera.width(), camera.height());  // x_ comes last: its size shows that both are ready
    x_.resize(camera.width(), camera.height());
    for (int v = 0; v < camera.height(); ++v)
      for (int u = 0; u < camera.width(); ++u) {
        const Vector3<float> ray =
            camera.template unproject<float>(Vector2<float>(static_cast<float>(u), static_cast<float>(v)));
        x_(u, v) = ray.x();
        y_(u, v) = ray.y();
      }
  }

  /// Moves all cells of row y by T. @pre `prepare` was called. @param q their inverse depths, 1/m, 0 = none.
  void move_row(const Camera& camera, const SE3f& T, int y, const float* q) {
    const int width = x_.width();
    row_.resize(width, kRows);
    project_row(camera, T, width, x_.row(y), y_.row(y), q, row_.row(kColumn), row_.row(kRow), row_.row(kMovedQ));
    int done = 0;
    for (; done + PortableLanes::W <= width; done += PortableLanes::W) find_nearest<PortableLanes>(q, done);
    for (; done < width; ++done) find_nearest<ScalarLanes>(q, done);
  }
  /// Of cell x of the row that was moved last: the cell that it is at, as row * width + column, or -1 if it has no
  /// depth or is not seen a cell or more from the border.
  int nearest(int x) const { return static_cast<int>(row_(x, kNearest)); }
  /// Of the same: its inverse depth there, 1/m.
  float moved_q(int x) const { return row_(x, kMovedQ); }
  /// Where it is. @pre nearest(x) >= 0.
  Moved moved(int x) const { return {row_(x, kColumn), row_(x, kRow), row_(x, kMovedQ)}; }

  /// Change of the place by the inverse depth, cells metres, of cell (x, y) of inverse depth q moved by T.
  Vector2<float> by_inverse_depth(const Camera& camera, const SE3f& T, int x, int y, float q) const {
    Eigen::Matrix<float, 2, 3> J;
    camera.template project<float>(point(T, x, y, q), &J);
    return J * T.t;
  }

  /// Moves cell (x, y) of inverse depth q by T.
  /// @return whether it is seen, a cell or more from the border. @param m where.
  bool operator()(const Camera& camera, const SE3f& T, int x, int y, float q, Moved& m) const {
    const Vector3<float> X = point(T, x, y, q);
    if (!(X.z() > kNear)) return false;
    const Vector2<float> p = camera.template project<float>(X);
    m = {p.x(), p.y(), q / X.z()};
    return m.u >= 1 && m.v >= 1 && m.u < static_cast<float>(camera.width() - 2) &&
           m.v < static_cast<float>(camera.height() - 2);
  }

 private:
  static constexpr float kNear = 1e-3f;  ///< least depth over the depth before the motion

  Vector3<float> point(const SE3f& T, int x, int y, float q) const {
    return T.R * Vector3<float>(x_(x, y), y_(x, y), 1) + q * T.t;
  }
  /// Moves n cells of rays (x, y, 1) and inverse depths q to (u, v). z is the depth there over the depth here. The loop
  /// has no branches, so that compilers generate SIMD code from it for simple cameras.
  static void project_row(const Camera& camera, const SE3f& T, int n, const float* x, const float* y, const float* q,
                          float* __restrict u, float* __restrict v, float* __restrict z) {
    const Matrix3<float> R = T.R;
    const Vector3<float> t = T.t;
    for (int i = 0; i < n; ++i) {
      const Vector3<float> X(R(0, 0) * x[i] + R(0, 1) * y[i] + R(0, 2) + t.x() * q[i],
                             R(1, 0) * x[i] + R(1, 1) * y[i] + R(1, 2) + t.y() * q[i],
                             R(2, 0) * x[i] + R(2, 1) * y[i] + R(2, 2) + t.z() * q[i]);
      const Vector2<float> p = camera.template project<float>(X);
      u[i] = p.x(), v[i] = p.y(), z[i] = X.z();
    }
  }

  /// Sets kMovedQ, where the row has the depth over the former depth, and kNearest of V::W cells from x on.
  template <typename V>
  void find_nearest(const float* q, int x) {
    using F = typename V::F;
    const F one = V::set(1), half = V::set(0.5f), width = V::set(static_cast<float>(x_.width())),
            right = V::set(static_cast<float>(x_.width() - 2)), bottom = V::set(static_cast<float>(x_.height() - 2));
    float *u = row_.row(kColumn) + x, *v = row_.row(kRow) + x, *z = row_.row(kMovedQ) + x;
    const F column = V::load(u), row = V::load(v), depth = V::load(z), before = V::load(q + x);
    const auto inside = V::both(V::both(V::not_less(column, one), V::less(column, right)),
                                V::both(V::not_less(row, one), V::less(row, bottom)));
    const auto seen = V::both(inside, V::both(V::less(V::set(0), before), V::less(V::set(kNear), depth)));
    const auto rounded = [&](F place) { return V::to_float(V::to_int(V::add(V::keep(seen, place), half))); };
    const F place = V::fma(rounded(row), width, rounded(column));
    V::store(z, V::div(before, depth));
    V::store(row_.row(kNearest) + x, V::sub(V::keep(seen, V::add(place, one)), one));
  }

  /// Rows of `row_`. Places are exact as floats up to 2^24 cells.
  enum : int { kColumn, kRow, kMovedQ, kNearest, kRows };

  Image<float> x_, y_;  ///< rays of the cells
  Image<float> row_;    ///< the row that was moved last
};

DOT_END_NAMESPACE
