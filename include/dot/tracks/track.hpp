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

/// Who an object is.
struct Identity {
  std::uint32_t id = 0;           ///< never reused
  std::uint32_t instance_id = 0;  ///< of the last observation of a network
  std::int32_t class_id = -1;
  float score = 0;
  bool discovered = false;  ///< found by its motion; no network mask so far
};

/// One object over time.
struct Track {
  Identity identity;
  TrackedOutline outline;
  ObjectMotion motion;
  ObjectBelief belief;
  Candidacy candidacy;  ///< of what was discovered

  // In the frame at hand.
  const Observation* observed = nullptr;  ///< what was assigned to it
  bool segmented = false;                 ///< that is a network's
  Place expected;                         ///< where its middle should be; where its motion led, once that is known
  bool followed = true;                   ///< its motion is estimated: it is among the largest
  bool lost = false;                      ///< to be dropped before the next frame

  /// Makes it a new object, in the memory of the one it was.
  void restart(std::uint32_t id) {
    Track fresh;
    fresh.identity.id = id;
    outline.shape.clear();
    outline.hidden_part.clear();
    outline.warped.clear();
    outline.mask.clear();
    motion.references.clear();
    motion.path.clear();
    std::swap(fresh.outline.shape, outline.shape);
    std::swap(fresh.outline.hidden_part, outline.hidden_part);
    std::swap(fresh.outline.warped, outline.warped);
    std::swap(fresh.outline.mask, outline.mask);
    std::swap(fresh.motion.references, motion.references);
    std::swap(fresh.motion.path, motion.path);
    *this = std::move(fresh);
  }

  /// Begins with what was observed. After `restart`.
  void start(Observation& o) {
    o.assigned = true;
    observed = &o;
    identify(o);
    segmented = !o.discovered;
    identity.discovered = candidacy.is_candidate = o.discovered;
    motion.step.fit.reason = Reason::New;
    if (belief.always_dynamic) belief.take({});
  }

  /// Goes on with what was observed.
  void assign(Observation& o) {
    o.assigned = true;
    observed = &o;
    if (o.discovered) return;
    identify(o);
    segmented = true;
    identity.discovered = candidacy.is_candidate = false;
  }

  /// A candidate that turned out to stand is remembered for a while, lest it is found again, and not followed.
  bool is_rejected_candidate() const { return candidacy.is_candidate && belief.state == State::Static; }

  bool is_shown() const { return outline.visible && !lost && !candidacy.is_candidate; }

  /// Whether nothing of it is in view but what an earlier mask showed of it may come out.
  bool may_come_out() const {
    return !outline.visible && !outline.hidden_part.mask.empty() && !lost && !candidacy.is_candidate &&
           !outline.contradicted;
  }

  /// What it covers in the frame at hand: what was observed, else what was expected.
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
    belief.always_dynamic = o.always_dynamic;
  }
};

DOT_END_NAMESPACE
