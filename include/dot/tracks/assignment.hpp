// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "dot/mask/association.hpp"
#include "dot/tracks/track.hpp"

DOT_BEGIN_NAMESPACE

/// Assigns observations to the tracks that they continue. Compares them with the tracks' expected places in that frame.
class Assignment {
 public:
  /// Assigns by overlap: the network's observations to any track, discovered ones to tracks without a network mask.
  /// @param tracks without an observation. Observations that belong to a track already are left alone.
  void by_overlap(const std::vector<Track*>& tracks, Observations& observations, const MaskSettings& settings) {
    assign_kind(tracks, observations, false, settings);
    if (std::none_of(observations.list.begin(), observations.list.end(), is_open_discovery)) return;
    for (const bool is_candidate : {false, true}) {
      unknown_.clear();
      for (Track* t : tracks)
        if (t->identity.discovered && t->candidacy.is_candidate == is_candidate && !t->is_rejected_candidate())
          unknown_.push_back(t);
      assign_kind(unknown_, observations, true, settings);
    }
  }

  /// Assigns by place, for objects that were hidden and come out again. The part that appears first is not the part
  /// that was seen last, so the outlines do not overlap. An observation must be within the object's size of its
  /// expected place.
  void by_place(const std::vector<Track*>& tracks, Observations& observations, const MaskSettings& settings) {
    open_.clear(), workspace_.pairs.clear();
    for (Observation& o : observations.list)
      if (o.is_open(false)) open_.push_back(&o);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Vector3<double>& now = open_[i]->centre;
      if (!(now.z() > 0)) continue;
      for (std::size_t j = 0; j < tracks.size(); ++j) {
        if (tracks[j]->observed || !tracks[j]->expected.is_ahead()) continue;
        const Vector3<double>& then = tracks[j]->expected.at;
        const double size = tracks[j]->motion.size;
        const double along = std::abs(now.z() - then.z()) / std::max(settings.depth_tolerance * then.z(), size);
        if (!(along < 1)) continue;
        const double aside = (now.head<2>() / now.z() - then.head<2>() / then.z()).norm() * now.z() / size;
        if (aside < 1) workspace_.pairs.push_back({static_cast<int>(i), static_cast<int>(j), aside + along});
      }
    }
    constexpr double any_cost = std::numeric_limits<double>::infinity();
    assign_partners(tracks,
                    assign(static_cast<int>(open_.size()), static_cast<int>(tracks.size()), any_cost, workspace_));
  }

 private:
  static bool is_open_discovery(const Observation& o) { return o.is_open(true); }

  void assign_kind(const std::vector<Track*>& tracks, Observations& observations, bool discovered,
                   const MaskSettings& settings) {
    open_.clear(), predicted_.clear(), observed_.clear();
    for (const Track* t : tracks)
      predicted_.push_back({&t->outline.warped.mask, t->expected.inverse_depth(), t->motion.size});
    for (Observation& o : observations.list)
      if (o.is_open(discovered)) open_.push_back(&o), observed_.push_back({&o.mask, o.inverse_depth()});
    if (open_.empty() || predicted_.empty()) return;
    assign_partners(tracks, associate(predicted_, observed_, settings, workspace_));
  }

  void assign_partners(const std::vector<Track*>& tracks, const std::vector<int>& partner) {
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (partner[i] >= 0) tracks[static_cast<std::size_t>(partner[i])]->assign(*open_[i]);
  }

  std::vector<Observation*> open_;  ///< without a track
  std::vector<Track*> unknown_;
  std::vector<Outline> predicted_, observed_;
  SparseAssignWorkspace workspace_;
};

/// Ends the discovered tracks that another track's observation now covers, because they were parts of that object.
inline void drop_covered_candidates(const std::vector<Track*>& tracks, double min_containment) {
  for (Track* part : tracks) {
    if (!part->identity.discovered || part->observed || part->is_rejected_candidate()) continue;
    const Mask& mask = part->outline.warped.mask;
    for (const Track* whole : tracks)
      if (whole->observed && whole->candidacy.is_candidate <= part->candidacy.is_candidate &&
          whole->observed->mask.area >= mask.area && containment(whole->observed->mask, mask) > min_containment)
        part->lost = true;
  }
}

DOT_END_NAMESPACE
