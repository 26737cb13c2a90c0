// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// @file
/// Definitions of object_motion/object_tracker.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

/// Inputs and intermediate results of `follow`.
template <typename Camera, typename Noise, typename Aligner>
struct ObjectTracker<Camera, Noise, Aligner>::Following {
  const ObjectMotion& motion;
  const ObjectBelief& belief;
  const ObservedPlaces& places;
  const Interval& interval;
  ObjectScene<Camera> scene;
  Workspace& workspace;
  ObjectStep step;
  double evidence_variance = 0;  ///< trace of the covariance of the evidence's velocity

  const SE3d& T_c() const { return interval.camera.T_cur_prev; }
};

template <typename Camera, typename Noise, typename Aligner>
ObjectStep ObjectTracker<Camera, Noise, Aligner>::follow(const ObjectMotion& motion, const ObjectBelief& belief,
                                                         const ObservedPlaces& places, const Interval& interval,
                                                         ImageView<const std::uint8_t> nearer,
                                                         Workspace& workspace) const {
  const FrameData& cur = interval.cur;
  Following f{motion, belief, places, interval, {cur.pyramid, camera, cur.depth, nearer}, workspace, {}, 0};
  ObjectStep& step = f.step;
  step.T_o = step.T_o_outline = belief.expected_motion(interval.camera.seconds);
  if (!interval.camera.known()) {
    step.fit.reason = interval.camera.status == CameraStatus::FirstFrame ? Reason::NoReference : Reason::CameraLost;
  } else if (motion.references.empty()) {
    step.fit.reason = motion.no_reference;
  } else {
    fit_last_interval(f);
    if (step.fit.ok() && belief.knows_velocity()) use_known_velocity(f);
    fit_older(f);
  }
  return step;
}

/// Uses the newest reference that fits. If none fits, the reason is that of the newest reference.
template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::fit_last_interval(Following& f) const {
  const std::size_t recent = std::min(f.motion.references.size(), kRecent);
  for (std::size_t i = 0; i < recent && !f.step.fit.ok(); ++i) {
    const ObjectReference& reference = f.motion.references[i];
    const ReferencePair pair = pair_with_current(f, reference);
    set_starts(f, pair);
    if (!f.motion.has_T_o_now && i == 0)
      estimator.search(pair, f.scene, noise, f.workspace.aligner, f.workspace.minima, f.workspace.starts);
    const ObjectFit found = fit(f, pair);
    if (i == 0) f.step.fit = found;
    if (!found.ok()) continue;
    if (pair.camera.intervals > 1) f.step.astray_since = reference.timestamp;
    const SE3d T_prev_ref = f.T_c().inverse() * pair.camera.T_now_ref;
    f.step.T_o = T_prev_ref * found.T_o * reference.T_obj_now_ref.inverse();
    f.step.T_o_outline = f.step.T_o;
    f.step.fit = over_last_interval(found, T_prev_ref, f.interval.camera.seconds,
                                    estimator.velocity.acceleration_at(found.motion.range));
    add_evidence(f, pair, found, f.step.fit);
  }
}

/// Combines the fit with the known velocity. Where the object is a few pixels wide or half hidden, the fit is less
/// certain than the velocity before.
template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::use_known_velocity(Following& f) const {
  const double seconds = f.interval.camera.seconds;
  const KnownVelocity known{f.belief.velocity_now, f.belief.velocity_covariance, seconds};
  f.step.T_o = SE3d::translation(known.correction(f.step.fit.motion) * seconds) * f.step.T_o;
  const ObjectReference& r = f.motion.references.front();
  f.step.T_o_outline = shrink_rotation(f.step.T_o, f.step.fit, r.T_obj_now_ref * r.centroid, seconds,
                                       estimator.velocity.photometric_scale, estimator.prior);
}

/// Fits older references, up to three, as long as one may be more precise than the evidence. They are more precise for
/// an object that stands or moves steadily. For an object that has just started they give only its mean motion.
template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::fit_older(Following& f) const {
  const double seconds = f.interval.camera.seconds;
  const int count = static_cast<int>(f.motion.references.size()), step = std::max(1, count / 4);
  // A fit's error in metres is about that of the last interval's fit, so its velocity is the more precise the older the
  // reference. But the velocity may have changed since. Without that fit, the oldest reference is the first.
  const double error = f.step.fit.ok() ? f.step.fit.motion.covariance.trace() * seconds * seconds : 0;
  const auto expected_variance = [&](const ObjectReference& older) {
    const double age = f.interval.cur.timestamp - older.timestamp;
    const double floor = estimator.velocity.floor_at(older.centroid.z());
    const double acceleration = estimator.velocity.acceleration_at(older.centroid.z());
    return error / (age * age) + 3 * (variance_of_change(age, seconds, acceleration) + floor * floor);
  };
  struct Older {
    const ObjectReference* reference;
    double variance;  // expected
  };
  std::array<Older, kOlder> sorted{};
  std::size_t n = 0;
  const bool last_is_known = f.step.fit.ok();
  for (int i = 0; i < kOlder; ++i) {
    const int k = count - 1 - i * step;
    if (k <= 0) break;
    const ObjectReference& older = f.motion.references[static_cast<std::size_t>(k)];
    const double variance = expected_variance(older);
    std::size_t at = n++;
    for (; last_is_known && at > 0 && variance < sorted[at - 1].variance; --at) sorted[at] = sorted[at - 1];
    sorted[at] = {&older, variance};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const ObjectReference& older = *sorted[i].reference;
    if (f.step.has_evidence && sorted[i].variance >= f.evidence_variance) continue;
    const ReferencePair pair = pair_with_current(f, older);
    f.workspace.starts.assign(1, pair.camera.T_now_ref.inverse() * f.T_c() * f.step.T_o * older.T_obj_now_ref);
    // The motion of the last interval leads to within a pixel or two of the place. Coarser levels would mix the object
    // with what is beside it, and lead a slow one away.
    ObjectFit found = fit(f, pair, f.step.fit.ok() ? kOlderTop : PointSet::kMaxLevels);
    if (!found.ok()) continue;
    found.motion.is_doubtful |= f.step.fit.ok() && f.step.fit.motion.is_doubtful;  // it started there
    const ObjectFit shared = over_last_interval(found, f.T_c().inverse() * pair.camera.T_now_ref, seconds,
                                                estimator.velocity.acceleration_at(older.centroid.z()));
    add_evidence(f, pair, found, shared);
    if (f.step.fit.ok() && shared.motion.covariance.trace() < f.step.fit.motion.covariance.trace()) f.step.fit = shared;
  }
}

template <typename Camera, typename Noise, typename Aligner>
ObjectFit ObjectTracker<Camera, Noise, Aligner>::fit(const Following& f, const ReferencePair& pair,
                                                     int coarsest) const {
  return estimator.fit(pair, f.scene, f.workspace.starts, known_velocity(f, pair), noise, f.workspace.aligner,
                       f.workspace.minima, coarsest);
}

/// Takes a fit as the evidence if it is more precise than the present one. @param last its share of the last interval.
template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::add_evidence(Following& f, const ReferencePair& pair,
                                                         const ObjectFit& found, const ObjectFit& last) const {
  const double variance = last.motion.covariance.trace();
  if (found.phi < estimator.settings.min_phi || (f.step.has_evidence && variance >= f.evidence_variance)) return;
  const Matrix3<double> R_prev_ref = f.T_c().R.transpose() * pair.camera.T_now_ref.R;
  f.step.evidence = found.motion.rotated(R_prev_ref);
  f.step.has_evidence = true;
  f.evidence_variance = variance;
}

/// The fused velocity, in the axes of a reference. Empty if it is not known well enough to refuse a fit.
template <typename Camera, typename Noise, typename Aligner>
KnownVelocity ObjectTracker<Camera, Noise, Aligner>::known_velocity(const Following& f,
                                                                    const ReferencePair& pair) const {
  if (!f.belief.knows_velocity()) return {};
  const Matrix3<double> R_ref_prev = pair.camera.T_now_ref.R.transpose() * f.T_c().R;
  return {R_ref_prev * f.belief.velocity_now, R_ref_prev * f.belief.velocity_covariance * R_ref_prev.transpose(),
          f.interval.cur.timestamp - std::min(f.belief.last_fit, pair.reference.timestamp)};
}

/// Sets the starts of the alignment, the most trusted first: predicted motion, no motion, the motion of the interval
/// before, and the places where masks show the object.
template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::set_starts(const Following& f, const ReferencePair& pair) const {
  const ObjectReference& r = pair.reference;
  const SE3d& T_c = f.T_c();
  const SE3d T_ref_cur = pair.camera.T_now_ref.inverse();
  std::vector<SE3d>& out = f.workspace.starts;
  out.clear();
  const double focal = camera.intrinsics().fx;
  const auto add = [&](const SE3d& T_o) {
    const Vector3<double> moved = T_o * r.centroid;
    if (moved.z() < kNearestCentroid) return;
    for (const SE3d& other : out) {
      const Vector3<double> d = moved - other * r.centroid;
      if (focal * d.template head<2>().norm() < kSamePixels * moved.z() && std::abs(d.z()) < kSameDepth * moved.z())
        return;
    }
    out.push_back(T_o);
  };
  const SE3d T_o_predicted = f.belief.expected_motion(f.interval.camera.seconds);
  add(T_ref_cur * T_c * T_o_predicted * r.T_obj_now_ref);
  add(SE3d{});
  if (f.motion.has_T_o_now) add(T_ref_cur * T_c * f.motion.T_o_now * r.T_obj_now_ref);
  const auto add_observed = [&](const Observation& o) {
    const Vector3<double>& now = o.centre;
    if (now.z() <= 0 || r.anchor.z() <= 0) return;
    const Vector3<double> d = T_ref_cur * now - r.anchor;
    if (d.norm() > estimator.settings.max_speed * pair.seconds) return;
    const double size = o.mask.area * now.z() * now.z() / (std::max(1, r.area) * r.anchor.z() * r.anchor.z());
    if (size > kLeastSize && size < kMostSize) add(SE3d::translation(d));
  };
  if (f.places.own) return add_observed(*f.places.own);
  if (!f.places.all) return;
  // The masks nearest to the expected place.
  auto& nearest = f.workspace.nearest;
  nearest.clear();
  const Vector3<double> expected = T_c * T_o_predicted * r.T_obj_now_ref * r.anchor;
  for (const Observation& o : f.places.all->list)
    if (o.is_open(f.places.discovered) && o.centre.z() > 0)
      nearest.push_back({(o.centre - expected).squaredNorm(), &o});
  if (nearest.size() > kNearestMasks) {
    std::nth_element(nearest.begin(), nearest.begin() + kNearestMasks - 1, nearest.end());
    nearest.resize(kNearestMasks);
  }
  for (const auto& [distance, o] : nearest) add_observed(*o);
}

DOT_END_NAMESPACE
