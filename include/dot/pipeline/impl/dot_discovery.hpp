// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "dot/pipeline/dot.hpp"

/// @file
/// Things that no mask shows.

DOT_BEGIN_NAMESPACE

/// Adds the regions that contradict a standing scene to the observed masks. They go the way of the network's: a track,
/// fits, a belief. Until that is decided *moving* the track is a candidate, of which nothing is shown.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::discover() {
  const CameraState& c = camera_state_;
  if (!c.known() || background_guessed_) discovery_.clear();
  discovery_.advance(c.T_cur_prev, c.covariance, c.alignment.state.gain, c.alignment.state.offset);
  blocked_.resize(camera_.width(), camera_.height());
  blocked_.fill(0);
  const auto mark = [&](const Mask& mask, std::uint8_t number) { mask.write(number, blocked_); };
  std::uint8_t number = 0;
  for (const TrackT& t : tracks_) {
    if (stands(t)) {
      const WarpedMask& m = t.predicted;
      for (int y = 0; y < m.mask.height(); ++y)
        for (int x = 0; x < m.mask.width(); ++x) {
          const float q = m.inverse_depth(x, y), now = current_.inverse_depth()(m.mask.x + x, m.mask.y + y);
          if (q > 0 && now > 0 && std::abs(now - q) < kSameSurface * q)
            blocked_(m.mask.x + x, m.mask.y + y) = discovery_.kStanding;
        }
    } else if (t.discovered && !t.candidate) {
      number = static_cast<std::uint8_t>(number % (discovery_.kStanding - 1) + 1);
      mark(t.predicted.mask, number);
    }
  }
  for (const TrackT& t : tracks_)
    if (!t.discovered) mark(t.predicted.mask, discovery_.kCovered);
  for (const Observed& o : observed_) mark(o.mask, discovery_.kCovered);
  discovery_.find(camera_, bounded_noise(), current_.pyramid, current_.depth, blocked_, current_.timestamp);
  for (Mask& mask : discovery_.masks) {
    Observed& o = observe();
    std::swap(o.mask, mask);
    o.centre = anchor(o.mask, current_.inverse_depth(), workers_[0]);
    o.discovered = true;
  }
}

/// The depth noise for what no mask shows. Unknown movers teach it too, as background, and must not hide themselves.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
Noise Dot<Camera, Classifier, Noise, Aligner>::bounded_noise() const {
  Noise noise = depth_noise;
  if constexpr (std::is_same_v<Noise, DepthNoise>) {
    noise.common_scale = std::min(noise.common_scale, kMaxLearntScale);
    noise.change_scale = std::min(noise.change_scale, kMaxLearntScale);
  }
  return noise;
}

/// Ends the discovered tracks that a mask of another track covers by now: they were parts of it.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::absorb() {
  for (TrackT& part : tracks_) {
    if (!part.discovered || part.observed || stands(part)) continue;
    for (const TrackT& whole : tracks_)
      if (whole.observed && whole.candidate <= part.candidate && whole.observed->area >= part.predicted.mask.area &&
          containment(*whole.observed, part.predicted.mask) > options_.mask.min_containment)
        part.lost = true;
  }
}

/// Weighs this frame's fit of a discovered object, before its belief does. A region that is not one rigid thing, or
/// matches itself elsewhere, also finds a motion, but another one each time. A fit confirms when it excludes speeds
/// up to v0 and agrees with the velocity fused so far, both at 99 %.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::confirm(TrackT& object) {
  constexpr double chi2 = 11.345;  // 99 % of three degrees of freedom
  const Reason reason = object.fit.reason;
  if (reason == Reason::Occluded || reason == Reason::LeavesImage || reason == Reason::Hidden) return;
  bool agrees = object.fit.ok();
  if (agrees) {
    if (!(object.velocity_covariance.trace() > 0)) return;  // the first
    const MotionEstimate& m = object.fit.motion;
    const Vector3<double> d = m.velocity - object.velocity;
    agrees = d.dot((m.covariance + object.velocity_covariance).ldlt().solve(d)) < chi2;
    SingleFrameClassifier::Memory none;
    agrees = agrees && object.has_decisive &&
             SingleFrameClassifier{options_.velocity}(none, &object.decisive, Matrix3<double>::Identity(), current_.dt)
                     .state == State::Moving;
  }
  object.confirmed = std::clamp(object.confirmed + (agrees ? 1 : -1) * current_.dt, 0.0, kMaxConfirmedSeconds);
}

/// Decides whether a discovered object is shown: while its belief is *moving* and the pixels under its mask go on
/// contradicting a standing scene. The fits alone can be wrong for long: a wall that slides along itself correlates
/// with itself.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::support(TrackT& object) {
  const double now = discovery_.support(object.observed ? *object.observed : object.predicted.mask);
  object.support += (now - object.support) * std::min(1.0, current_.dt / kSupportSeconds);
  object.candidate =
      object.state != State::Moving || object.support < kMinSupport || object.confirmed < kConfirmedSeconds;
}

DOT_END_NAMESPACE
