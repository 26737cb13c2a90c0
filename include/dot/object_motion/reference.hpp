// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "dot/camera_motion/camera_step.hpp"
#include "dot/motion/estimate.hpp"
#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// An object as a past frame shows it, with the motion of camera and object since then. `now` is the newest frame that
/// the object was followed to. While it is being followed to the current frame, that is the previous one.
struct ObjectReference {
  PointSet points;                                     ///< on the object, in that frame
  Vector3<double> centroid = Vector3<double>::Zero();  ///< of the points, camera axes of that frame, metres
  Matrix3<double> inertia = Matrix3<double>::Zero();   ///< of the points about it, see MotionEstimate
  Vector3<double> anchor = Vector3<double>::Zero();    ///< centre of its mask at its median depth; zero: no depth
  double slope_variance = 0;                           ///< of an unknown tilt, at its border, 1/m^2
  int area = 0;                                        ///< pixels of its mask with its depth
  double timestamp = 0;                                ///< seconds
  CameraSince camera;                                  ///< the camera's motion since then
  SE3d T_obj_now_ref;                                  ///< the object's points since then: camera and own motion

  /// Resets all to the defaults at this time, except `points`.
  void restart(double new_timestamp) {
    ObjectReference fresh;
    fresh.timestamp = new_timestamp;
    std::swap(fresh.points, points);
    *this = std::move(fresh);
  }

  /// Sets the centroid to the middle of the points, and their inertia.
  void set_centroid() {
    double x = 0, y = 0, q = 0;
    for (std::size_t i = 0; i < points.u.size(); ++i) x += points.x[i], y += points.y[i], q += points.q[i];
    const double n = points.size();
    centroid = Vector3<double>(x / n, y / n, 1) / (q / n);
    inertia = inertia_of(points, centroid);
  }
};

/// A reference and the frame that it is aligned to.
struct ReferencePair {
  const ObjectReference& reference;  ///< the past frame's part
  CameraSince camera;                ///< motion from the reference to that frame, `now`
  double seconds = 0;                ///< from the reference to that frame
};

DOT_END_NAMESPACE
