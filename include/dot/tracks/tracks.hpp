// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/discovery/discovery.hpp"
#include "dot/mask/painted_image.hpp"
#include "dot/motion/classifier.hpp"
#include "dot/object_motion/first_fit.hpp"
#include "dot/object_motion/object_tracker.hpp"
#include "dot/tracks/assignment.hpp"
#include "dot/tracks/mask_parts.hpp"
#include "dot/tracks/setup.hpp"
#include "dot/tracks/track.hpp"

DOT_BEGIN_NAMESPACE

/// All objects: their identities from frame to frame, and the steps of each. A frame calls, in this order, `prepare`,
/// `drop_lost`, `predict`, `assign`, `follow`, `update_masks` and, after its labels are made, `remember`.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
class Tracks {
 public:
  using Setup = TrackingSetup<Camera, Classifier, Noise>;  ///< the policies and settings
  using List = std::vector<Track*>;                        ///< tracks, borrowed

  /// Buffers of a thread.
  struct Worker {
    ObjectWorkspace<Aligner> object;    ///< of motions
    OutlineWorkspace outline;           ///< of outlines
    MovingPart moving_part;             ///< of a discovered object
    PaintedImage<std::uint8_t> nearer;  ///< where objects are that are nearer than the one that is followed
    std::size_t painted = 0;            ///< so many were looked at, the nearest first
    int round = 0;                      ///< in which those known were painted
    std::uint32_t painted_for = 0;      ///< Track::part_of of the one that was followed
  };

  /// The tracker of one object. @param noise may differ from the setup's. All arguments are borrowed.
  static ObjectTracker<Camera, Noise, Aligner> tracker(const Setup& setup, const Noise& noise) {
    return {setup.camera, noise, setup.estimator, setup.selection, setup.depth_source, setup.overlaid, setup.kernels};
  }

  /// Creates one worker per thread, each with a copy of the aligner.
  void prepare(const Aligner& aligner, const Threads& threads);

  /// All tracks, by id; valid until the next call of this, `assign`, `update_masks` or `far_to_near`.
  const List& all() {
    return that([](const Track&) { return true; });
  }
  /// Number of tracks.
  std::size_t size() const { return tracks_.size(); }
  /// The points of a past frame on the objects that a network showed; valid until the next call, or until `remember`.
  const std::vector<const PointSet*>& points_of(double timestamp);
  /// The buffers of each thread.
  std::vector<Worker>& workers() { return workers_; }

  /// Predicts the places of `tracks` in the current frame at constant velocity.
  void predict(const List& tracks, const Interval& interval, const Setup& setup);
  /// The same for one track. Several may run at once, with different workers.
  void predict(Track& track, const Interval& interval, const Setup& setup, Worker& worker) const;

  /// Assigns the observations of the current frame to the tracks that they continue.
  void assign(Observations& observations, const Setup& setup);

  /// Estimates motions and states of `tracks` (Algorithm 1 of the paper, with `continue` instead of `break`). The
  /// nearest comes first, because it hides parts of the others. Objects are followed in parallel, but for those that
  /// may be hidden by one without a mask of a network.
  /// @param observations those without a track may show one of `tracks`.
  void follow(const List& tracks, const Interval& interval, const Observations& observations, const Setup& setup);

  /// Sets the masks of the current frame: the observation if there is one, otherwise the outline moved by T_c T_o. An
  /// observation that no track explains, now that the motions are known, becomes a new track.
  /// @param frame the current one. @param segmented there are masks of a network for it.
  /// @return how many of these were too small to start a track.
  int update_masks(const Interval& interval, const FramePtr& frame, bool segmented, Observations& observations,
                   const Discovery<Camera, Noise>& discovery, const Setup& setup);

  /// Adds the current frame to a track's references.
  void remember(Track& track, const FrameData& cur, const Setup& setup, Worker& worker) const;

  /// Starts tracks for observations that have none, and chooses which tracks are followed.
  /// @return how many instances of a network were too small.
  int start(Observations& observations, const Setup& setup);

  /// Continues hidden tracks with observations that have no track.
  void find_again(Observations& observations, const MaskSettings& settings) {
    assignment_.by_place(that([](const Track& t) { return !t.is_part(); }), observations, settings);
  }

  /// The tracks that are shown or may come out, far to near. Predicted masks come before those of a network, so that
  /// the latter are painted on top. Valid until the next call.
  const List& far_to_near();

  /// Drops the tracks that were lost in the frame before.
  void drop_lost() {
    for (Track& t : tracks_)
      if (t.lost) t.outline.release_frame();
    tracks_.drop_if([](const Track& t) { return t.lost; });
  }
  /// Forgets all references, so that no earlier frame is compared with. The ids are kept.
  void forget_references();
  /// Forgets the beliefs, and the references before a time, because the camera's motions before it were wrong.
  void forget_motions(double before);
  /// Drops all tracks. Ids are not used again.
  void clear() noexcept {
    for (Track& t : tracks_) t.outline.release_frame();
    tracks_.clear();
  }

 private:
  static constexpr int kReach = 32;  ///< pixels; even a small object may move so far unexpectedly

  /// A track with the classifier's memory of it.
  struct ClassifiedTrack : Track {
    typename Classifier::Memory memory{};
  };

  template <typename Condition>
  const List& that(Condition&& condition);
  static CameraStep step_of_rows(const Track& t, const CameraStep& camera, int height);
  void follow(Track& t, const Interval& interval, const Observations& observations, const Setup& setup,
              Worker& worker) const;
  static bool is_out_of_sight(const Track& t, const Observations& observations);
  void choose_first_fit(Track& t, const Interval& interval, const Setup& setup, Worker& worker) const;
  static bool refuses(ObjectMotion& motion, const ObjectFit& first, const Interval& interval, const Setup& setup);
  void decide(Track& t, const FrameData& cur, const Matrix3<double>& R_cur_fit, double seconds, double dt,
              const Setup& setup) const;
  void examine(Track& t, double seconds, const Discovery<Camera, Noise>& discovery, const Setup& setup,
               Worker& worker) const;
  void update_mask(Track& t, const Interval& interval, const FramePtr& frame, bool segmented,
                   const Discovery<Camera, Noise>& discovery, const Setup& setup, Worker& worker) const;
  void align_backwards(Track& t, const Interval& interval, const Setup& setup, Worker& worker) const;
  void paint_nearer(std::size_t object, int width, int height, Worker& worker) const;
  static bool may_hide(const Track& nearer, const Track& hidden);
  static bool may_touch(const Track& a, const Track& b);
  void start_with(Observation& o);
  void divide_masks(Observations& observations, const Setup& setup);
  void choose_followed(int most);
  void drop_surplus(std::size_t most);

  RecyclingList<ClassifiedTrack> tracks_;  ///< in the order of ids
  std::uint32_t next_id_ = 1;

  std::vector<Worker> workers_;
  Assignment assignment_;
  MaskParts parts_;
  Vector3<double> camera_velocity_ = Vector3<double>::Zero();  ///< m/s, axes of the newest frame
  List selected_;                                              ///< result of `that`
  std::vector<const PointSet*> points_;                        ///< result of `points_of`
  List order_;                                                 ///< nearest first
  std::vector<int> rounds_;                                    ///< for each in `order_`: the round that follows it
  std::vector<std::size_t> at_once_;                           ///< places in `order_` of one round
};

DOT_END_NAMESPACE

#include "dot/tracks/impl/follow.hpp"
#include "dot/tracks/impl/update_masks.hpp"
