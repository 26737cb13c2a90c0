// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <stdexcept>

#include "dot/camera/pinhole.hpp"

DOT_BEGIN_NAMESPACE

/// A camera with radial and tangential distortion, OpenCV's five-coefficient model. With x = X/Z, y = Y/Z, Z > 0,
/// r2 = x^2 + y^2 and g = 1 + k1 r2 + k2 r2^2 + k3 r2^3:
///
///     x_d = g x + 2 p1 x y + p2 (r2 + 2 x^2),   u = fx x_d + cx
///     y_d = g y + p1 (r2 + 2 y^2) + 2 p2 x y,   v = fy y_d + cy
///
/// Domain: the model is one-to-one only around the axis, as far as the determinant of d(x_d, y_d) / d(x, y) is positive
/// (without tangential part: while 1 + 3 k1 r2 + 5 k2 r2^2 + 7 k3 r2^3 > 0). Points farther away fold back into the
/// image, and pixels outside the projection of the domain have no ray. The results there are not valid. The domain of a
/// good calibration covers the whole image.
class RadTan {
 public:
  /// @param distortion k1, k2, p1, p2, k3: OpenCV's order.
  /// @throws std::invalid_argument naming the field that is out of range.
  RadTan(const Intrinsics& intrinsics, const std::array<double, 5>& distortion)
      : pinhole_(intrinsics), distortion_(distortion) {
    for (const double coefficient : distortion_)
      if (!std::isfinite(coefficient)) throw std::invalid_argument("distortion must be finite");
  }

  /// Pixel of X, Z > 0. Its derivative is diag(fx, fy) D [1/Z, 0, -x/Z; 0, 1/Z, -y/Z], with that of the distortion, D.
  template <typename S>
  Vector2<S> project(const Vector3<S>& X, Eigen::Matrix<S, 2, 3>* J = nullptr) const {
    const S fx = static_cast<S>(intrinsics().fx);
    const S fy = static_cast<S>(intrinsics().fy);
    const S inverse_z = S(1) / X.z();
    const Vector2<S> x(X.x() * inverse_z, X.y() * inverse_z);
    const Distorted<S> d = distort(x);
    if (J != nullptr) {
      const S a = fx * inverse_z;
      const S b = fy * inverse_z;
      *J << a * d.xx, a * d.xy, -a * (d.xx * x.x() + d.xy * x.y()),  //
          b * d.xy, b * d.yy, -b * (d.xy * x.x() + d.yy * x.y());
    }
    return {fx * d.x + static_cast<S>(intrinsics().cx), fy * d.y + static_cast<S>(intrinsics().cy)};
  }

  /// The ray through a pixel, z = 1, by Newton's method from the distorted point. From this start the iteration for a
  /// purely radial barrel or pincushion distortion converges from one side, without overshooting.
  template <typename S>
  Vector3<S> unproject(const Vector2<S>& pixel) const {
    constexpr int max_iterations = 20;
    const S tolerance = S(4) * Eigen::NumTraits<S>::epsilon();
    const Vector3<S> target = pinhole_.unproject(pixel);
    S x = target.x();
    S y = target.y();
    for (int i = 0; i < max_iterations; ++i) {
      const Distorted<S> d = distort(Vector2<S>(x, y));
      const S ex = target.x() - d.x;
      const S ey = target.y() - d.y;
      const S determinant = d.xx * d.yy - d.xy * d.xy;
      const S dx = (d.yy * ex - d.xy * ey) / determinant;
      const S dy = (d.xx * ey - d.xy * ex) / determinant;
      // At a fold, outside the domain, the step is not finite.
      if (!std::isfinite(dx) || !std::isfinite(dy)) break;
      x += dx;
      y += dy;
      if (std::abs(dx) + std::abs(dy) <= tolerance * (S(1) + std::abs(x) + std::abs(y))) break;
    }
    return {x, y, S(1)};
  }

  /// Whether p lies at least `border` pixels inside the outermost pixel centres.
  template <typename S>
  bool contains(const Vector2<S>& p, typename Vector2<S>::Scalar border) const {
    return pinhole_.contains(p, border);
  }

  /// The camera of a pyramid level. The distortion acts before the intrinsics, so it is unchanged.
  /// @throws std::invalid_argument when `level` is negative or the image has no pixel left there.
  RadTan at_level(int level) const {
    RadTan scaled = *this;
    scaled.pinhole_ = pinhole_.at_level(level);
    return scaled;
  }

  /// Columns of the image.
  int width() const { return pinhole_.width(); }
  /// Rows of the image.
  int height() const { return pinhole_.height(); }
  /// Those of the camera without its distortion.
  const Intrinsics& intrinsics() const { return pinhole_.intrinsics(); }
  /// k1, k2, p1, p2, k3.
  const std::array<double, 5>& distortion() const { return distortion_; }

 private:
  /// A distorted point and the derivative of the distortion there, which is symmetric.
  template <typename S>
  struct Distorted {
    S x, y;
    S xx, xy, yy;
  };

  template <typename S>
  Distorted<S> distort(const Vector2<S>& p) const {
    const S k1 = static_cast<S>(distortion_[0]);
    const S k2 = static_cast<S>(distortion_[1]);
    const S p1 = static_cast<S>(distortion_[2]);
    const S p2 = static_cast<S>(distortion_[3]);
    const S k3 = static_cast<S>(distortion_[4]);
    const S x = p.x();
    const S y = p.y();
    const S r2 = x * x + y * y;
    const S g = S(1) + r2 * (k1 + r2 * (k2 + r2 * k3));
    const S slope = k1 + r2 * (S(2) * k2 + r2 * S(3) * k3);  // dg / d(r2)
    return {g * x + S(2) * p1 * x * y + p2 * (r2 + S(2) * x * x), g * y + p1 * (r2 + S(2) * y * y) + S(2) * p2 * x * y,
            g + S(2) * slope * x * x + S(2) * p1 * y + S(6) * p2 * x, S(2) * (slope * x * y + p1 * x + p2 * y),
            g + S(2) * slope * y * y + S(6) * p1 * y + S(2) * p2 * x};
  }

  Pinhole pinhole_;
  std::array<double, 5> distortion_;
};

static_assert(is_camera_v<RadTan>, DOT_CAMERA_MESSAGE);

DOT_END_NAMESPACE
