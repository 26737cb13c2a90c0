// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>

#include "dot/discovery/candidacy.hpp"
#include "dot/mask/observations.hpp"
#include "dot/object_motion/belief.hpp"
#include "dot/object_motion/object_motion.hpp"
#include "dot/tracks/outline.hpp"

DOT_BEGIN_NAMESPACE

/// Identity of an object.
struct Identity {
  std::uint32_t id = 0;           ///< never reused
  std::uint32_t instance_id = 0;  ///< of the last observation by a network
  std::int32_t class_id = -1;     ///< of the last observation, -1 = unknown
  float score = 0;                ///< of the last observation
  bool discovered = false;        ///< found by its motion; no network mask so far
};

/// One object over time.
struct Track {
  Identity identity;          ///< its numbers
  TrackedOutline outline;     ///< where it is
  ObjectMotion motion;        ///< how it moved
  ObjectBelief belief;        ///< whether it moves
  Candidacy candidacy;        ///< used for discovered objects
  std::uint32_t part_of = 0;  ///< id of the track whose mask it is a part of, see MaskParts; 0: it is no part

  // State in the current frame.
  Observation* observed = nullptr;  ///< the observation assigned to it
  bool segmented = false;           ///< whether that is a network's
  Place expected;                   ///< predicted place of its middle; the followed place once its motion is known
  bool followed = true;             ///< its motion is estimated, because it is among the largest
  bool lost = false;                ///< to be dropped before the next frame

  /// Makes it a new object and reuses the memory of the old one.
  void restart(std::uint32_t id) {
    Track fresh;
    fresh.identity.id = id;
    outline.shape.clear();
    outline.coarse.clear();
    outline.surface.clear();
    outline.hidden_part.clear();
    outline.warped.clear();
    outline.mask.clear();
    motion.references.clear();
    motion.path.clear();
    std::swap(fresh.outline.shape, outline.shape);
    std::swap(fresh.outline.coarse, outline.coarse);
    std::swap(fresh.outline.surface, outline.surface);
    std::swap(fresh.outline.hidden_part, outline.hidden_part);
    std::swap(fresh.outline.warped, outline.warped);
    std::swap(fresh.outline.mask, outline.mask);
    std::swap(fresh.motion.references, motion.references);
    std::swap(fresh.motion.path, motion.path);
    *this = std::move(fresh);
  }

  /// Starts the track with an observation. Call it after `restart`.
  void start(Observation& o) {
    o.assigned = true;
    observed = &o;
    identify(o);
    segmented = !o.discovered;
    identity.discovered = candidacy.is_candidate = o.discovered;
    part_of = o.part_of;
    motion.step.fit.reason = Reason::New;
  }

  /// Continues the track with an observation.
  void assign(Observation& o) {
    o.assigned = true;
    observed = &o;
    if (o.discovered) return;
    identify(o);
    segmented = true;
    identity.discovered = candidacy.is_candidate = false;
  }

  /// A candidate that turned out to stand still, or that is no moving object, is not followed. It is kept for a while,
  /// so that it is not found again.
  bool is_rejected_candidate() const {
    return candidacy.is_candidate && (belief.state == State::Static || candidacy.has_failed());
  }

  /// Whether it is a part of another track's mask. Labels and results then show only that one.
  bool is_part() const { return part_of != 0; }

  /// Whether labels and results show it with its pixels.
  bool is_shown() const { return outline.visible && !lost && !candidacy.is_candidate && !is_part(); }

  /// Whether results name it. Of a discovered object that is a candidate again they say that it is hidden.
  bool is_reported() const { return !is_part() && (!candidacy.is_candidate || candidacy.was_reported); }

  /// Whether no part of it is visible, but a part that an earlier mask showed may come out.
  bool may_come_out() const {
    return !outline.visible && !outline.hidden_part.mask.empty() && !lost && !candidacy.is_candidate && !is_part() &&
           !outline.contradicted;
  }

  /// Its mask in the current frame: the observed one, else the predicted one.
  const Mask& newest_mask() const { return observed ? observed->mask : outline.warped.mask; }

  /// 1/m; nearer objects are followed first and painted last.
  double inverse_depth() const {
    if (!motion.references.empty()) {
      const ObjectReference& r = motion.references.front();
      const double z = (r.T_obj_now_ref * r.centroid).z();
      if (z > 0) return 1 / z;
    }
    return outline.shape.median;
  }

 private:
  void identify(const Observation& o) {
    identity.instance_id = o.instance_id;
    identity.class_id = o.class_id;
    identity.score = o.score;
    belief.declare(o.always_dynamic);
  }
};

DOT_END_NAMESPACE
