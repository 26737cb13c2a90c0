// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "dot/containers/recycling_list.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/motion/place.hpp"
#include "dot/object_motion/fit.hpp"
#include "dot/object_motion/object_path.hpp"
#include "dot/object_motion/reference.hpp"

DOT_BEGIN_NAMESPACE

/// One object's motion over the last interval. Motions are in the axes of the previous frame's camera.
struct ObjectStep {
  ObjectFit fit;              ///< of the interval, or the reason why there is none
  SE3d T_o;                   ///< moves the points: fit and known velocity, else the prediction
  SE3d T_o_outline;           ///< moves the outline: the same without the noise of its rotation
  MotionEstimate evidence;    ///< of the most precise reference, if there is one
  bool has_evidence = false;  ///< whether there is one
  /// Timestamp since which its predicted places were wrong. It is that of the older reference that found it again.
  double astray_since = std::numeric_limits<double>::infinity();
};

/// One object's motion so far. `now` is the newest frame that the object was followed to.
struct ObjectMotion {
  RecyclingList<ObjectReference> references;  ///< newest first
  Reason no_reference = Reason::NoReference;  ///< why the last frame added none
  ObjectPath path;                            ///< since the frames whose masks may still arrive
  SE3d T_o_now;                               ///< last accepted T_o, in the axes of `now`
  bool has_T_o_now = false;                   ///< whether `T_o_now` is of the last interval
  Place position_now;                         ///< of its middle
  double size = 0;                            ///< metres: root of the largest area that it has shown
  ObjectStep step;                            ///< the step that led to `now`
  MotionEstimate doubted;                     ///< a first motion that was refused, axes of the frame that it led to
  double doubted_at = -std::numeric_limits<double>::infinity();  ///< timestamp of that frame

  /// Drops all references, because they are no longer valid.
  void forget_references(Reason reason) {
    references.clear();
    no_reference = reason;
  }

  /// Forgets all motions, and the references before a time, because the camera's motion since them was wrong.
  void forget_before(double time) {
    drop_older_references(time, 0);
    path.clear();
    has_T_o_now = false;
    doubted_at = -std::numeric_limits<double>::infinity();
  }

  /// Drops the references that are older than so many seconds.
  void drop_older_references(double timestamp, double seconds) {
    while (!references.empty() && timestamp - references.back().timestamp > seconds + kClockError)
      references.pop_back();
  }

  /// Replaces the fit of the last interval after `advance`. All that `step.T_o` moved is moved by the new fit instead.
  void correct(const ObjectFit& fit, const SE3d& T_cur_prev);

  /// Moves everything into the current frame by `step`. @param T_o_outline motion of the outline.
  void advance(const CameraStep& camera, const SE3d& T_o_outline);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/object_motion.hpp"
#endif
