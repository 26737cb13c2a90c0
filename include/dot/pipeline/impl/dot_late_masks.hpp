// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "dot/pipeline/dot.hpp"

/// @file
/// Masks that arrive after their frame.

DOT_BEGIN_NAMESPACE

/// Keeps the frame as long as its masks may come: until those of a later one have.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::await_masks(const Frame& frame) {
  const double oldest = current_.timestamp - options_.mask.late_seconds - 1e-6;
  history_.drop_before(oldest);
  if (segmented_ || !(options_.mask.late_seconds > 0)) {
    history_.clear();
    for (TrackT& t : tracks_) t.path.clear();
    return;
  }
  PastFrame& newest = history_.add();
  newest.id = frame.id;
  newest.since.timestamp = current_.timestamp;
  std::swap(newest.image, current_.pyramid);
  std::swap(newest.inverse_depth, current_.depth.levels[0]);
  for (TrackT& t : tracks_) t.path.add(current_.timestamp, oldest);
}

/// Motion of the object's points since a past frame, the camera's and its own composed.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
SE3d Dot<Camera, Classifier, Noise, Aligner>::T_cur_then(const TrackT& object, const PastFrame& then) const {
  return object.path.since(then.since.timestamp, current_.timestamp, object.expected_velocity()) * then.since.T_cur_ref;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::submit_masks(std::uint64_t frame_id, const Masks& masks) {
  validate("masks", masks, camera_.width(), camera_.height());
  PastFrame* const found = history_.find(frame_id);
  if (!found)
    bad_field("frame_id", std::to_string(frame_id) +
                              " is none of the frames after the last segmentation and of the last " +
                              std::to_string(options_.mask.late_seconds) + " s");
  PastFrame& then = *found;

  // The tracks as they were in that frame, by what is known of their motions now.
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), [](const TrackT& t) { return t.lost; }), tracks_.end());
  for (TrackT& t : tracks_) {
    const SE3d T_then_cur = T_cur_then(t, then).inverse();
    t.observed = nullptr;
    t.position = T_then_cur * t.position;
    warp_outline(t, T_then_cur * t.T_cur_outline, then.inverse_depth);
  }
  observed_.clear();
  read_masks(masks, then.inverse_depth);
  associate();
  find_again();
  start_tracks();

  for (TrackT& t : tracks_) {
    t.mask = t.observed ? *t.observed : t.predicted.mask;
    t.visible = t.observed || t.mask.area >= options_.mask.min_pixels;
  }
  paint(far_to_near(), segmented_frame_.ids);
  for (TrackT& t : tracks_) adopt(t, then);
  T_cur_segmented_ = then.since.T_cur_ref;
  const double timestamp = then.since.timestamp;
  std::swap(segmented_frame_.inverse_depth, then.inverse_depth);
  history_.drop_before(timestamp + 1e-9);
}

/// Takes a track with its new mask, or without, from a past frame back to the present.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::adopt(TrackT& object, PastFrame& then) {
  const SE3d T = T_cur_then(object, then);
  if (!object.observed) {
    object.outline_is_newest = false;
    if (object.visible && !object.discovered) object.contradicted = true;
    object.position = T * object.position;
    return;
  }
  take_outline(object, then.inverse_depth);
  object.T_cur_outline = T;
  object.outline_is_newest = then.camera_known;
  object.last_seen = std::max(object.last_seen, then.since.timestamp);
  if (object.observed_centre.z() > 0) {
    object.position = object.observed_centre;
    object.grow_to(object.observed->area, object.position.z() / camera_.intrinsics().fx);
  }
  object.position = T * object.position;

  // Points of that frame: a new object has no others, and those under its true mask are better than under a carried
  // one.
  ObjectReference r = then.since;
  const Selector<Camera, Noise> select{camera_, depth_noise, then.image, then.inverse_depth.view(), options_.selection};
  const Reason reason = make_reference(select, *object.observed, object.observed_centre, r);
  object.observed = nullptr;
  if (reason != Reason::None) {
    if (object.references.empty()) object.no_reference = reason;
    return;
  }
  object.unplaced = object.references.empty() && r.intervals > 0;
  r.T_obj_cur_ref = T;
  const auto place = std::find_if(object.references.begin(), object.references.end(),
                                  [&](const ObjectReference& other) { return other.timestamp <= r.timestamp; });
  if (place != object.references.end() && place->timestamp == r.timestamp)
    *place = std::move(r);
  else
    object.references.insert(place, std::move(r));
}

DOT_END_NAMESPACE
