// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "dot/labels/labeller.hpp"
#include "dot/late_masks/awaited_frames.hpp"
#include "dot/tracks/tracks.hpp"

DOT_BEGIN_NAMESPACE

/// Handles masks that arrive after their frame. Keeps the frames whose masks may still arrive, and moves late masks to
/// the present.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
class LateMasks {
 public:
  using TracksT = Tracks<Camera, Classifier, Noise, Aligner>;  ///< the objects
  using Setup = typename TracksT::Setup;                       ///< the policies and settings

  /// The stages that process masks. The masks change their states.
  struct Stages {
    TracksT& tracks;                    ///< all objects
    Observations& observations;         ///< scratch for the masks
    Labeller<Camera, Noise>& labeller;  ///< makes the labels again
    const Setup& setup;                 ///< policies and settings
  };

  /// The frames that wait for their masks.
  const AwaitedFrames& frames() const { return frames_; }

  /// Moves all to the next frame. @param step led to that frame.
  void advance(const CameraStep& step) { frames_.advance(step); }

  /// Corrects the camera's motions between these frames. Must be called before `advance`.
  void revise(const std::vector<RevisedInterval>& revised) { frames_.revise(revised); }

  /// Keeps the newest frame while its masks may arrive: until they are too late, or masks of a later frame have
  /// arrived.
  /// @param segmented the frame came with masks.
  void await(const FramePtr& cur, const CameraStep& step, bool segmented, const MaskSettings& settings,
             const std::vector<Track*>& tracks);

  /// Applies the masks of a past frame, which `observations` has counted, and moves all tracks to the present with
  /// them.
  /// @pre lost tracks were dropped. @param then one of `frames`. @param now timestamp of the newest frame.
  void apply(AwaitedFrames::const_iterator then, const Masks& masks, double now, const Stages& stages);

  /// Forgets these frames.
  void clear() noexcept { frames_.clear(); }

 private:
  using Worker = typename TracksT::Worker;

  static SE3d T_now_then(const Track& t, const AwaitedFrame& then, double now);
  void recall(const AwaitedFrame& then, double now, const Stages& stages) const;
  void apply_late_mask(Track& t, const AwaitedFrame& then, double now, const Setup& setup, Worker& worker) const;
  void renew_reference(Track& t, const AwaitedFrame& then, const Mask& mask, const Vector3<double>& centre, double now,
                       const Setup& setup, Worker& worker) const;
  void replay(const std::vector<Track*>& started, const AwaitedFrame& then, const Stages& stages) const;

  AwaitedFrames frames_;
};

DOT_END_NAMESPACE

#include "dot/late_masks/impl/late_masks.hpp"
