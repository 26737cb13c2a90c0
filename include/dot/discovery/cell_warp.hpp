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

  /// Moves cell (x, y) of inverse depth q by T.
  /// @return whether it is seen, a cell or more from the border. @param m where.
  bool operator()(const Camera& camera, const SE3f& T, int x, int y, float q, Moved& m) const {
    const Vector3<float> X = T.R * Vector3<float>(x_(x, y), y_(x, y), 1) + q * T.t;
    if (!(X.z() > 1e-3f)) return false;
    const Vector2<float> p = camera.template project<float>(X);
    if (!(p.x() >= 1 && p.y() >= 1 && p.x() < static_cast<float>(camera.width() - 2) &&
          p.y() < static_cast<float>(camera.height() - 2)))
      return false;
    m = {p.x(), p.y(), q / X.z()};
    return true;
  }

 private:
  Image<float> x_, y_;  ///< rays of the cells
};

DOT_END_NAMESPACE
