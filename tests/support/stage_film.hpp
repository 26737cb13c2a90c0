// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/discovery/discovery.hpp"
#include "dot/frame/frame_store.hpp"
#include "dot/pipeline/compiled.hpp"
#include "dot/tracks/tracks.hpp"
#include "support/film.hpp"

/// @file
/// A film as the stages of the pipeline see it, each of which can thus be tested alone.

namespace dot::test {

/// Frames of a film with pyramids, the camera's true motion, and the true masks as observations.
class StageFilm {
 public:
  Film<> film;
  CameraStep camera_step;
  FramePtr cur, prev;
  Observations observations;

  explicit StageFilm(Film<> of) : film(std::move(of)) {}

  void advance() {
    const Frame& frame = film.advance();
    prev = cur;
    cur = store_.add(frame, {}, DepthNoise({}, small_camera()), {4, 400}, portable_kernels(), Threads{}, prev.get());
    camera_step = {};
    if (prev) {
      camera_step.status = CameraStatus::FromHost;
      camera_step.seconds = cur->timestamp - prev->timestamp;
      camera_step.T_cur_prev = film.T_c();
      camera_step.covariance = 1e-8 * Matrix6<double>::Identity();
    }
    observations.list.clear();
  }

  /// Adds the masks of this frame.
  void observe() {
    const Masks masks = *film.frame().masks;
    observations.count("masks", masks, 100, camera.width(), camera.height());
    observations.read(masks, cur->inverse_depth(), camera, DepthNoise({}, small_camera()));
  }

  Interval interval() const { return {prev.get(), *cur, camera_step}; }

  Mask mask(std::uint32_t id) const {
    Mask out;
    crop_ids<std::uint32_t>(film.seen().ids.view(), id, {0, 0, camera.width(), camera.height()}, out);
    return out;
  }

  const Pinhole camera{small_camera()};

 private:
  FrameStore store_;
};

/// The policies and settings of the objects' stages.
struct StageSetup {
  using Setup = TrackingSetup<Pinhole, VelocityClassifier, DepthNoise>;

  Pinhole camera{small_camera()};
  VelocityClassifier classifier;
  DepthNoise noise{{}, small_camera()};
  ObjectMotionEstimator estimator;
  MaskSettings mask;
  SelectionSettings selection;
  OverlaidPixels overlaid;
  Threads threads;

  operator Setup() const {
    return {camera,    classifier,        noise,    estimator,          mask,
            selection, DepthSource::Rgbd, overlaid, portable_kernels(), threads};
  }
};

using DefaultTracks = Tracks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>>;

}  // namespace dot::test
