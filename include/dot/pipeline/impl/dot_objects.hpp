// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dot/pipeline/dot.hpp"

/// @file
/// Motion of the objects: Algorithm 1 of the paper, with `continue` instead of `break`.

DOT_BEGIN_NAMESPACE

/// @param order sorted here, the nearest first
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::follow_and_decide(std::vector<TrackT*>& order) {
  std::sort(order.begin(), order.end(), [](const TrackT* l, const TrackT* r) {
    const double a = l->inverse_depth(), b = r->inverse_depth();
    return a != b ? a > b : l->id < r->id;
  });
  nearer_.resize(camera_.width(), camera_.height());
  nearer_.fill(0);
  const auto touches = [&](std::size_t nearer, std::size_t object) {
    return may_touch(*order[nearer], *order[object]);
  };
  const int rounds = rounds_of(order.size(), touches, rounds_);
  for (int round = 0; round < rounds; ++round) {
    at_once_.clear();
    for (std::size_t i = 0; i < order.size(); ++i)
      if (rounds_[i] == round) at_once_.push_back(order[i]);
    threads.run(static_cast<int>(at_once_.size()), [this](int k, int i) {
      TrackT& object = *at_once_[static_cast<std::size_t>(i)];
      Worker& worker = workers_[static_cast<std::size_t>(k)];
      follow(object, worker);
      decide(object, camera_state_.T_cur_prev.R, current_.dt);
      advance(object, worker);
    });
    for (const TrackT* object : at_once_) {
      const Mask& mask = object->observed ? *object->observed : object->predicted.mask;
      if (object->candidate || (!object->fit.ok() && !object->observed)) continue;
      mask.write(std::uint8_t{255}, nearer_);
    }
  }
}

/// Whether one object may hide a part of the other, which therefore waits for it: their outlines, as predicted and as
/// observed, with as much room around as they may move unexpectedly.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
bool Dot<Camera, Classifier, Noise, Aligner>::may_touch(const TrackT& a, const TrackT& b) {
  const auto masks_of = [](const TrackT& t) { return std::array<const Mask*, 2>{&t.predicted.mask, t.observed}; };
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

/// T_o over the last interval, and the reference that tells most about the motion: a slow object shows only against an
/// older frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::follow(TrackT& object, Worker& worker) {
  object.fit = {};
  object.has_decisive = false;
  object.T_o = object.T_o_outline = object.T_o_predicted;
  if (!camera_state_.known()) {
    object.fit.reason = camera_state_.status == CameraStatus::FirstFrame ? Reason::NoReference : Reason::CameraLost;
    return;
  }
  if (stands(object)) {
    object.fit.reason = Reason::Hidden;
    return;
  }
  if (object.references.empty()) {
    object.fit.reason = object.no_reference;
    return;
  }
  const ObjectScene<Camera> scene{current_.pyramid, camera_, current_.depth, nearer_.view()};
  const Noise noise = object.discovered ? bounded_noise() : depth_noise;
  const SE3d& T_c = camera_state_.T_cur_prev;

  const auto fit_to = [&](const ObjectReference& reference) {
    const double age = current_.timestamp - reference.timestamp;
    set_starts(object, reference, worker);
    if (!object.has_motion && &reference == &object.references.front())
      object_estimator.search(reference, scene, age, noise, worker.aligner, worker.minima, worker.starts);
    return object_estimator.fit(reference, scene, worker.starts, known_velocity(object, reference), age, noise,
                                worker.aligner, worker.minima);
  };
  // An older frame tells more of what stands or moves steadily, but of what just started only how it moved on average.
  double best = 0;
  const auto decide_by = [&](const ObjectReference& reference, const ObjectFit& fit, const ObjectFit& now) {
    const double variance = now.motion.covariance.trace();
    if (fit.phi < options_.object.min_phi || (object.has_decisive && variance >= best)) return;
    const Matrix3<double> R_prev_ref = T_c.R.transpose() * reference.T_cur_ref.R;
    object.decisive = fit.motion;
    object.decisive.velocity = R_prev_ref * fit.motion.velocity;
    object.decisive.covariance = R_prev_ref * fit.motion.covariance * R_prev_ref.transpose();
    object.has_decisive = true;
    best = variance;
  };

  // The newest reference that fits; the reason where there is none is that of the newest of all.
  const std::size_t recent = std::min<std::size_t>(object.references.size(), 3);
  for (std::size_t i = 0; i < recent && !object.fit.ok(); ++i) {
    const ObjectReference& reference = object.references[i];
    const ObjectFit fit = fit_to(reference);
    if (i == 0) object.fit = fit;
    if (!fit.ok()) continue;
    if (reference.intervals > 1) object.path.forget_after(reference.timestamp);
    object.T_o = T_c.inverse() * reference.T_cur_ref * fit.T_o * reference.T_obj_cur_ref.inverse();
    object.T_o_outline = object.T_o;
    object.fit = object_estimator.over_last_interval(fit, T_c.inverse() * reference.T_cur_ref, current_.dt);
    decide_by(reference, fit, object.fit);
  }

  // Fits of what is a few pixels wide or half hidden know less of it than its velocity before.
  if (object.fit.ok() && object.knows_velocity()) {
    const KnownVelocity known{object.velocity, object.velocity_covariance, current_.dt};
    object.T_o = SE3d::translation(known.correction(object.fit.motion) * current_.dt) * object.T_o;
    const ObjectReference& r = object.references.front();
    object.T_o_outline =
        object_estimator.turned_surely(object.T_o, object.fit, r.T_obj_cur_ref * r.centroid, current_.dt);
  }

  // Up to three older references, the oldest first.
  const int count = static_cast<int>(object.references.size());
  int last = 0;
  for (int i = 0; i < 3; ++i) {
    const int k = count - 1 - i * std::max(1, count / 4);
    if (k <= 0 || k == last) break;
    last = k;
    const ObjectReference& older = object.references[static_cast<std::size_t>(k)];
    const double age = current_.timestamp - older.timestamp;
    const double floor = options_.velocity.floor;
    const double least = 3 * (object_estimator.variance_of_change(age, current_.dt) + floor * floor);
    if (object.has_decisive && least >= best) continue;  // it cannot tell more
    const SE3d start = older.T_cur_ref.inverse() * T_c * object.T_o * older.T_obj_cur_ref;
    worker.starts.assign(1, start);
    const ObjectFit long_fit = object_estimator.fit(older, scene, worker.starts, known_velocity(object, older), age,
                                                    noise, worker.aligner, worker.minima);
    if (!long_fit.ok()) continue;
    const ObjectFit shared =
        object_estimator.over_last_interval(long_fit, T_c.inverse() * older.T_cur_ref, current_.dt);
    decide_by(older, long_fit, shared);
    if (object.fit.ok() && shared.motion.covariance.trace() < object.fit.motion.covariance.trace()) object.fit = shared;
  }
}

/// The motion from this frame back to the one before, for objects to which no earlier mask leads: of a new one masks
/// begin here, its pixels mostly do not; of one that goes behind something nearly all that earlier masks show is hidden
/// now, but what this one shows was in view.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::look_back(TrackT& object, Worker& worker) {
  if (!camera_state_.known()) return;
  const SE3d& T_c = camera_state_.T_cur_prev;
  const SE3d T_prev_cur = T_c.inverse();
  const AlignState& change = camera_state_.alignment.state;
  ObjectReference& r = worker.here;
  r.restart(current_.timestamp);
  if (make_reference(current_, *object.observed, object.observed_centre, worker, r) != Reason::None) return;
  r.advance(T_prev_cur, T_prev_cur.adjoint() * camera_state_.covariance * T_prev_cur.adjoint().transpose(),
            1 / change.gain, -change.offset / change.gain);
  const ObjectScene<Camera> scene{before().pyramid, camera_, before().depth, {}};
  KnownVelocity known;  // backwards
  worker.starts.clear();
  if (object.knows_velocity()) {
    known = {-object.velocity, object.velocity_covariance, current_.timestamp - object.last_fit};
    worker.starts.push_back(T_c * object.T_o.inverse() * T_prev_cur);
  }
  worker.starts.push_back({});
  if (!object.knows_velocity())
    object_estimator.search(r, scene, current_.dt, depth_noise, worker.aligner, worker.minima, worker.starts);
  const ObjectFit fit =
      object_estimator.fit(r, scene, worker.starts, known, current_.dt, depth_noise, worker.aligner, worker.minima);
  if (!fit.ok()) return;
  object.fit = fit.reversed(T_prev_cur);
  // Of what was carried here by the motion expected before.
  const SE3d correction = T_c * object.fit.T_o * object.T_o.inverse() * T_prev_cur;
  for (ObjectReference& older : object.references) older.T_obj_cur_ref = correction * older.T_obj_cur_ref;
  object.position = object.position.moved(correction);
  object.T_o = object.fit.T_o;
  object.has_motion = true;
  object.T_o_last = T_c * object.T_o * T_prev_cur;
  if (object.has_decisive) return;  // an older frame has told already
  // What is believed already was carried to this frame, so the evidence comes in its axes.
  object.decisive = object.fit.motion;
  object.decisive.velocity = T_c.R * object.decisive.velocity;
  object.decisive.covariance = T_c.R * object.decisive.covariance * T_c.R.transpose();
  object.has_decisive = fit.phi >= options_.object.min_phi;
  decide(object, Matrix3<double>::Identity(), 0);
}

/// The fused velocity, in the axes of a reference; nothing where it is not known well enough to refuse a fit for it.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
KnownVelocity Dot<Camera, Classifier, Noise, Aligner>::known_velocity(const TrackT& object,
                                                                      const ObjectReference& r) const {
  if (!object.knows_velocity()) return {};
  const Matrix3<double> R_ref_prev = r.T_cur_ref.R.transpose() * camera_state_.T_cur_prev.R;
  return {R_ref_prev * object.velocity, R_ref_prev * object.velocity_covariance * R_ref_prev.transpose(),
          current_.timestamp - std::min(object.last_fit, r.timestamp)};
}

/// Where the alignment begins, the most trusted first: as predicted, standing still, moving as in the interval before,
/// and where a network mask shows it.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::set_starts(const TrackT& object, const ObjectReference& r,
                                                         Worker& worker) const {
  const SE3d& T_c = camera_state_.T_cur_prev;
  std::vector<SE3d>& out = worker.starts;
  out.clear();
  const double focal = camera_.intrinsics().fx;
  const auto add = [&](const SE3d& T_o) {
    const Vector3<double> moved = T_o * r.centroid;
    if (moved.z() < 0.05) return;
    for (const SE3d& other : out) {  // the same within half a pixel and one percent of depth
      const Vector3<double> d = moved - other * r.centroid;
      if (focal * d.head<2>().norm() < 0.5 * moved.z() && std::abs(d.z()) < 0.01 * moved.z()) return;
    }
    out.push_back(T_o);
  };
  add(r.T_cur_ref.inverse() * T_c * object.T_o_predicted * r.T_obj_cur_ref);
  add(SE3d{});
  if (object.has_motion) add(r.T_cur_ref.inverse() * T_c * object.T_o_last * r.T_obj_cur_ref);
  const auto add_observed = [&](const Mask& mask, const Vector3<double>& now) {
    if (now.z() <= 0 || r.anchor.z() <= 0) return;
    const double seconds = current_.timestamp - r.timestamp;
    const Vector3<double> d = r.T_cur_ref.inverse() * now - r.anchor;
    if (d.norm() > object_estimator.settings.max_speed * seconds) return;
    const double size = mask.area * now.z() * now.z() / (std::max(1, r.area) * r.anchor.z() * r.anchor.z());
    if (size > 0.3 && size < 3.3) add(SE3d::translation(d));
  };
  if (object.observed) return add_observed(*object.observed, object.observed_centre);
  // Of masks that are of no track yet those nearest to where it should be, each of which costs an alignment.
  auto& nearest = worker.nearest;
  nearest.clear();
  const Vector3<double> expected = T_c * object.T_o_predicted * r.T_obj_cur_ref * r.anchor;
  for (const Observed& o : observed_)
    if (!o.track && o.discovered == object.discovered && o.centre.z() > 0)
      nearest.push_back({(o.centre - expected).squaredNorm(), &o});
  if (nearest.size() > kNearestMasks) {
    std::nth_element(nearest.begin(), nearest.begin() + kNearestMasks - 1, nearest.end());
    nearest.resize(kNearestMasks);
  }
  for (const auto& [distance, o] : nearest) add_observed(o->mask, o->centre);
}

/// Centre of a mask at its median depth, axes of its frame's camera; zero where it has no depth.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
Vector3<double> Dot<Camera, Classifier, Noise, Aligner>::anchor(const Mask& mask, const Image<float>& inverse_depth,
                                                                Worker& worker) const {
  std::vector<float>& q = worker.selection.values;
  q.clear();
  double u = 0, v = 0;
  int n = 0;
  const int step = sampling_step(mask.area);
  for (int y = 0; y < mask.height(); y += step)
    for (int x = 0; x < mask.width(); x += step) {
      if (!mask.pixels(x, y)) continue;
      u += mask.x + x;
      v += mask.y + y;
      ++n;
      const float value = inverse_depth(mask.x + x, mask.y + y);
      if (value > 0) q.push_back(value);
    }
  if (q.size() < 10) return Vector3<double>::Zero();
  const auto middle = q.begin() + static_cast<std::ptrdiff_t>(q.size() / 2);
  std::nth_element(q.begin(), middle, q.end());
  return camera_.template unproject<double>(Vector2<double>(u / n, v / n)) / static_cast<double>(*middle);
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::decide(TrackT& object, const Matrix3<double>& R_cur_fit, double dt) {
  if (object.fit.ok()) {
    const KnownVelocity before{object.velocity, object.velocity_covariance, current_.timestamp - object.last_fit};
    const bool agrees =
        object.has_velocity() && !before.contradicts(object.fit.motion, object_estimator.settings.max_acceleration);
    if (object.trust.accept(agrees, current_.dt)) object.last_fit = current_.timestamp;
  } else if (object.fit.reason == Reason::Implausible) {
    object.trust.refuse(current_.dt);
  }
  if (object.discovered) confirm(object);
  const Decision d = classifier(object.memory, object.has_decisive ? &object.decisive : nullptr, R_cur_fit, dt);
  object.state = object.always_dynamic ? State::Moving : d.state;
  object.p_moving = object.always_dynamic ? 1 : d.p_moving;
  object.velocity = d.velocity;
  object.velocity_covariance = d.covariance;
  if (object.state != State::NotObservable) object.last_decided = object.state;
  if (object.discovered) support(object);
}

/// Carries outline and references into this frame: standing things by T_c alone, so that their outline does not drift
/// with the noise of the fits.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::advance(TrackT& object, Worker& worker) {
  const SE3d& T_c = camera_state_.T_cur_prev;
  const bool fitted = object.fit.ok();
  for (ObjectReference& r : object.references) r.T_obj_cur_ref = T_c * object.T_o * r.T_obj_cur_ref;
  if (object.position_before.known) object.position = object.position_before.moved(T_c * object.T_o);
  const SE3d T_outline = object.state == State::Static ? SE3d{} : object.T_o_outline;
  object.T_cur_outline = T_c * T_outline * object.T_cur_outline;
  object.path.advance(T_c, T_outline);
  // The same motion seen from this camera: the prediction for the next interval.
  object.has_motion = fitted;
  if (fitted) object.T_o_last = T_c * object.fit.T_o * T_c.inverse();
  if (object.observed) return;  // the mask that the network gave serves
  // What is static was predicted by the same motion.
  const SE3d& T = object.predicted_by;
  const bool same = object.is_as_predicted && T.R == object.T_cur_outline.R && T.t == object.T_cur_outline.t;
  if (!same) warp_outline(object, object.T_cur_outline, current_.inverse_depth(), worker);
}

DOT_END_NAMESPACE
