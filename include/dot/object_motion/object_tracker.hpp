// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "dot/camera/settings.hpp"
#include "dot/camera_motion/camera_step.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/object_motion/belief.hpp"
#include "dot/object_motion/estimator.hpp"
#include "dot/object_motion/expected_depth.hpp"
#include "dot/object_motion/last_interval.hpp"
#include "dot/object_motion/object_motion.hpp"
#include "dot/object_motion/problem.hpp"
#include "dot/object_motion/workspace.hpp"
#include "dot/points/select_object.hpp"

DOT_BEGIN_NAMESPACE

/// The last interval: its two frames and the camera's motion between them.
struct Interval {
  const FrameData* prev = nullptr;  ///< used by `align_backwards` only; null if there is none, and in a replay
  const FrameData& cur;             ///< the current frame
  const CameraStep& camera;         ///< the camera's motion between the two
};

/// The places where masks show an object now. The fit of its motion may start there.
struct ObservedPlaces {
  const Observation* own = nullptr;   ///< the mask that was assigned to it
  const Observations* all = nullptr;  ///< without `own`: the masks without a track may show it
  bool discovered = false;            ///< whether to use the discovered ones of `all`; else the network's
};

/// Follows one object from frame to frame (paper, section 3.3, Algorithm 1). It keeps no state: the caller passes what
/// is known of the object and gets its motion over the last interval.
template <typename Camera, typename Noise, typename Aligner>
struct ObjectTracker {
  using Workspace = ObjectWorkspace<Aligner>;  ///< buffers of the thread that calls

  const Camera& camera;                    ///< of level 0
  const Noise& noise;                      ///< of the depth
  const ObjectMotionEstimator& estimator;  ///< finds and checks a motion
  const SelectionSettings& selection;      ///< of an object's points
  DepthSource depth_source;                ///< source of the depth
  const OverlaidPixels& overlaid;          ///< that give no points
  const kernel::Kernels& kernels;          ///< of the selection

  /// Finds T_o over the last interval, and the evidence of the reference that is most precise about the motion. The
  /// motion of a slow object is visible only against an older frame.
  /// @param motion, belief up to the previous frame. @param nearer non-zero where nearer objects were found already.
  ObjectStep follow(const ObjectMotion& motion, const ObjectBelief& belief, const ObservedPlaces& places,
                    const Interval& interval, ImageView<const std::uint8_t> nearer, Workspace& workspace) const;

  /// Aligns the current frame to the one before, for objects that no earlier mask explains. The masks of a new object
  /// begin here, but its pixels were mostly in view before. When an object goes behind something, nearly all that
  /// earlier masks show is hidden now, but the part in this mask was in view before.
  /// @param motion, belief up to the current frame.
  /// @return the fit, forwards, in the axes of the previous frame's camera; nothing if there is none.
  std::optional<ObjectFit> align_backwards(const ObjectMotion& motion, const ObjectBelief& belief,
                                           const Observation& observed, const Interval& interval,
                                           Workspace& workspace) const;

  /// Where the object can be in a frame, for a lidar; else unknown. @param T_then_now moves the object's points from
  /// where they are in `motion` to the axes of that frame's camera. @param timestamp of that frame, seconds.
  ExpectedDepth expected_depth(const ObjectMotion& motion, const SE3d& T_then_now, double timestamp) const;

  /// Fills a reference with the part of an object that a mask shows. @param centre of the mask. @param expected where
  /// the object can be; few depths elsewhere are of something else.
  /// @return why the mask is not enough, or None if it is.
  Reason make_reference(const FrameData& frame, const Mask& mask, const Vector3<double>& centre,
                        const ExpectedDepth& expected, Workspace& workspace, ObjectReference& r) const;

  /// Adds the current frame to the references and updates the object's middle. @param mask its visible part, or null.
  void remember(const FrameData& cur, const Mask* mask, Workspace& workspace, ObjectMotion& motion) const;

 private:
  static constexpr std::size_t kRecent = 3;           ///< references that are tried for the last interval
  static constexpr int kOlder = 3;                    ///< older references that may be more precise
  static constexpr int kOlderTop = 1;                 ///< coarsest level of their fits
  static constexpr std::ptrdiff_t kNearestMasks = 3;  ///< tried masks without a track; each costs an alignment
  static constexpr double kSamePixels = 0.5, kSameDepth = 0.01;  ///< closer starts are the same; share of depth
  static constexpr double kLeastSize = 0.3, kMostSize = 3.3;     ///< ratio of a mask's area to the reference's

  struct Following;

  void fit_last_interval(Following& f) const;
  void use_known_velocity(Following& f) const;
  void fit_older(Following& f) const;
  ObjectFit fit(const Following& f, const ReferencePair& pair, int coarsest = PointSet::kMaxLevels) const;
  void add_evidence(Following& f, const ReferencePair& pair, const ObjectFit& fit, const ObjectFit& last) const;
  KnownVelocity known_velocity(const Following& f, const ReferencePair& pair) const;
  void set_starts(const Following& f, const ReferencePair& pair) const;
  ReferencePair pair_with_current(const Following& f, const ObjectReference& r) const {
    return {r, r.camera.after(f.interval.camera), f.interval.cur.timestamp - r.timestamp};
  }
};

DOT_END_NAMESPACE

#include "dot/object_motion/impl/align_backwards.hpp"
#include "dot/object_motion/impl/follow.hpp"
#include "dot/object_motion/impl/remember.hpp"
