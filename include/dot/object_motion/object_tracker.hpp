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
#include "dot/object_motion/last_interval.hpp"
#include "dot/object_motion/object_motion.hpp"
#include "dot/object_motion/workspace.hpp"
#include "dot/points/select_object.hpp"

DOT_BEGIN_NAMESPACE

/// The last interval: its two frames, and the camera's motion between them.
struct Interval {
  const FrameData* prev = nullptr;  ///< for `align_backwards` alone; null where there is none, and in a replay
  const FrameData& cur;
  const CameraStep& camera;
};

/// Where masks show an object now, for its motion to start from.
struct ObservedPlaces {
  const Observation* own = nullptr;   ///< the one that was assigned to it
  const Observations* all = nullptr;  ///< without that: those of them that are assigned to no track may be it
  bool discovered = false;            ///< of these, the discovered ones; else the network's
};

/// Follows one object from frame to frame (paper, section 3.3, Algorithm 1). It keeps nothing: what is known of the
/// object comes in, its motion over the last interval goes out.
template <typename Camera, typename Noise, typename Aligner>
struct ObjectTracker {
  using Workspace = ObjectWorkspace<Aligner>;

  const Camera& camera;
  const Noise& noise;
  const ObjectMotionEstimator& estimator;
  const SelectionSettings& selection;
  DepthSource depth_source;
  const kernel::Kernels& kernels;

  /// T_o over the last interval, and the evidence of the reference that tells most about the motion: a slow object
  /// shows only against an older frame.
  /// @param motion, belief up to the previous frame. @param nearer non-zero where nearer objects were found already.
  ObjectStep follow(const ObjectMotion& motion, const ObjectBelief& belief, const ObservedPlaces& places,
                    const Interval& interval, ImageView<const std::uint8_t> nearer, Workspace& workspace) const;

  /// The motion from the current frame back to the one before, for objects to which no earlier mask leads: of a new one
  /// masks begin here, its pixels mostly do not; of one that goes behind something nearly all that earlier masks show
  /// is hidden now, but what this one shows was in view.
  /// @param motion, belief up to the current frame.
  /// @return the fit, forwards, in the axes of the previous frame's camera; nothing where there is none.
  std::optional<ObjectFit> align_backwards(const ObjectMotion& motion, const ObjectBelief& belief,
                                           const Observation& observed, const Interval& interval,
                                           Workspace& workspace) const;

  /// Fills in what a mask shows of an object. @param centre of the mask.
  /// @return why that is not enough, None if it is.
  Reason make_reference(const FrameData& frame, const Mask& mask, const Vector3<double>& centre, Workspace& workspace,
                        ObjectReference& r) const;

  /// Adds the current frame to the references, and where the object's middle is. @param mask what is visible of it, or
  /// null.
  void remember(const FrameData& cur, const Mask* mask, Workspace& workspace, ObjectMotion& motion) const;

 private:
  static constexpr std::size_t kRecent = 3;                      ///< references that are tried for the last interval
  static constexpr int kOlder = 3;                               ///< that may tell more
  static constexpr std::ptrdiff_t kNearestMasks = 3;             ///< without a track, each of which costs an alignment
  static constexpr double kNearest = 0.05;                       ///< metres before the camera
  static constexpr double kSamePixels = 0.5, kSameDepth = 0.01;  ///< within which two starts are one; share of depth
  static constexpr double kLeastSize = 0.3, kMostSize = 3.3;     ///< of a mask's area, over that of the reference
  static constexpr double kWorthwhile = 3;  ///< times the least variance of an older fit, which it mostly reaches

  struct Following;

  void fit_last_interval(Following& f) const;
  void use_known_velocity(Following& f) const;
  void fit_older(Following& f) const;
  ObjectFit fit(const Following& f, const ReferencePair& pair) const;
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
