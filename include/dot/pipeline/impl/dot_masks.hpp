// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "dot/pipeline/dot.hpp"

/// @file
/// Masks: prediction, association, births, labels.

DOT_BEGIN_NAMESPACE

/// Masks and references of all tracks at constant velocity in this frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::predict_tracks() {
  tracks_.drop_if([](const TrackT& t) { return t.lost; });
  const CameraState& c = camera_state_;
  T_cur_segmented_ = c.T_cur_prev * T_cur_segmented_;
  segmented_frame_.known &= c.known();
  for (Past& p : history_) {
    p.since.advance(c.T_cur_prev, c.covariance, c.alignment.state.gain, c.alignment.state.offset);
    p.camera_known &= c.known();
  }
  threads.run(static_cast<int>(tracks_.size()), [this](int worker, int i) {
    predict(tracks_[static_cast<std::size_t>(i)], workers_[static_cast<std::size_t>(worker)]);
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::predict(TrackT& t, Worker& worker) {
  const CameraState& c = camera_state_;
  t.segmented = false;
  t.observed = nullptr;
  t.outline_is_newest &= c.known();
  if (!c.known()) {  // compared with what the camera saw before a guess, all that stands would move
    t.references.clear();
    t.no_reference = Reason::CameraLost;
  }
  for (ObjectReference& r : t.references) {
    r.advance(c.T_cur_prev, c.covariance, c.alignment.state.gain, c.alignment.state.offset);
    if (r.points.take(current_.bias, camera_.width(), camera_.height())) r.centre();
  }
  t.T_o_predicted = SE3d::translation(t.expected_velocity() * current_.dt);
  t.position_before = t.position;
  t.position = t.position.moved(c.T_cur_prev * t.T_o_predicted);
  const SE3d T = c.T_cur_prev * t.T_o_predicted * t.T_cur_outline;
  warp_outline(t, T, current_.inverse_depth(), worker);
  t.predicted_by = T;
  t.is_as_predicted = true;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::warp_outline(TrackT& object, const SE3d& T_frame_outline,
                                                           const Image<float>& inverse_depth, Worker& worker) {
  const ImageView<const float> trim_by = object.outline.measured ? inverse_depth.view() : ImageView<const float>{};
  warp(object.outline, T_frame_outline, camera_, trim_by, options_.mask.depth_tolerance, worker.warp, object.predicted);
  object.is_as_predicted = false;
}

/// Reads the id image, if there is one, as far as is needed to know how many instances there are.
/// @throws std::invalid_argument naming the field when there are too many, or when their boxes overlap so much that to
/// store and compare them would take without bound.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::count_instances(const char* field, const Masks& masks) {
  id_runs_.instances.clear();
  id_runs_.box_area = 0;
  id_runs_.runs.clear();
  if (masks.ids.data != nullptr) find_runs(masks.ids, id_runs_);
  const auto most = static_cast<std::size_t>(options_.mask.max_instances);
  const auto refuse = [&](const char* member, std::size_t count) {
    bad_field(std::string(field) + member, "has " + std::to_string(count) +
                                               " instances, more than mask.max_instances, " + std::to_string(most) +
                                               ": is it an image of something else?");
  };
  if (id_runs_.instances.size() > most) refuse(".ids", id_runs_.instances.size());
  if (masks.instances.size > most) refuse(".instances", masks.instances.size);
  const double images = id_runs_.box_area / (1.0 * camera_.width() * camera_.height());
  if (images > kMostBoxes)
    bad_field(std::string(field) + ".ids", "has instances that are strewn over it: their boxes have " +
                                               to_text(images) + " times its area, more than " + to_text(kMostBoxes) +
                                               ": is it an image of something else?");
}

/// The instances of a frame's segmentation, whichever way they came, after `count_instances`.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::read_masks(const Masks& masks, const Image<float>& inverse_depth) {
  if (masks.ids.data != nullptr) {
    split_ids(id_runs_, [this](std::uint32_t id) -> Mask& {
      Observed& o = observe();
      o.instance_id = id;
      return o.mask;
    });
  }
  for (const Instance& instance : masks.instances) {
    Observed* o = nullptr;
    if (instance.mask.data != nullptr) {
      o = &observe();
      o->instance_id = instance.id;
      mask_of(instance.mask, instance.x, instance.y, camera_.width(), camera_.height(), o->mask);
    } else {
      for (Observed& other : observed_)
        if (other.instance_id == instance.id) o = &other;
    }
    if (!o) continue;
    o->class_id = instance.class_id;
    o->score = instance.score;
    o->always_dynamic = instance.always_dynamic;
  }
  observed_.drop_if([](const Observed& o) { return o.mask.empty(); });
  for (Observed& o : observed_) o.centre = anchor(o.mask, inverse_depth, workers_[0]);
}

/// Another mask, to be filled in.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
auto Dot<Camera, Classifier, Noise, Aligner>::observe() -> Observed& {
  Observed& o = observed_.push_back();
  Observed fresh;
  std::swap(fresh.mask, o.mask);  // for its memory
  o = std::move(fresh);
  return o;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::associate() {
  match(all_tracks());
  if (options_.discover_unknown) absorb();
}

/// Gives the tracks those of the observed masks that have no track yet: the network's to any, and what was discovered
/// to those that no network has shown.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::match(const std::vector<TrackT*>& tracks) {
  match(tracks, false);
  if (!options_.discover_unknown) return;
  for (const bool candidate : {false, true}) {
    std::vector<TrackT*> unknown;
    for (TrackT* t : tracks)
      if (t->discovered && !t->observed && t->candidate == candidate && !stands(*t)) unknown.push_back(t);
    match(unknown, true);
  }
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::match(const std::vector<TrackT*>& tracks, bool discovered) {
  auto& [open, predicted, observed, association] = matching_;
  open.clear(), predicted.clear(), observed.clear();
  for (const TrackT* t : tracks)
    predicted.push_back({&t->predicted.mask, t->is_ahead() ? 1 / t->position.at.z() : 0.0});
  for (Observed& o : observed_)
    if (!o.track && o.discovered == discovered)
      open.push_back(&o), observed.push_back({&o.mask, o.centre.z() > 0 ? 1 / o.centre.z() : 0.0});
  if (open.empty() || predicted.empty()) return;
  const std::vector<int>& partner = dot::associate(predicted, observed, options_.mask, association);
  for (std::size_t i = 0; i < open.size(); ++i)
    if (partner[i] >= 0) give(*open[i], *tracks[static_cast<std::size_t>(partner[i])]);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::give(Observed& o, TrackT& t) {
  o.track = &t;
  t.observed = &o.mask;
  t.observed_centre = o.centre;
  if (o.discovered) return;
  t.segmented = true;
  t.discovered = t.candidate = false;
  t.instance_id = o.instance_id;
  t.class_id = o.class_id;
  t.score = o.score;
  t.always_dynamic = o.always_dynamic;
}

/// Continues tracks whose object was hidden and comes out again: what shows first is another part of it than was seen
/// last, so that the outlines do not overlap. Where it is tells: within its size of where it should be.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::find_again() {
  const std::vector<TrackT*>& hidden = tracks_that([](const TrackT& t) { return !t.observed && t.is_ahead(); });
  auto& [open, predicted, observed, association] = matching_;
  open.clear(), association.pairs.clear();
  for (Observed& o : observed_)
    if (!o.track && !o.discovered) open.push_back(&o);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Vector3<double>& now = open[i]->centre;
    if (!(now.z() > 0)) continue;
    for (std::size_t j = 0; j < hidden.size(); ++j) {
      const Vector3<double>& then = hidden[j]->position.at;
      const double size = hidden[j]->size;
      const double along = std::abs(now.z() / then.z() - 1) / std::max(options_.mask.depth_tolerance, size / now.z());
      if (!(along < 1)) continue;
      const double aside = (now.head<2>() / now.z() - then.head<2>() / then.z()).norm() * now.z() / size;
      if (aside < 1) association.pairs.push_back({static_cast<int>(i), static_cast<int>(j), aside + along});
    }
  }
  const std::vector<int>& partner = assign(static_cast<int>(open.size()), static_cast<int>(hidden.size()),
                                           std::numeric_limits<double>::infinity(), association);
  for (std::size_t i = 0; i < open.size(); ++i)
    if (partner[i] >= 0) give(*open[i], *hidden[static_cast<std::size_t>(partner[i])]);
}

/// Masks of this frame: the network's where there is one, otherwise the outline moved by T_c T_o. What the network
/// shows and no track explains, now that their motions are known, becomes a new track.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::place_masks() {
  match(tracks_that([](const TrackT& t) { return !t.observed; }));
  find_again();
  start_tracks();
  choose_followed();
  threads.run(static_cast<int>(tracks_.size()), [this](int worker, int i) {
    place(tracks_[static_cast<std::size_t>(i)], workers_[static_cast<std::size_t>(worker)]);
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::place(TrackT& t, Worker& worker) {
  if (t.observed) {
    if (t.segmented && t.followed && !t.fit.ok()) look_back(t, worker);
    t.mask = *t.observed;
    take_outline(t, current_.inverse_depth(), worker);
    t.T_cur_outline = {};
    t.outline_is_newest = true;
    t.visible = true;
  } else {
    if (segmented_) t.outline_is_newest = false;
    t.mask = t.predicted.mask;
    t.visible = t.mask.area >= options_.mask.min_pixels;
    // What the last segmentation should have shown and did not may be missed or gone; fits may have locked onto
    // something else. It is carried on, but counts as seen only once a network shows it again.
    if (t.visible && segmented_ && !t.discovered) t.contradicted = true;
  }
  const bool follows = t.discovered ? !t.candidate : !t.contradicted;
  if (t.observed || (follows && t.visible && t.fit.ok())) t.last_seen = current_.timestamp;
  if (!t.visible && !t.may_come_out() && t.fit.ok()) t.fit.reason = Reason::Hidden;
  const bool was_shown = !t.discovered || t.confirmed >= kConfirmedSeconds || stands(t);
  if (t.lost || current_.timestamp - t.last_seen > (was_shown ? options_.mask.keep_seconds : kCandidateSeconds)) {
    t.lost = true;
    t.fit.reason = Reason::Lost;
  }
}

/// Makes the observed mask the one that is carried on. @param inverse_depth of the mask's frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::take_outline(TrackT& object, const Image<float>& inverse_depth,
                                                           Worker& worker) {
  keep_hidden(object, inverse_depth, worker);
  const double q = object.outline.median > 0 ? object.outline.median : 1 / options_.selection.max_depth;
  if (!make_template(*object.observed, inverse_depth.view(), options_.mask.depth_tolerance, worker.outline,
                     object.outline))
    make_flat_template(*object.observed, q, object.outline);
  object.contradicted = false;
}

/// Remembers what of the outline is behind something now that a mask shows the rest: to know it when it comes out.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::keep_hidden(TrackT& object, const Image<float>& inverse_depth,
                                                          Worker& worker) {
  worker.hidden.clear();
  for (const MaskTemplate* part : {&object.outline, &object.hidden}) {
    if (!part->measured) continue;
    if (part == &object.outline && object.predicted.hidden_area < options_.mask.min_pixels) continue;
    warp(*part, object.T_cur_outline, camera_, {}, 0, worker.warp, worker.moved);
    worker.hidden.add(worker.moved, inverse_depth.view(), options_.mask.depth_tolerance, *object.observed);
  }
  worker.hidden.make_template(object.hidden);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::start_tracks() {
  small_instances_ = 0;
  for (Observed& o : observed_) {
    if (o.track) continue;
    if (!o.discovered && o.mask.area < options_.mask.min_pixels) {
      ++small_instances_;
      continue;
    }
    TrackT& t = tracks_.push_back();
    t.restart(next_id_++);
    t.instance_id = o.instance_id;
    t.class_id = o.class_id;
    t.score = o.score;
    t.always_dynamic = o.always_dynamic;
    t.observed = &o.mask;
    t.observed_centre = o.centre;
    t.segmented = !o.discovered;
    t.discovered = t.candidate = o.discovered;
    if (t.discovered) t.support = discovery_.support(o.mask);
    t.fit.reason = Reason::New;
    if (t.always_dynamic) t.state = t.last_decided = State::Moving, t.p_moving = 1;
    o.track = &t;
  }
}

/// The largest objects, up to object.max_fitted, are those whose motion is estimated. Of more than twice as many tracks
/// as there may be instances, those that were not seen for longest are dropped.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::choose_followed() {
  const auto most = static_cast<std::size_t>(options_.object.max_fitted);
  const auto most_tracks = 2 * static_cast<std::size_t>(options_.mask.max_instances);
  for (TrackT& t : tracks_) t.followed = true;
  if (tracks_.size() <= most) return;
  const auto area = [](const TrackT* t) { return t->observed ? t->observed->area : t->predicted.mask.area; };
  std::vector<TrackT*>& order = all_tracks();
  std::sort(order.begin(), order.end(),
            [&](const TrackT* l, const TrackT* r) { return area(l) != area(r) ? area(l) > area(r) : l->id < r->id; });
  for (std::size_t i = most; i < order.size(); ++i) order[i]->followed = false;
  if (order.size() <= most_tracks) return;
  std::sort(order.begin(), order.end(), [](const TrackT* l, const TrackT* r) {
    const bool l_seen = l->observed, r_seen = r->observed;
    return std::make_tuple(l_seen, l->last_seen, l->id) > std::make_tuple(r_seen, r->last_seen, r->id);
  });
  for (std::size_t i = most_tracks; i < order.size(); ++i) order[i]->lost = true;
}

/// Within which inverse depths of one surface agree, measured in two frames: relative, three sigmas.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
double Dot<Camera, Classifier, Noise, Aligner>::depth_tolerance(double q) const {
  const double sigma = std::max(std::hypot(depth_noise.pixel(q), depth_noise.common(q)),
                                std::hypot(depth_noise.prior_pixel(q), depth_noise.prior_common(q)));
  return std::min(3 * std::sqrt(2.0) * sigma / q, options_.mask.depth_tolerance);
}

/// What is shown or may come out, far to near, predicted masks below those that the network saw.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
auto Dot<Camera, Classifier, Noise, Aligner>::far_to_near() -> std::vector<TrackT*>& {
  std::vector<TrackT*>& order = tracks_that([](const TrackT& t) { return t.is_shown() || t.may_come_out(); });
  const auto rank = [](const TrackT* t) {
    return std::make_tuple(t->observed && !t->discovered, t->inverse_depth(), t->id);
  };
  std::sort(order.begin(), order.end(), [&](const TrackT* l, const TrackT* r) { return rank(l) < rank(r); });
  return order;
}

/// The id image of these tracks' masks, the last one on top.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::paint(const std::vector<TrackT*>& order,
                                                    Image<std::uint32_t>& ids) const {
  ids.resize(camera_.width(), camera_.height());
  ids.fill(0);
  for (const TrackT* t : order) t->mask.write(t->id, ids);
}

/// Adds to an object's pixels what the last segmentation could not see of it: what earlier ones showed, and, where its
/// motion is known, what none has shown.
/// @param box x, y, width, height of its pixels; grows with them
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::show_new_parts(const TrackT& object, std::array<int, 4>& box) {
  const SE3d T_seg_object = object.T_cur_outline.inverse(), T_seg_static = T_cur_segmented_.inverse();
  const ImageView<const float> inverse_depth = current_.inverse_depth().view();
  const auto tolerance = [this](double q) { return depth_tolerance(q); };
  if (!object.hidden.mask.empty()) {
    WarpedMask& expected = workers_[0].moved;
    warp(object.hidden, object.T_cur_outline, camera_, {}, 0, workers_[0].warp, expected);
    reveal(expected, segmented_frame_, T_seg_object, T_seg_static, camera_, inverse_depth, object.id, tolerance, ids_,
           box);
  }
  if (!object.fit.ok() && !object.goes_on_surely(current_.timestamp)) return;
  grow(segmented_frame_, T_seg_object, T_seg_static, camera_, inverse_depth, object.id, tolerance, grow_workspace_,
       ids_, box);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::label() {
  if (std::exchange(segmented_before_, segmented_)) {
    std::swap(segmented_frame_.ids, ids_);
    std::swap(segmented_frame_.inverse_depth, previous_.depth.levels[0]);
    segmented_frame_.known = camera_state_.known();
  }
  labels_.resize(camera_.width(), camera_.height());
  labels_.fill(0);
  const std::vector<TrackT*>& order = far_to_near();
  for (TrackT* t : order) {
    if (!t->visible) t->mask.clear();
    if (!t->observed && t->state != State::Static && t->predicted.is_mostly_hidden())
      drop_unmeasured(current_.inverse_depth().view(), t->mask);
  }
  paint(order, ids_);
  // Near to far, so that what is nearer grows first.
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    TrackT& t = **i;
    std::array<int, 4> box = t.mask.box();
    if (!t.observed && t.outline_is_newest && segmented_frame_.known) show_new_parts(t, box);
    crop_ids<std::uint32_t>(ids_.view(), t.id, box, t.mask);
    t.visible = !t.mask.empty();
    if (!t.visible && t.fit.ok()) t.fit.reason = Reason::Hidden;
    t.mask.write(static_cast<std::uint8_t>(t.state), labels_);
  }
  if (segmented_) T_cur_segmented_ = {};
}

DOT_END_NAMESPACE
