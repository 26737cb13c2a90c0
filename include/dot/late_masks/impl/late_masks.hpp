// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

/// @file
/// Definitions of late_masks/late_masks.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::await(const FramePtr& cur, const CameraStep& step, bool segmented,
                                                          const MaskSettings& settings,
                                                          const std::vector<Track*>& tracks) {
  if (segmented || !(settings.late_seconds > 0)) {
    frames_.clear();
    for (Track* t : tracks) t->motion.path.clear();
    return;
  }
  frames_.add(cur, step, settings.late_seconds, settings.late_frames);
  for (Track* t : tracks) t->motion.path.add(cur->timestamp, frames_.begin()->timestamp());
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::apply(AwaitedFrames::const_iterator found, const Masks& masks,
                                                          double now, const Stages& stages) {
  const AwaitedFrame& then = *found;
  const Setup& setup = stages.setup;
  recall(then, now, stages);
  stages.observations.clear();
  stages.observations.read(masks, then.frame->inverse_depth(), setup.camera, setup.noise);
  stages.tracks.assign(stages.observations, setup);
  stages.tracks.find_again(stages.observations, setup.mask);
  const std::size_t known = stages.tracks.size();
  stages.tracks.start(stages.observations, setup);

  for (Track* t : stages.tracks.all()) {
    t->outline.mask = t->newest_mask();
    t->outline.visible = t->observed || t->outline.mask.area >= setup.mask.min_pixels;
  }
  stages.labeller.set_segmented(stages.tracks.far_to_near(), then.frame, then.since, then.since_known);

  std::vector<Track*> started = stages.tracks.all();
  Worker& worker = stages.tracks.workers()[0];
  for (std::size_t i = 0; i < known; ++i) apply_late_mask(*started[i], then, now, setup, worker);
  started.erase(started.begin(), started.begin() + static_cast<std::ptrdiff_t>(known));
  if (!started.empty()) replay(started, then, stages);
  frames_.drop_through(found);
}

/// Moves the tracks back to that frame by their motions as known now.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::recall(const AwaitedFrame& then, double now,
                                                           const Stages& stages) const {
  for (Track* t : stages.tracks.all()) {
    const SE3d T_then_now = T_now_then(*t, then, now).inverse();
    t->observed = nullptr;
    t->expected = t->motion.position_now.moved(T_then_now);
    t->outline.warp_by(T_then_now * t->outline.T_now_shape, then.frame->inverse_depth(), stages.setup.camera,
                       stages.setup.mask, stages.tracks.workers()[0].outline);
  }
}

/// Motion of the object's points since a past frame: the camera's and the object's composed.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
SE3d LateMasks<Camera, Classifier, Noise, Aligner>::T_now_then(const Track& t, const AwaitedFrame& then, double now) {
  return t.motion.path.since(then.timestamp(), now, t.belief.expected_velocity()) * then.since.T_now_ref;
}

/// Moves a track, with or without a new mask, from a past frame to the present.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::apply_late_mask(Track& t, const AwaitedFrame& then, double now,
                                                                    const Setup& setup, Worker& worker) const {
  TrackedOutline& outline = t.outline;
  const SE3d T = T_now_then(t, then, now);
  if (!t.observed) {
    outline.is_newest = false;
    if (outline.visible && !t.identity.discovered) outline.contradicted = true;
    t.motion.position_now = t.expected.moved(T);
    outline.T_now_shape = T * outline.T_frame_shape;
    return;
  }
  const Vector3<double>& centre = t.observed->centre;
  outline.set_shape(t.observed->mask, outline.T_frame_shape, then.frame, 1 / setup.selection.max_depth, setup.camera,
                    setup.mask, worker.outline);
  outline.T_now_shape = T;
  outline.is_newest = then.since_known;
  outline.last_seen = std::max(outline.last_seen, then.timestamp());
  t.motion.position_now = (centre.z() > 0 ? Place{centre, true} : t.expected).moved(T);

  // Points under the new mask are better than those under the predicted one.
  renew_reference(t, then, t.observed->mask, centre, now, setup, worker);
  for (const AwaitedFrame& later : frames_) {
    if (later.timestamp() <= then.timestamp()) continue;
    const Image<float>& inverse_depth = later.frame->inverse_depth();
    outline.warp_by(T_now_then(t, later, now).inverse() * T, inverse_depth, setup.camera, setup.mask, worker.outline);
    const Mask& mask = outline.warped.mask;
    renew_reference(t, later, mask, centre_of(mask, inverse_depth, setup.camera, worker.object.selection.values), now,
                    setup, worker);
  }
}

/// Adds or replaces the reference of a past frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::renew_reference(Track& t, const AwaitedFrame& then,
                                                                    const Mask& mask, const Vector3<double>& centre,
                                                                    double now, const Setup& setup,
                                                                    Worker& worker) const {
  if (!t.followed || !then.since_known) return;
  if (then.frame->is_repeated() && !t.motion.references.empty()) return;  // as in Tracks::remember
  ObjectReference r;
  r.timestamp = then.timestamp();
  r.camera = then.since;
  r.T_obj_now_ref = T_now_then(t, then, now);
  const ObjectTracker<Camera, Noise, Aligner> tracker = TracksT::tracker(setup, setup.noise);
  const ExpectedDepth expected = tracker.expected_depth(t.motion, r.T_obj_now_ref.inverse(), r.timestamp);
  if (tracker.make_reference(*then.frame, mask, centre, expected, worker.object, r) != Reason::None) return;
  RecyclingList<ObjectReference>& all = t.motion.references;
  std::size_t place = 0;
  while (place < all.size() && all[place].timestamp > r.timestamp) ++place;
  const bool replaces = place < all.size() && all[place].timestamp == r.timestamp;
  std::swap(replaces ? all[place] : all.insert(place), r);
}

/// Follows new tracks from the frame whose masks started them through all later frames, as if the masks had been in
/// time.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void LateMasks<Camera, Classifier, Noise, Aligner>::replay(const std::vector<Track*>& started, const AwaitedFrame& then,
                                                           const Stages& stages) const {
  const Setup& setup = stages.setup;
  Worker& worker = stages.tracks.workers()[0];
  for (const AwaitedFrame& f : frames_) {
    if (f.timestamp() < then.timestamp()) continue;
    const FrameData& cur = *f.frame;
    const bool first = &f == &then;
    if (!first) {
      const Interval interval{nullptr, cur, f.camera};
      stages.tracks.predict(started, interval, setup);
      stages.tracks.follow(started, interval, stages.observations, setup);
    }
    for (Track* t : started) {
      TrackedOutline& outline = t->outline;
      if (first) {
        outline.set_shape(t->observed->mask, {}, f.frame, 1 / setup.selection.max_depth, setup.camera, setup.mask,
                          worker.outline);
        outline.is_newest = true;
      } else {
        outline.mask = outline.warped.mask;
        outline.visible = outline.mask.area >= setup.mask.min_pixels;
      }
      if (first || (outline.visible && t->motion.step.fit.ok())) outline.last_seen = cur.timestamp;
      stages.tracks.remember(*t, cur, setup, worker);
      t->motion.path.add(cur.timestamp, then.timestamp());
    }
  }
}

DOT_END_NAMESPACE
