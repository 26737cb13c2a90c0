// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dot/camera/concept.hpp"

DOT_BEGIN_NAMESPACE

/// Checks intrinsics given by the user.
/// @throws std::invalid_argument naming the first field that is out of range.
inline void validate(const Intrinsics& camera) {
  const auto require = [](bool valid, const char* message) {
    if (!valid) throw std::invalid_argument(message);
  };
  // No lens exceeds these limits, and products of larger values would leave the range of a float.
  require(camera.fx >= 1 && camera.fx <= 1e6, "intrinsics.fx must be 1 to 1e6 pixels");
  require(camera.fy >= 1 && camera.fy <= 1e6, "intrinsics.fy must be 1 to 1e6 pixels");
  require(std::abs(camera.cx) <= 1e6, "intrinsics.cx must be finite, at most 1e6 pixels");
  require(std::abs(camera.cy) <= 1e6, "intrinsics.cy must be finite, at most 1e6 pixels");
  require(camera.width >= 16 && camera.width <= 32768, "intrinsics.width must be 16 to 32768");
  require(camera.height >= 16 && camera.height <= 32768, "intrinsics.height must be 16 to 32768");
  require(1.0 * camera.width * camera.height <= 1 << 28, "intrinsics.width times height must be at most 2^28 pixels");
  require(camera.baseline == 0 || (camera.baseline >= 1e-4 && camera.baseline <= 10),
          "intrinsics.baseline must be 0 or 1e-4 to 10 metres");
}

/// Intrinsics of a level of the pyramid of 2x2 means; a pixel u of level 0 is at (u + 0.5) / 2^level - 0.5 there.
/// @throws std::invalid_argument when `level` is negative or the image has no pixel left there.
inline Intrinsics at_level(const Intrinsics& camera, int level) {
  if (level < 0 || level > 30 || (std::min(camera.width, camera.height) >> level) == 0)
    throw std::invalid_argument("level must be >= 0 and leave at least one pixel");
  const double scale = 1.0 / static_cast<double>(1 << level);
  Intrinsics scaled = camera;
  scaled.fx = camera.fx * scale;
  scaled.fy = camera.fy * scale;
  scaled.cx = (camera.cx + 0.5) * scale - 0.5;
  scaled.cy = (camera.cy + 0.5) * scale - 0.5;
  scaled.width = camera.width >> level;
  scaled.height = camera.height >> level;
  return scaled;
}

/// A camera without distortion: u = fx X / Z + cx, v = fy Y / Z + cy, for Z > 0.
class Pinhole {
 public:
  /// @throws std::invalid_argument naming the field that is out of range.
  explicit Pinhole(const Intrinsics& intrinsics) : intrinsics_(intrinsics) { validate(intrinsics_); }

  /// Pixel of X, Z > 0. Its derivative is
  ///
  ///     [ fx/Z    0    -fx X/Z^2 ]
  ///     [   0   fy/Z   -fy Y/Z^2 ]
  template <typename S>
  Vector2<S> project(const Vector3<S>& X, Eigen::Matrix<S, 2, 3>* J = nullptr) const {
    const S fx = static_cast<S>(intrinsics_.fx);
    const S fy = static_cast<S>(intrinsics_.fy);
    const S inverse_z = S(1) / X.z();
    const S x = X.x() * inverse_z;
    const S y = X.y() * inverse_z;
    if (J != nullptr) {
      const S a = fx * inverse_z;
      const S b = fy * inverse_z;
      *J << a, S(0), -a * x, S(0), b, -b * y;
    }
    return {fx * x + static_cast<S>(intrinsics_.cx), fy * y + static_cast<S>(intrinsics_.cy)};
  }

  /// The ray ((u - cx) / fx, (v - cy) / fy, 1).
  template <typename S>
  Vector3<S> unproject(const Vector2<S>& pixel) const {
    return {(pixel.x() - static_cast<S>(intrinsics_.cx)) / static_cast<S>(intrinsics_.fx),
            (pixel.y() - static_cast<S>(intrinsics_.cy)) / static_cast<S>(intrinsics_.fy), S(1)};
  }

  /// Whether p lies at least `border` pixels inside the outermost pixel centres.
  template <typename S>
  bool contains(const Vector2<S>& p, typename Vector2<S>::Scalar border) const {
    return p.x() >= border && p.y() >= border && p.x() <= static_cast<S>(width() - 1) - border &&
           p.y() <= static_cast<S>(height() - 1) - border;
  }

  /// The camera of a pyramid level, which may be smaller than the constructor accepts.
  /// @throws std::invalid_argument when `level` is negative or the image has no pixel left there.
  Pinhole at_level(int level) const {
    Pinhole scaled = *this;
    scaled.intrinsics_ = dot::at_level(intrinsics_, level);
    return scaled;
  }

  /// Columns of the image.
  int width() const { return intrinsics_.width; }
  /// Rows of the image.
  int height() const { return intrinsics_.height; }
  /// Focal lengths, principal point, size and baseline.
  const Intrinsics& intrinsics() const { return intrinsics_; }

 private:
  Intrinsics intrinsics_;
};

static_assert(is_camera_v<Pinhole>, DOT_CAMERA_MESSAGE);

DOT_END_NAMESPACE
