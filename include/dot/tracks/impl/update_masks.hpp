// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <tuple>

/// @file
/// Definitions of tracks/tracks.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
int Tracks<Camera, Classifier, Noise, Aligner>::update_masks(const Interval& interval, const FramePtr& frame,
                                                             bool segmented, Observations& observations,
                                                             const Discovery<Camera, Noise>& discovery,
                                                             const Setup& setup) {
  assignment_.by_overlap(that([](const Track& t) { return !t.observed && !t.is_part(); }), observations, setup.mask);
  find_again(observations, setup.mask);
  const int too_small = start(observations, setup);
  const CameraStep& camera = interval.camera;
  camera_velocity_ = camera.known() && camera.seconds > 0 ? Vector3<double>(-camera.T_cur_prev.t / camera.seconds)
                                                          : Vector3<double>(Vector3<double>::Zero());
  setup.threads.run(static_cast<int>(tracks_.size()), [&](int worker, int i) {
    update_mask(tracks_[static_cast<std::size_t>(i)], interval, frame, segmented, discovery, setup,
                workers_[static_cast<std::size_t>(worker)]);
  });
  return too_small;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::update_mask(Track& t, const Interval& interval, const FramePtr& frame,
                                                             bool segmented, const Discovery<Camera, Noise>& discovery,
                                                             const Setup& setup, Worker& worker) const {
  const FrameData& cur = interval.cur;
  TrackedOutline& outline = t.outline;
  Reason& reason = t.motion.step.fit.reason;
  if (t.identity.discovered) examine(t, interval.camera.seconds, discovery, setup, worker);
  if (t.observed) {
    if (t.segmented && t.followed && !t.motion.step.fit.ok()) align_backwards(t, interval, setup, worker);
    outline.mask = t.observed->mask;
    outline.set_shape(t.observed->mask, outline.T_now_shape, frame, 1 / setup.selection.max_depth, setup.camera,
                      setup.mask, worker.outline);
    outline.T_now_shape = {};
    outline.is_newest = outline.visible = true;
  } else {
    if (segmented) outline.is_newest = false;
    if (interval.camera.known()) outline.find_depth(cur.inverse_depth(), setup.mask, worker.outline);
    outline.mask = outline.warped.mask;
    outline.visible = outline.mask.area >= setup.mask.min_pixels;
    // The last segmentation should have shown the object but did not. The network may have missed it, or it is gone and
    // the fits lock onto something else. It is still tracked, but counts as seen only when a network shows it again.
    if (outline.visible && segmented && !t.identity.discovered) outline.contradicted = true;
  }
  const bool follows = t.identity.discovered ? !t.candidacy.is_candidate : !outline.contradicted;
  if (t.observed || (follows && outline.visible && reason == Reason::None)) outline.last_seen = cur.timestamp;
  if (!outline.visible && !t.may_come_out() && reason == Reason::None) reason = Reason::Hidden;
  const bool was_shown = !t.identity.discovered || t.candidacy.was_confirmed() || t.is_rejected_candidate();
  const double keep = was_shown && !t.is_part() ? setup.mask.keep_seconds : Candidacy::kSeconds;
  t.candidacy.was_reported |= !t.candidacy.is_candidate;
  if (t.lost || cur.timestamp - outline.last_seen > keep) {
    t.lost = true;
    reason = Reason::Lost;
  }
}

/// Compares a discovered object's motion with standing. Decides whether it is shown, and takes out of its mask what
/// stands.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::examine(Track& t, double seconds,
                                                         const Discovery<Camera, Noise>& discovery, const Setup& setup,
                                                         Worker& worker) const {
  Mask& mask = t.observed ? t.observed->mask : t.outline.warped.mask;
  if (!discovery.is_blind() && !t.is_rejected_candidate() && !t.motion.references.empty() && !mask.empty()) {
    MovingPart& part = worker.moving_part;
    const Noise noise = discovery.bounded(setup.noise);
    discovery.compare(setup.camera, noise, mask, t.motion.references, part);
    t.candidacy.examine(part.is_comparable() ? part.certainty() : discovery.certainty(setup.camera, noise, mask),
                        seconds);
    if (t.observed && t.motion.step.fit.ok() && part.is_mixed()) part.cut(mask);
  }
  t.candidacy.decide(t.belief.state);
}

/// Finds the step of an object that no earlier mask explains.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::align_backwards(Track& t, const Interval& of_all, const Setup& setup,
                                                                 Worker& worker) const {
  if (t.motion.doubted_at == of_all.cur.timestamp) return;  // it was tried
  const CameraStep camera = step_of_rows(t, of_all.camera, setup.camera.height());
  const Interval interval{of_all.prev, of_all.cur, camera};
  const auto fit =
      tracker(setup, setup.noise).align_backwards(t.motion, t.belief, *t.observed, interval, worker.object);
  if (!fit || (!t.belief.has_velocity() && refuses(t.motion, *fit, interval, setup))) return;
  const SE3d& T_c = camera.T_cur_prev;
  t.motion.correct(*fit, T_c);
  t.expected = t.motion.position_now;
  ObjectStep& step = t.motion.step;
  if (step.has_evidence) return;  // an older frame gave evidence already
  // The belief was already predicted to this frame, so the evidence is given in this frame's axes.
  step.evidence = fit->motion.rotated(T_c.R);
  step.has_evidence = fit->phi >= setup.estimator.settings.min_phi;
  decide(t, interval.cur, Matrix3<double>::Identity(), camera.seconds, 0, setup);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
int Tracks<Camera, Classifier, Noise, Aligner>::start(Observations& observations, const Setup& setup) {
  int too_small = 0, candidates = 0;
  for (const Track& t : tracks_) candidates += t.candidacy.is_candidate && !t.is_rejected_candidate() && !t.lost;
  for (Observation& o : observations.list) {
    if (o.assigned || o.part_of != 0) continue;
    if (o.discovered && ++candidates > Candidacy::kMost) continue;
    if (!o.discovered && o.mask.area < setup.mask.min_pixels) {
      ++too_small;
      continue;
    }
    start_with(o);
  }
  divide_masks(observations, setup);
  for (Observation& o : observations.list)
    if (!o.assigned && o.part_of != 0) start_with(o);
  choose_followed(setup.estimator.settings.max_fitted);
  // At most twice as many tracks as instances are kept. The tracks that were not seen for longest are dropped.
  constexpr std::size_t kTracksOfInstance = 2;
  drop_surplus(kTracksOfInstance * static_cast<std::size_t>(setup.mask.max_instances));
  return too_small;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::start_with(Observation& o) {
  ClassifiedTrack& t = tracks_.push_back();
  t.restart(next_id_++);
  t.memory = {};
  t.start(o);
}

/// Selects the largest objects, before parts of their masks. Only their motion is estimated.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::choose_followed(int most) {
  const auto count = static_cast<std::size_t>(most);
  for (Track& t : tracks_) t.followed = true;
  if (tracks_.size() <= count) return;
  order_ = all();
  std::sort(order_.begin(), order_.end(), [&](const Track* l, const Track* r) {
    const int a = l->newest_mask().area, b = r->newest_mask().area;
    return std::make_tuple(l->is_part(), -a, l->identity.id) < std::make_tuple(r->is_part(), -b, r->identity.id);
  });
  for (std::size_t i = count; i < order_.size(); ++i) order_[i]->followed = false;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::drop_surplus(std::size_t most) {
  if (tracks_.size() <= most) return;
  order_ = all();
  std::sort(order_.begin(), order_.end(), [](const Track* l, const Track* r) {
    const bool l_seen = l->observed, r_seen = r->observed;
    return std::make_tuple(!l->is_part(), l_seen, l->outline.last_seen, l->identity.id) >
           std::make_tuple(!r->is_part(), r_seen, r->outline.last_seen, r->identity.id);
  });
  for (std::size_t i = most; i < order_.size(); ++i) order_[i]->lost = true;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
auto Tracks<Camera, Classifier, Noise, Aligner>::far_to_near() -> const List& {
  order_ = that([](const Track& t) { return t.is_shown() || t.may_come_out(); });
  const auto rank = [](const Track* t) {
    return std::make_tuple(t->observed && !t->identity.discovered, t->inverse_depth(), t->identity.id);
  };
  std::sort(order_.begin(), order_.end(), [&](const Track* l, const Track* r) { return rank(l) < rank(r); });
  return order_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::remember(Track& t, const FrameData& cur, const Setup& setup,
                                                          Worker& worker) const {
  t.motion.drop_older_references(cur.timestamp, setup.estimator.settings.reference_seconds);
  if (t.is_rejected_candidate()) return;
  if (!t.followed) {
    t.motion.forget_references(Reason::TooManyObjects);
    return;
  }
  // The time of a repeated image is too late: as a reference it would make the next motion too fast.
  if (cur.is_repeated() && !t.motion.references.empty()) return;
  tracker(setup, setup.noise).remember(cur, t.outline.visible ? &t.outline.mask : nullptr, worker.object, t.motion);
}

DOT_END_NAMESPACE
