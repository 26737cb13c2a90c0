// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "dot/pipeline/dot.hpp"

/// @file
/// Masks that arrive after their frame.

DOT_BEGIN_NAMESPACE

/// Keeps the frame as long as its masks may come: until those of a later one have, or are too late.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::await_masks(const Frame& frame) {
  if (segmented_ || !(options_.mask.late_seconds > 0)) {
    history_.clear();
    for (TrackT& t : tracks_) t.path.clear();
    return;
  }
  history_.drop_before(current_.timestamp - options_.mask.late_seconds - 1e-6,
                       static_cast<std::size_t>(options_.mask.late_frames - 1));
  Past& newest = history_.add();
  newest.id = frame.id;
  newest.frame.timestamp = current_.timestamp;  // the next frame needs it as well
  newest.frame.dt = current_.dt;
  newest.frame.bias = current_.bias;
  std::swap(newest.frame.pyramid, current_.pyramid);
  std::swap(newest.frame.depth, current_.depth);
  newest.camera = camera_state_;
  newest.since = {};
  newest.since.timestamp = current_.timestamp;
  newest.camera_known = true;
  const double oldest = history_.begin()->timestamp();
  for (TrackT& t : tracks_) t.path.add(current_.timestamp, oldest);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::submit_masks(std::uint64_t frame_id, const Masks& masks) {
  validate("masks", masks, camera_.width(), camera_.height());
  count_instances("masks", masks);
  const auto found =
      std::find_if(std::make_reverse_iterator(history_.end()), std::make_reverse_iterator(history_.begin()),
                   [&](const Past& p) { return p.id == frame_id; });
  if (found == std::make_reverse_iterator(history_.begin()))
    bad_field("frame_id", std::to_string(frame_id) + " is none of the frames since the last segmentation, up to " +
                              to_text(options_.mask.late_seconds) + " s ago and " +
                              std::to_string(options_.mask.late_frames) + " at most");
  reset_unless_done([&] { apply_late_masks(*found, masks); });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::apply_late_masks(Past& then, const Masks& masks) {
  // The tracks as they were in that frame, by what is known of their motions now.
  tracks_.drop_if([](const TrackT& t) { return t.lost; });
  for (TrackT& t : tracks_) {
    const SE3d T_then_cur = T_cur_then(t, then).inverse();
    t.observed = nullptr;
    t.position = t.position.moved(T_then_cur);
    t.T_cur_outline = T_then_cur * t.T_cur_outline;
    warp_outline(t, t.T_cur_outline, then.frame.inverse_depth(), workers_[0]);
  }
  observed_.clear();
  read_masks(masks, then.frame.inverse_depth());
  associate();
  find_again();
  const std::size_t known = tracks_.size();
  start_tracks();
  choose_followed();

  for (TrackT& t : tracks_) {
    t.mask = t.observed ? *t.observed : t.predicted.mask;
    t.visible = t.observed || t.mask.area >= options_.mask.min_pixels;
  }
  paint(far_to_near(), segmented_frame_.ids);
  segmented_frame_.inverse_depth = then.frame.inverse_depth();
  segmented_frame_.known = then.camera_known;
  T_cur_segmented_ = then.since.T_cur_ref;

  std::vector<TrackT*> started = all_tracks();
  for (std::size_t i = 0; i < known; ++i) adopt(*started[i], then);
  started.erase(started.begin(), started.begin() + static_cast<std::ptrdiff_t>(known));
  if (!started.empty()) catch_up(started, then.timestamp());
  if (then.timestamp() == current_.timestamp) {  // the newest, which the next frame needs
    std::swap(then.frame.pyramid, current_.pyramid);
    std::swap(then.frame.depth, current_.depth);
  }
  history_.drop_through(then);
}

/// Motion of the object's points since a past frame, the camera's and its own composed.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
SE3d Dot<Camera, Classifier, Noise, Aligner>::T_cur_then(const TrackT& object, const Past& then) const {
  return object.path.since(then.timestamp(), current_.timestamp, object.expected_velocity()) * then.since.T_cur_ref;
}

/// Takes a track with its new mask, or without, from a past frame to the present.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::adopt(TrackT& object, const Past& then) {
  const SE3d T = T_cur_then(object, then);
  if (!object.observed) {
    object.outline_is_newest = false;
    if (object.visible && !object.discovered) object.contradicted = true;
    object.position = object.position.moved(T);
    object.T_cur_outline = T * object.T_cur_outline;
    return;
  }
  take_outline(object, then.frame.inverse_depth(), workers_[0]);
  object.T_cur_outline = T;
  object.outline_is_newest = then.camera_known;
  object.last_seen = std::max(object.last_seen, then.timestamp());
  if (object.observed_centre.z() > 0) object.position = {object.observed_centre, true};
  object.position = object.position.moved(T);

  // Points under the new mask are better than those under the one that was carried on.
  renew_reference(object, then, *object.observed, object.observed_centre);
  for (const Past& p : history_) {
    if (p.timestamp() <= then.timestamp()) continue;
    warp_outline(object, T_cur_then(object, p).inverse() * T, p.frame.inverse_depth(), workers_[0]);
    renew_reference(object, p, object.predicted.mask,
                    anchor(object.predicted.mask, p.frame.inverse_depth(), workers_[0]));
  }
}

/// Adds or replaces the reference of a past frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::renew_reference(TrackT& object, const Past& then, const Mask& mask,
                                                              const Vector3<double>& centre) {
  if (!object.followed || !then.camera_known) return;
  ObjectReference r = then.since;
  r.T_obj_cur_ref = T_cur_then(object, then);
  if (make_reference(then.frame, mask, centre, workers_[0], r) != Reason::None) return;
  RecyclingList<ObjectReference>& all = object.references;
  std::size_t place = 0;
  while (place < all.size() && all[place].timestamp > r.timestamp) ++place;
  const bool replaces = place < all.size() && all[place].timestamp == r.timestamp;
  std::swap(replaces ? all[place] : all.insert(place), r);
}

/// Leads new tracks from the frame whose masks started them through all later ones, as if the masks had come in time.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::catch_up(std::vector<TrackT*>& started, double start) {
  const auto swap_in = [this](Past& p) {
    std::swap(current_, p.frame);
    std::swap(camera_state_, p.camera);
  };
  for (Past& p : history_) {
    if (p.timestamp() < start) continue;
    const bool first = p.timestamp() == start;
    swap_in(p);
    if (!first) {
      for (TrackT* t : started) predict(*t, workers_[0]);
      follow_and_decide(started);
    }
    for (TrackT* t : started) {
      if (first) {
        take_outline(*t, current_.inverse_depth(), workers_[0]);
        t->outline_is_newest = true;
      } else {
        t->mask = t->predicted.mask;
        t->visible = t->mask.area >= options_.mask.min_pixels;
      }
      if (first || (t->visible && t->fit.ok())) t->last_seen = current_.timestamp;
      add_reference(*t, workers_[0]);
      t->path.add(current_.timestamp, start);
    }
    swap_in(p);
  }
}

DOT_END_NAMESPACE
