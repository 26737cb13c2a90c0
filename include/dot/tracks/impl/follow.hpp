// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>

/// @file
/// Definitions of tracks/tracks.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::prepare(const Aligner& aligner, const Threads& threads) {
  while (workers_.size() < static_cast<std::size_t>(std::max(1, threads.count)))
    workers_.push_back({{aligner, {}, {}, {}, {}, {}}, {}, {}, {}, 0, 0, 0});
}

/// The tracks for which `condition` holds, by id; valid until the next call.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
template <typename Condition>
auto Tracks<Camera, Classifier, Noise, Aligner>::that(Condition&& condition) -> const List& {
  selected_.clear();
  for (ClassifiedTrack& t : tracks_)
    if (condition(static_cast<const Track&>(t))) selected_.push_back(&t);
  return selected_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
const std::vector<const PointSet*>& Tracks<Camera, Classifier, Noise, Aligner>::points_of(double timestamp) {
  points_.clear();
  for (const Track& t : tracks_) {
    if (t.identity.discovered || t.is_part()) continue;
    for (const ObjectReference& r : t.motion.references)
      if (r.timestamp == timestamp && r.points.size() > 0) points_.push_back(&r.points);
  }
  return points_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::forget_references() {
  for (Track& t : tracks_) t.motion.forget_references(Reason::NoReference), t.motion.has_T_o_now = false;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::forget_motions(double before) {
  for (ClassifiedTrack& t : tracks_) {
    t.motion.forget_before(before);
    t.belief.forget();
    t.memory = {};
    t.candidacy.tried = 0;
  }
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::predict(const List& tracks, const Interval& interval,
                                                         const Setup& setup) {
  setup.threads.run(static_cast<int>(tracks.size()), [&](int worker, int i) {
    predict(*tracks[static_cast<std::size_t>(i)], interval, setup, workers_[static_cast<std::size_t>(worker)]);
  });
}

/// The camera's motion as the rows have it that show an object. @param height of the image.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
CameraStep Tracks<Camera, Classifier, Noise, Aligner>::step_of_rows(const Track& t, const CameraStep& camera,
                                                                    int height) {
  const Mask& mask = t.observed ? t.observed->mask : t.outline.mask;
  return camera.at_row(mask.empty() ? 0 : (mask.y + 0.5 * mask.height()) / height - 0.5);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::predict(Track& t, const Interval& interval, const Setup& setup,
                                                         Worker& worker) const {
  t.segmented = false;
  t.observed = nullptr;
  const CameraStep camera = step_of_rows(t, interval.camera, setup.camera.height());
  t.outline.is_newest &= camera.known();
  // After a guessed camera motion, everything static would seem to move against earlier frames.
  if (!camera.known()) t.motion.forget_references(Reason::CameraLost);
  for (ObjectReference& r : t.motion.references)
    if (r.points.subtract_bias(interval.cur.bias, setup.camera.width(), setup.camera.height())) r.set_centroid();
  const SE3d T_o = t.is_rejected_candidate() ? SE3d{} : t.belief.expected_motion(camera.seconds);
  const SE3d T_cur_prev = camera.T_cur_prev * T_o;
  t.expected = t.motion.position_now.moved(T_cur_prev);
  const SE3d T_cur_shape = T_cur_prev * t.outline.T_now_shape;
  t.outline.predict_by(T_cur_shape, interval.cur.depth, setup.camera, setup.mask, worker.outline,
                       t.is_rejected_candidate());
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::assign(Observations& observations, const Setup& setup) {
  assignment_.by_overlap(that([](const Track& t) { return !t.is_part(); }), observations, setup.mask);
  drop_covered_candidates(all(), setup.mask.min_containment);
  divide_masks(observations, setup);
}

/// Divides the masks that show two objects. The track of such a mask goes on with the motion of its larger part.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::divide_masks(Observations& observations, const Setup& setup) {
  for (const MaskParts::Division& d :
       parts_.assign(all(), observations, camera_velocity_, setup.estimator.prior.rotation, setup.mask)) {
    Observation& observed = *d.whole->observed;
    std::swap(static_cast<ClassifiedTrack&>(*d.whole), static_cast<ClassifiedTrack&>(*d.part));
    std::swap(d.whole->identity, d.part->identity);
    std::swap(d.whole->part_of, d.part->part_of);
    d.whole->assign(observed);
    d.part->observed = nullptr;
    d.part->segmented = false;
    d.part->lost = true;
  }
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::follow(const List& tracks, const Interval& interval,
                                                        const Observations& observations, const Setup& setup) {
  order_.assign(tracks.begin(), tracks.end());
  std::sort(order_.begin(), order_.end(), [](const Track* l, const Track* r) {
    const double a = l->inverse_depth(), b = r->inverse_depth();
    return a != b ? a > b : l->identity.id < r->identity.id;
  });
  const auto waits = [&](std::size_t nearer, std::size_t object) {
    const Track &t = *order_[nearer], &hidden = *order_[object];
    return !t.segmented && may_hide(t, hidden) && may_touch(t, hidden);
  };
  const int rounds = rounds_of(order_.size(), waits, rounds_);
  for (Worker& w : workers_) w.painted = 0;
  for (int round = 0; round < rounds; ++round) {
    at_once_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i)
      if (rounds_[i] == round) at_once_.push_back(i);
    setup.threads.run(static_cast<int>(at_once_.size()), [&](int thread, int i) {
      Worker& worker = workers_[static_cast<std::size_t>(thread)];
      const std::size_t object = at_once_[static_cast<std::size_t>(i)];
      paint_nearer(object, setup.camera.width(), setup.camera.height(), worker);
      follow(*order_[object], interval, observations, setup, worker);
    });
  }
}

/// Paints where the nearer objects are that are known by now: those that a network shows in this frame, because they
/// are where their masks are, and those of earlier rounds. Of what the worker has painted before, all that is nearer
/// stays.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::paint_nearer(std::size_t object, int width, int height,
                                                              Worker& worker) const {
  const auto is_known = [&](std::size_t nearer, int round) {
    return order_[nearer]->segmented || rounds_[nearer] < round;
  };
  const Track& hidden = *order_[object];
  const auto paint = [&](std::size_t nearer) {
    const Track& t = *order_[nearer];  // if it is segmented, another thread may be following it
    if (!t.candidacy.is_candidate && may_hide(t, hidden) && (t.observed || t.motion.step.fit.ok()))
      worker.nearer.paint(t.newest_mask(), 255);
  };
  const int round = rounds_[object];
  const bool starts_again = worker.painted == 0 || object < worker.painted || worker.painted_for != hidden.part_of;
  if (starts_again) worker.nearer.clear(width, height), worker.painted = 0;
  worker.painted_for = hidden.part_of;
  for (std::size_t nearer = 0; nearer < worker.painted; ++nearer)
    if (!is_known(nearer, worker.round) && is_known(nearer, round)) paint(nearer);
  for (; worker.painted < object; ++worker.painted)
    if (is_known(worker.painted, round)) paint(worker.painted);
  worker.round = round;
}

/// Whether a nearer track counts as hiding another one. A part of a mask is hidden by its other part instead of by the
/// whole. It hides no other object: the whole does.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
bool Tracks<Camera, Classifier, Noise, Aligner>::may_hide(const Track& nearer, const Track& hidden) {
  return nearer.is_part() ? nearer.part_of == hidden.part_of : nearer.identity.id != hidden.part_of;
}

/// Whether one object may hide a part of the other. Compares their predicted and observed outlines, with a margin for
/// unexpected motion.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
bool Tracks<Camera, Classifier, Noise, Aligner>::may_touch(const Track& a, const Track& b) {
  const auto masks_of = [](const Track& t) {
    return std::array<const Mask*, 2>{&t.outline.warped.mask, t.observed ? &t.observed->mask : nullptr};
  };
  for (const Mask* l : masks_of(a))
    for (const Mask* r : masks_of(b)) {
      if (!l || !r || l->empty() || r->empty()) continue;
      const int margin = kReach + (std::max(l->width(), l->height()) + std::max(r->width(), r->height())) / 4;
      if (l->x - margin < r->x + r->width() && r->x - margin < l->x + l->width() &&
          l->y - margin < r->y + r->height() && r->y - margin < l->y + l->height())
        return true;
    }
  return false;
}

/// Whether an object is predicted to be hidden or outside the image, and no mask without a track may show it. A search
/// for it would take longer than to follow an object in view, and would find something else. An outline that is empty
/// because farther depth was measured there is not out of sight: the object may have stopped.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
bool Tracks<Camera, Classifier, Noise, Aligner>::is_out_of_sight(const Track& t, const Observations& observations) {
  const WarpedMask& predicted = t.outline.warped;
  const bool is_hidden_or_outside = predicted.mask.empty() && 2 * predicted.occluded_area >= predicted.inside_area;
  const bool comes_out = t.outline.visible && !t.outline.hidden_part.mask.empty();
  if (t.observed || !is_hidden_or_outside || comes_out) return false;
  if (!t.followed || !t.belief.has_velocity() || t.motion.references.empty()) return false;
  return std::none_of(observations.list.begin(), observations.list.end(),
                      [&](const Observation& o) { return o.is_open(t.identity.discovered); });
}

/// Follows one object: estimates its step, updates its belief and moves all of it into the current frame. Outlines of
/// static objects are moved by T_c alone, so that they do not drift with the noise of the fits.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::follow(Track& t, const Interval& of_all,
                                                        const Observations& observations, const Setup& setup,
                                                        Worker& worker) const {
  const CameraStep camera = step_of_rows(t, of_all.camera, setup.camera.height());
  const Interval interval{of_all.prev, of_all.cur, camera};
  ObjectStep& step = t.motion.step;
  if (t.is_rejected_candidate() && camera.known()) {
    step = {};
    step.fit.reason = Reason::Hidden;
  } else if (is_out_of_sight(t, observations) && camera.known()) {
    step = {};
    step.T_o = step.T_o_outline = t.belief.expected_motion(camera.seconds);
    step.fit.reason = Reason::Hidden;
  } else {
    const bool discovered = t.identity.discovered;
    const bool is_first = !discovered && !t.belief.has_velocity();
    const Noise noise = discovered ? Discovery<Camera, Noise>::bounded(setup.noise) : setup.noise;
    step = tracker(setup, noise)
               .follow(t.motion, t.belief, {t.observed, &observations, discovered}, interval,
                       std::as_const(worker.nearer).image().view(), worker.object);
    if (is_first && step.fit.ok() && !FirstFit::is_sure(step.fit)) choose_first_fit(t, interval, setup, worker);
  }
  decide(t, interval.cur, camera.T_cur_prev.R, camera.seconds, camera.seconds, setup);

  const SE3d T_o_outline = t.belief.state == State::Static ? SE3d{} : step.T_o_outline;
  t.motion.advance(camera, T_o_outline);
  t.expected = t.motion.position_now;
  TrackedOutline& outline = t.outline;
  outline.T_now_shape = camera.T_cur_prev * T_o_outline * outline.T_now_shape;
  // An observed object needs no prediction, and a static one was predicted by the same motion.
  const bool same = !outline.is_coarse && outline.T_frame_shape.R == outline.T_now_shape.R &&
                    outline.T_frame_shape.t == outline.T_now_shape.t;
  if (t.observed || same) return;
  if (t.is_rejected_candidate())
    outline.complete(setup.mask, worker.outline);  // so that it does not hold its frame
  else
    outline.warp_by(outline.T_now_shape, interval.cur.inverse_depth(), setup.camera, setup.mask, worker.outline);
}

/// Replaces a first fit of low correlation by the fit from the current frame to the one before, if that is better. A
/// first fit has no expected motion to start from, and each of the two may miss the right minimum.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::choose_first_fit(Track& t, const Interval& interval,
                                                                  const Setup& setup, Worker& worker) const {
  ObjectStep& step = t.motion.step;
  std::optional<ObjectFit> back;
  if (t.observed && interval.prev)
    back = tracker(setup, setup.noise).align_backwards(t.motion, t.belief, *t.observed, interval, worker.object);
  if (back && back->phi > step.fit.phi) {
    std::swap(step.fit, *back);
    step.T_o = step.T_o_outline = step.fit.T_o;
    step.evidence = step.fit.motion;
    step.has_evidence = step.fit.phi >= setup.estimator.settings.min_phi;
  }
  if (back && FirstFit::agree(step.fit.motion, back->motion)) step.evidence.is_doubtful = false;
  if (!refuses(t.motion, step.fit, interval, setup)) return;
  step = {};
  step.T_o = step.T_o_outline = t.belief.expected_motion(interval.camera.seconds);
  step.fit.reason = Reason::LowCorrelation;
}

/// Whether a first fit is probably wrong. It correlates badly, is faster than what was searched for, and the frame
/// before had no such fit that agrees. @param first in the axes of the previous camera.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
bool Tracks<Camera, Classifier, Noise, Aligner>::refuses(ObjectMotion& motion, const ObjectFit& first,
                                                         const Interval& interval, const Setup& setup) {
  const ObjectSettings& settings = setup.estimator.settings;
  if (FirstFit::is_sure(first) || first.motion.velocity.norm() <= settings.search_speed) return false;
  const KnownVelocity doubted{motion.doubted.velocity, motion.doubted.covariance, interval.camera.seconds};
  if (interval.prev && motion.doubted_at == interval.prev->timestamp &&
      !doubted.contradicts(first.motion, settings.max_acceleration))
    return false;
  motion.doubted = first.motion.rotated(interval.camera.T_cur_prev.R);
  motion.doubted_at = interval.cur.timestamp;
  return true;
}

/// Updates the belief by the step. @param R_cur_fit rotates from the fit's axes to the current camera's.
/// @param seconds since the frame before. @param dt seconds by which the classifier predicts.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Tracks<Camera, Classifier, Noise, Aligner>::decide(Track& t, const FrameData& cur,
                                                        const Matrix3<double>& R_cur_fit, double seconds, double dt,
                                                        const Setup& setup) const {
  const ObjectStep& step = t.motion.step;
  const ObjectMotionEstimator& estimator = setup.estimator;
  const bool repeated = cur.is_repeated();
  if (!repeated) t.belief.check_velocity(step.fit, estimator.settings.max_acceleration, cur.timestamp, seconds);
  if (t.identity.discovered && !repeated) t.candidacy.confirm(step, t.belief, estimator.velocity, seconds);
  auto& memory = static_cast<ClassifiedTrack&>(t).memory;
  t.belief.adopt(setup.classifier(memory, step.has_evidence && !repeated ? &step.evidence : nullptr, R_cur_fit, dt));
  if (t.identity.discovered) t.candidacy.decide(t.belief.state);
}

DOT_END_NAMESPACE
