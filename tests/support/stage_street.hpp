// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dot/labels/labeller.hpp"
#include "support/stage_film.hpp"
#include "support/street.hpp"

namespace dot::test {

/// The stages of the objects and of the labels, played over `street`, with the true motion of the camera.
struct StageStreet : StageFilm {
  StageSetup setup;
  DefaultTracks tracks;
  Discovery<Pinhole, DepthNoise> discovery;
  Labeller<Pinhole, DepthNoise> labeller;
  int too_small = 0;

  StageStreet() : StageFilm(street()) { tracks.prepare({}, setup.threads); }

  /// The next frame, with its masks or without.
  void next(bool segmented) {
    advance();
    if (segmented) observe();
    play(segmented);
  }
  /// All stages on the frame at hand.
  void play(bool segmented) {
    tracks.drop_lost();
    tracks.predict(tracks.all(), interval(), setup);
    tracks.assign(observations, setup);
    tracks.follow(tracks.all(), interval(), observations, setup);
    too_small = tracks.update_masks(interval(), cur, segmented, observations, discovery, setup);
    labeller.label(tracks.far_to_near(), cur, camera_step, segmented, camera, setup.noise, setup.mask);
    for (Track* t : tracks.all()) tracks.remember(*t, *cur, setup, tracks.workers()[0]);
  }
  /// The track of an instance, or null.
  const Track* find(std::uint32_t instance) {
    for (const Track* t : tracks.all())
      if (t->identity.instance_id == instance) return t;
    return nullptr;
  }
};

}  // namespace dot::test
