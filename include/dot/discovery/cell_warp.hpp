// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/camera/concept.hpp"
#include "dot/image/image.hpp"
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

  /// Moves all cells of row y by T, for `is_seen`. The loop has no branches, so that compilers generate SIMD code from
  /// it for simple cameras. @pre `prepare` was called. @param q their inverse depths, 1/m, 0 = none.
  void move_row(const Camera& camera, const SE3f& T, int y, const float* q) {
    const Matrix3<float> R = T.R;
    const Vector3<float> t = T.t;
    row_.resize(x_.width(), 3);
    const float *ray_x = x_.row(y), *ray_y = y_.row(y);
    float *u = row_.row(0), *v = row_.row(1), *z = row_.row(2);
    for (int x = 0; x < x_.width(); ++x) {
      const Vector3<float> X(R(0, 0) * ray_x[x] + R(0, 1) * ray_y[x] + R(0, 2) + t.x() * q[x],
                             R(1, 0) * ray_x[x] + R(1, 1) * ray_y[x] + R(1, 2) + t.y() * q[x],
                             R(2, 0) * ray_x[x] + R(2, 1) * ray_y[x] + R(2, 2) + t.z() * q[x]);
      const Vector2<float> p = camera.template project<float>(X);
      u[x] = p.x(), v[x] = p.y(), z[x] = X.z();
    }
  }
  /// Cell x of the row that was moved last. @param q its inverse depth, > 0.
  /// @return whether it is seen, a cell or more from the border. @param m where.
  bool is_seen(const Camera& camera, int x, float q, Moved& m) const {
    const float z = row_(x, 2);
    m = {row_(x, 0), row_(x, 1), q / z};
    return z > 1e-3f && is_inside(camera, m);
  }

  /// Change of the place by the inverse depth, cells metres, of cell (x, y) of inverse depth q moved by T.
  Vector2<float> by_inverse_depth(const Camera& camera, const SE3f& T, int x, int y, float q) const {
    Eigen::Matrix<float, 2, 3> J;
    camera.template project<float>(moved(T, x, y, q), &J);
    return J * T.t;
  }

  /// Moves cell (x, y) of inverse depth q by T.
  /// @return whether it is seen, a cell or more from the border. @param m where.
  bool operator()(const Camera& camera, const SE3f& T, int x, int y, float q, Moved& m) const {
    const Vector3<float> X = moved(T, x, y, q);
    if (!(X.z() > 1e-3f)) return false;
    const Vector2<float> p = camera.template project<float>(X);
    m = {p.x(), p.y(), q / X.z()};
    return is_inside(camera, m);
  }

 private:
  Vector3<float> moved(const SE3f& T, int x, int y, float q) const {
    return T.R * Vector3<float>(x_(x, y), y_(x, y), 1) + q * T.t;
  }
  static bool is_inside(const Camera& camera, const Moved& m) {
    return m.u >= 1 && m.v >= 1 && m.u < static_cast<float>(camera.width() - 2) &&
           m.v < static_cast<float>(camera.height() - 2);
  }

  Image<float> x_, y_;  ///< rays of the cells
  Image<float> row_;    ///< u, v and the depth over the former depth, of the row that was moved last
};

DOT_END_NAMESPACE
