// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of object_motion/object_tracker.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Noise, typename Aligner>
std::optional<ObjectFit> ObjectTracker<Camera, Noise, Aligner>::align_backwards(const ObjectMotion& motion,
                                                                                const ObjectBelief& belief,
                                                                                const Observation& observed,
                                                                                const Interval& interval,
                                                                                Workspace& workspace) const {
  if (!interval.camera.known()) return std::nullopt;
  const FrameData &cur = interval.cur, &prev = *interval.prev;
  ObjectReference& r = workspace.here;
  r.restart(cur.timestamp);
  if (make_reference(cur, observed.mask, observed.centre, expected_depth(motion, {}, cur.timestamp), workspace, r) !=
      Reason::None)
    return std::nullopt;
  const SE3d& T_c = interval.camera.T_cur_prev;
  const SE3d T_prev_cur = T_c.inverse();
  const Matrix6<double> Ad = T_prev_cur.adjoint();
  const AlignState& change = interval.camera.alignment.state;
  const CameraSince backwards = CameraSince{}.after(T_prev_cur, Ad * interval.camera.covariance * Ad.transpose(),
                                                    1 / change.gain, -change.offset / change.gain);
  const ReferencePair pair{r, backwards, interval.camera.seconds};
  const ObjectScene<Camera> scene{prev.pyramid, camera, prev.depth, {}};
  KnownVelocity known;  // backwards
  workspace.starts.clear();
  if (belief.knows_velocity()) {
    known = {-belief.velocity_now, belief.velocity_covariance, cur.timestamp - belief.last_fit};
    workspace.starts.push_back(T_c * motion.step.T_o.inverse() * T_prev_cur);
  }
  workspace.starts.push_back({});
  if (!belief.knows_velocity())
    estimator.search(pair, scene, noise, workspace.aligner, workspace.minima, workspace.starts);
  const ObjectFit fit = estimator.fit(pair, scene, workspace.starts, known, noise, workspace.aligner, workspace.minima);
  if (!fit.ok()) return std::nullopt;
  return fit.reversed(T_prev_cur);
}

DOT_END_NAMESPACE
