// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"
#include "dot/motion/velocity_trust.hpp"
#include "dot/pipeline/object_motion.hpp"
#include "dot/pipeline/object_path.hpp"
#include "dot/pipeline/recycling_list.hpp"

DOT_BEGIN_NAMESPACE

/// Where something is, metres, if that is known.
struct Place {
  Vector3<double> at = Vector3<double>::Zero();
  bool known = false;

  /// The same in other axes, or after a motion; what is not known stays so.
  Place moved(const SE3d& T) const { return known ? Place{T * at, true} : Place{}; }
};

/// One object over time. `Memory` is the classifier's.
template <typename Memory>
struct Track {
  std::uint32_t id = 0;
  Memory memory{};
  bool always_dynamic = false;
  std::uint32_t instance_id = 0;
  std::int32_t class_id = -1;
  float score = 0;

  // Its outline: the last mask that a network gave, and where that is now.
  MaskTemplate outline;
  MaskTemplate hidden;             ///< what something nearer hid of it then
  SE3d T_cur_outline;              ///< composed motion of the object's points since then
  bool outline_is_newest = false;  ///< it is of the last frame that was segmented
  WarpedMask predicted;            ///< in this frame, by the predicted or the fitted motion
  SE3d predicted_by;               ///< the motion that `predicted` was made by, ...
  bool is_as_predicted = false;    ///< ... if that is the predicted one
  Mask mask;                       ///< what is shown in this frame
  const Mask* observed = nullptr;  ///< this frame's network mask, if one was associated; valid during `track`
  Vector3<double> observed_centre = Vector3<double>::Zero();  ///< of that mask, at its median depth; zero: no depth
  bool segmented = false;                                     ///< there was one
  bool discovered = false;                                    ///< found by its motion; no network mask so far
  bool candidate = false;  ///< of those, one that does not count as moving at present: not shown
  double confirmed = 0;    ///< of those, seconds with fits that agreed with the ones before, less those with others
  double support = 0;      ///< of those, share of the mask that contradicts a standing scene; smoothed
  bool visible = false;
  bool contradicted = false;  ///< the last segmentation did not show it where it should be seen

  // Its motion.
  RecyclingList<ObjectReference> references;  ///< newest first
  Reason no_reference = Reason::NoReference;  ///< why the last frame added none
  ObjectPath path;                            ///< since the frames whose masks may still come
  SE3d T_o_predicted;                         ///< constant velocity, previous camera's axes
  SE3d T_o;                                   ///< what carries the points: fit and known velocity, else as predicted
  SE3d T_o_outline;                           ///< what carries the outline: the same without the noise of its rotation
  SE3d T_o_last;                              ///< last accepted, seen from the newest camera: the prediction
  bool has_motion = false;                    ///< T_o_last is that of the interval before this one
  ObjectFit fit;                              ///< over the last interval
  MotionEstimate decisive;                    ///< of the reference that tells most
  bool has_decisive = false;
  State state = State::NotObservable;
  State last_decided = State::NotObservable;
  double p_moving = 0.5;
  Vector3<double> velocity = Vector3<double>::Zero();  ///< fused, newest camera's axes
  Matrix3<double> velocity_covariance = Matrix3<double>::Zero();
  VelocityTrust trust;    ///< in `velocity`
  double last_fit = 0;    ///< timestamp of the last that `velocity` follows
  Place position;         ///< of its middle, newest camera's axes
  Place position_before;  ///< in the frame before, its axes
  double size = 0;        ///< metres: root of the largest area that it has shown
  double last_seen = 0;   ///< timestamp
  bool followed = true;   ///< its motion is estimated: it is among the largest
  bool lost = false;      ///< to be dropped before the next frame

  /// Makes it a new object, in the memory of the one it was.
  void restart(std::uint32_t new_id) {
    outline.clear();
    hidden.clear();
    predicted.clear();
    mask.clear();
    references.clear();
    path.clear();
    Track fresh;
    fresh.id = new_id;
    std::swap(fresh.outline, outline);
    std::swap(fresh.hidden, hidden);
    std::swap(fresh.predicted, predicted);
    std::swap(fresh.mask, mask);
    std::swap(fresh.references, references);
    std::swap(fresh.path, path);
    *this = std::move(fresh);
  }

  /// Whether the classifier tells a velocity; some have none after a frame without a fit.
  bool has_velocity() const { return velocity_covariance.trace() > 0; }

  /// Whether `velocity` is known well enough to hold a fit against it.
  bool knows_velocity() const { return trust.known() && !always_dynamic && has_velocity(); }

  /// Whether it moves, and by its velocity alone would now be where it is but for a tenth of its size.
  bool goes_on_surely(double timestamp) const {
    return state == State::Moving && has_velocity() &&
           std::sqrt(velocity_covariance.trace()) * (timestamp - last_fit) < 0.1 * size;
  }

  bool is_shown() const { return visible && !lost && !candidate; }

  /// Whether its middle is known to be before the camera.
  bool is_ahead() const { return position.known && position.at.z() > 0; }

  /// Whether nothing of it is in view but what an earlier mask showed of it may come out.
  bool may_come_out() const { return !visible && !hidden.mask.empty() && !lost && !candidate && !contradicted; }

  /// m/s, newest camera's axes; zero unless it rather moves than stands.
  Vector3<double> expected_velocity() const {
    return state == State::Moving || p_moving > 0.5 ? velocity : Vector3<double>(Vector3<double>::Zero());
  }

  /// 1/m; nearer objects are followed first and painted last.
  double inverse_depth() const {
    if (!references.empty()) {
      const ObjectReference& r = references.front();
      const double z = (r.T_obj_cur_ref * r.centroid).z();
      if (z > 0) return 1 / z;
    }
    return outline.median;
  }
};

DOT_END_NAMESPACE
