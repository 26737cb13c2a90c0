// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of object_motion/object_motion.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE void ObjectMotion::correct(const ObjectFit& fit, const SE3d& T_cur_prev) {
  const SE3d T_prev_cur = T_cur_prev.inverse();
  const SE3d correction = T_cur_prev * fit.T_o * step.T_o.inverse() * T_prev_cur;
  for (ObjectReference& r : references) r.T_obj_now_ref = correction * r.T_obj_now_ref;
  position_now = position_now.moved(correction);
  step.fit = fit;
  step.T_o = fit.T_o;
  T_o_now = T_cur_prev * step.T_o * T_prev_cur;
  has_T_o_now = true;
}

DOT_INLINE void ObjectMotion::advance(const CameraStep& camera, const SE3d& T_o_outline) {
  const SE3d& T_c = camera.T_cur_prev;
  for (ObjectReference& r : references) {
    r.camera = r.camera.after(camera);
    r.T_obj_now_ref = T_c * step.T_o * r.T_obj_now_ref;
  }
  position_now = position_now.moved(T_c * step.T_o);
  path.forget_after(step.astray_since);
  path.advance(T_c, T_o_outline);
  has_T_o_now = step.fit.ok();
  if (has_T_o_now) T_o_now = T_c * step.fit.T_o * T_c.inverse();
}

DOT_END_NAMESPACE
