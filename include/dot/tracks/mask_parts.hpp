// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/mask/fill_unmeasured.hpp"
#include "dot/motion/move_apart.hpp"
#include "dot/tracks/track.hpp"

DOT_BEGIN_NAMESPACE

/// Divides the masks that show two objects, as networks give them where the two touch in the image. The motion of such
/// a mask would be that of one of them, or a mean of both.
///
/// A mask is divided if each of the two has a track, and no motion of one body explains both (`move_apart`). While that
/// is not so, one object does as well. The tracks are those of objects that had masks of their own before, or those of
/// the parts of the mask before and behind a gap in depth (`DepthGap`). Each such part has a track that is not shown
/// (Track::part_of), besides that of the whole mask.
class MaskParts {
 public:
  /// What happened to a track whose mask was divided.
  struct Division {
    Track* whole;  ///< the track of the mask
    Track* part;   ///< the track of its larger part, whose motion is that of the object from now on
  };

  /// Divides masks of tracks, and adds observations of the parts of others. @param tracks all.
  /// @param camera_velocity m/s, in the axes of Track::motion. @param turn sigma of angular velocities, rad/s.
  /// @return the divided ones whose track is to go on with the motion of a part; valid until the next call.
  const std::vector<Division>& assign(const std::vector<Track*>& tracks, Observations& observations,
                                      const Vector3<double>& camera_velocity, double turn,
                                      const MaskSettings& settings) {
    divisions_.clear();
    const auto differ = [&](const PartMotion& a, const PartMotion& b) { return move_apart(a, b, camera_velocity); };
    for (Track* t : tracks) {
      if (!t->segmented || t->is_part()) continue;
      Track* other = nullptr;
      for (Track* second : tracks)
        if (shows_also(*t, *second, settings) && differ(motion_of(*t, turn), motion_of(*second, turn)) &&
            (!other || second->outline.warped.mask.area > other->outline.warped.mask.area))
          other = second;
      const bool is_divided = other && divide_by_outlines(*t, *other, observations);
      for (TwoParts& two : observations.in_two_parts) {
        if (two.whole != t->observed) continue;
        two.whole = nullptr;  // it was looked at
        if (is_divided) continue;
        const std::array<Track*, 2> parts = {track_of(two.parts[0], *t, tracks), track_of(two.parts[1], *t, tracks)};
        // If the gap is due to wrong depth of a part, that error changes with the distance, and looks like a motion
        // along the line of sight.
        const bool are_known =
            parts[0] && parts[1] && parts[0] != parts[1] && is_known(*parts[0]) && is_known(*parts[1]);
        if (are_known && differ(motion_across(*parts[0], turn), motion_of(*parts[1], turn)) &&
            differ(motion_of(*parts[0], turn), motion_across(*parts[1], turn)))
          divide(*t, parts, two, observations);
        else
          add_parts(*t, parts, two, observations);
      }
    }
    return divisions_;
  }

 private:
  static constexpr double kLeastSeparate = 0.5;  ///< of a predicted outline, that the other one must leave
  static constexpr double kLeastOverlap = 0.3;   ///< IoU of a part with its predicted outline

  /// Whether its motion is known well enough to tell it from another one.
  static bool is_known(const Track& t) {
    return t.belief.state != State::NotObservable && t.belief.knows_velocity() && t.motion.position_now.is_ahead();
  }

  /// @param turn sigma of angular velocities that are not measured, rad/s.
  static PartMotion motion_of(const Track& t, double turn) {
    PartMotion out{t.motion.position_now.at,
                   t.motion.size,
                   t.belief.velocity_now,
                   t.belief.velocity_covariance,
                   Vector3<double>(Vector3<double>::Zero()),
                   turn * turn * Matrix3<double>::Identity()};
    if (!t.motion.step.fit.ok()) return out;
    const MotionEstimate& m = t.motion.step.fit.motion;
    // The fused velocity may change until the next frame, so its covariance is larger than that of a good fit.
    constexpr double kPoorFit = 6;  // variance of a poor one, over its covariance
    if (kPoorFit * m.covariance.trace() < out.covariance.trace()) out.covariance = kPoorFit * m.covariance;
    const Matrix3<double> K = out.angular_covariance * (out.angular_covariance + m.angular_covariance).inverse();
    out.angular_velocity = K * m.angular_velocity;
    out.angular_covariance -= K * out.angular_covariance;
    return out;
  }

  /// The same without what it says of the motion along the line of sight.
  static PartMotion motion_across(const Track& t, double turn) {
    constexpr double kAny = 40;  // m/s, sigma
    PartMotion out = motion_of(t, turn);
    const Vector3<double> ray = out.at.normalized();
    out.covariance += kAny * kAny * ray * ray.transpose();
    return out;
  }

  /// Whether the mask of a track seems to show `second`, too, which the last segmentation showed beside it.
  static bool shows_also(const Track& t, const Track& second, const MaskSettings& settings) {
    if (&second == &t || second.observed || second.lost || second.identity.discovered || second.is_part()) return false;
    if (!second.outline.is_newest || second.outline.contradicted) return false;
    const Mask &whole = t.observed->mask, &own = t.outline.warped.mask, &others = second.outline.warped.mask;
    const auto is_in_whole = [&](const Mask& predicted) {
      return predicted.area >= settings.min_pixels &&
             overlap(predicted, whole) >= settings.min_containment * predicted.area;
    };
    return is_known(t) && is_known(second) && is_in_whole(own) && is_in_whole(others) &&
           overlap(own, others) < (1 - kLeastSeparate) * others.area;
  }

  /// Gives each pixel of a track's mask that just one outline has to it, and the others to the nearest one.
  /// @return whether the parts are like the outlines; if not, the mask is as it was.
  bool divide_by_outlines(Track& t, Track& other, Observations& observations) {
    const Mask &own = t.outline.warped.mask, &others = other.outline.warped.mask, &whole = t.observed->mask;
    enum Kind : std::uint8_t { kOpen, kOwn, kOthers };
    kinds_.resize(whole.width(), whole.height());
    for (int y = 0; y < whole.height(); ++y)
      for (int x = 0; x < whole.width(); ++x) {
        const bool is_own = own.at(whole.x + x, whole.y + y), is_others = others.at(whole.x + x, whole.y + y);
        kinds_(x, y) = is_own == is_others ? kOpen : is_own ? kOwn : kOthers;
      }
    fill_unmeasured(kOpen, kinds_, distances_);
    const auto is = [&](Kind kind) {
      return [this, &whole, kind](int u, int v) { return whole.at(u, v) && kinds_(u - whole.x, v - whole.y) == kind; };
    };
    fill_mask(whole.box(), is(kOwn), own_part_);
    fill_mask(whole.box(), is(kOthers), others_part_);
    if (!is_like(own_part_, own) || !is_like(others_part_, others)) return false;
    Observation &o = *t.observed, &second = add_like(o, observations);
    std::swap(o.mask, own_part_);
    std::swap(second.mask, others_part_);
    o.centre = t.expected.at;
    second.centre = other.expected.at;
    other.assign(second);
    return true;
  }

  static bool is_like(const Mask& part, const Mask& predicted) {
    const int both = overlap(predicted, part);
    return both > 0 && both >= kLeastOverlap * (predicted.area + part.area - both);
  }

  /// The track of a part of `whole`, if one was predicted there.
  static Track* track_of(const Mask& part, const Track& whole, const std::vector<Track*>& tracks) {
    for (Track* t : tracks)
      if (t->part_of == whole.identity.id && !t->observed && !t->lost && is_like(part, t->outline.warped.mask))
        return t;
    return nullptr;
  }

  /// Makes the smaller part an object of its own.
  void divide(Track& t, const std::array<Track*, 2>& parts, const TwoParts& two, Observations& observations) {
    const std::size_t larger = two.parts[0].area > two.parts[1].area ? 0 : 1, smaller = 1 - larger;
    Observation &o = *t.observed, &second = add_like(o, observations);
    o.mask = two.parts[larger], o.centre = two.centres[larger];
    second.mask = two.parts[smaller], second.centre = two.centres[smaller];
    parts[smaller]->part_of = 0;
    parts[smaller]->assign(second);
    divisions_.push_back({&t, parts[larger]});
  }

  /// Adds observations of the parts, for their tracks.
  static void add_parts(const Track& t, const std::array<Track*, 2>& parts, const TwoParts& two,
                        Observations& observations) {
    for (const std::size_t i : {0, 1}) {
      Observation& o = add_like(*t.observed, observations);
      o.mask = two.parts[i], o.centre = two.centres[i];
      o.part_of = t.identity.id;
      if (parts[i] && !parts[i]->observed) parts[i]->assign(o);
    }
  }

  /// Adds an observation that is what the network said of another one, but without pixels.
  static Observation& add_like(const Observation& whole, Observations& observations) {
    Observation& o = observations.add();
    o.instance_id = whole.instance_id;
    o.class_id = whole.class_id;
    o.score = whole.score;
    o.always_dynamic = whole.always_dynamic;
    return o;
  }

  std::vector<Division> divisions_;
  Image<std::uint8_t> kinds_;    ///< whose the pixels of a mask are
  Image<int> distances_;         ///< scratch
  Mask own_part_, others_part_;  ///< of it
};

DOT_END_NAMESPACE
