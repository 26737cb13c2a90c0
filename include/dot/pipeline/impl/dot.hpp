// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include <opencv2/core.hpp>

#include "dot/frame/validate.hpp"
#include "dot/pipeline/validate_options.hpp"
#include "dot/tracks/explained_pixels.hpp"

/// @file
/// Definitions of pipeline/dot.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
Dot<Camera, Classifier, Noise, Aligner>::Dot(const Camera& camera, const Options& options)
    : camera_(camera), options_(options) {
  validate(options);
  if constexpr (std::is_constructible_v<Noise, DepthNoiseSettings, Intrinsics>)
    depth_noise = Noise(options.depth_noise, camera.intrinsics());
  aligner.settings = options.align;
  camera_estimator.settings = options.camera;
  object_estimator = {options.object, options.motion_prior, options.velocity};
  threads.count = options.threads;
  if constexpr (std::is_same_v<Classifier, EntropyClassifier>) {
    classifier.settings = options.entropy;
    classifier.literal = options.classifier == ClassifierKind::EntropyLiteral;
  } else if constexpr (std::is_same_v<Classifier, VelocityClassifier> ||
                       std::is_same_v<Classifier, SingleFrameClassifier>) {
    classifier.settings = options.velocity;
  }
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
const Result& Dot<Camera, Classifier, Noise, Aligner>::track(const Frame& frame) {
  label(frame);
  prepare();
  return result_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
const Result& Dot<Camera, Classifier, Noise, Aligner>::label(const Frame& frame) {
  check([&] {
    validate(frame, camera_.width(), camera_.height(), current_ != nullptr, current_ ? current_->timestamp : 0);
    if (frame.masks) count("frame.masks", *frame.masks);
  });
  prepare();
  stopwatch_.start();
  reset_unless_done([&] { label_objects(frame); });
  return result_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::prepare() {
  if (!unprepared_) return;
  const Labelled labelled = *unprepared_;
  unprepared_.reset();
  stopwatch_.start();
  reset_unless_done([&] { prepare_next(labelled.camera, labelled.segmented); });
}

/// Algorithm 1 of the paper.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::label_objects(const Frame& frame) {
  const auto ends = [this](Stage stage) { result_.stage_ms[static_cast<std::size_t>(stage)] = stopwatch_.lap(); };
  tracks_.prepare(aligner, threads);
  const bool segmented = frame.masks.has_value();

  const double seconds = start_interval(frame.timestamp);
  previous_ = std::move(current_);
  current_ = frames_.add(frame, camera_tracker_.depth_bias(), depth_noise,
                         {std::min(options_.align.max_levels, PointSet::kMaxLevels), options_.selection.max_depth,
                          unmeasured_from(frame.depth)},
                         kernels(), threads, seconds > 0 ? previous_.get() : nullptr);
  const FrameData& cur = *current_;
  ends(Stage::Image);

  // T_c from the background of the previous frame, or the host's. Meanwhile the masks of the network are read.
  CameraStep camera_step;
  observations_.clear();
  threads.run(segmented ? 2 : 1, [&](int, int task) {
    if (task == 0) {
      camera_step = track_camera(frame, seconds);
      ends(Stage::Camera);
    } else {
      observations_.read(*frame.masks, cur.inverse_depth(), camera_, depth_noise);
    }
  });
  if (camera_tracker_.refuted()) forget_wrong_motions();
  late_masks_.advance(camera_step);
  if (camera_step.known())
    saturation_.moved(camera_step.T_cur_prev);
  else
    saturation_.forget_motion();

  // Noise of the depth. Predicted places of the objects. Masks of moving regions in the background.
  const Interval interval{previous_.get(), cur, camera_step};
  drop_lost();
  learn_and_predict(interval);
  if (options_.discover_unknown) discover(cur, camera_step);
  tracks_.assign(observations_, setup());
  ends(Stage::Masks);

  // T_o of each object, the nearest first, and its state.
  tracks_.follow(tracks_.all(), interval, observations_, setup());
  ends(Stage::Objects);

  // Masks warped by T_c T_o; new objects; labels.
  result_.small_instances = tracks_.update_masks(interval, current_, segmented, observations_, discovery_, setup());
  labeller_.label(tracks_.far_to_near(), current_, camera_step, segmented, camera_, depth_noise, options_.mask);
  write_result(frame, camera_step);
  unprepared_ = {camera_step, segmented};
  ends(Stage::Label);
}

/// @return metres; depth from there on says only that the scene is as far or farther. A sensor that is known has no
/// pile.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
double Dot<Camera, Classifier, Noise, Aligner>::unmeasured_from(const ImageRef& depth) {
  const double max_depth = options_.selection.max_depth, saturated = saturation_.update(depth, max_depth);
  if (options_.depth_noise.source != DepthSource::Unknown) return saturated;
  return std::min(saturated, far_pile_.update(depth, max_depth));
}

/// @param seconds since the previous frame, 0 if there is none to align to.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
CameraStep Dot<Camera, Classifier, Noise, Aligner>::track_camera(const Frame& frame, double seconds) {
  auto& worker = tracks_.workers()[0].object;
  return camera_tracker_.track(previous_, *current_, seconds, {frame.camera_motion, frame.camera_prior},
                               tracks_.points_of(previous_ ? previous_->timestamp : 0), camera_, camera_estimator,
                               worker.aligner, worker.minima);
}

/// Stores what the next frames are compared with, and looks for mistakes in the input.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::prepare_next(const CameraStep& camera_step, bool segmented) {
  remember(camera_step);
  frames_.prepare_second();
  const double step = previous_ ? current_->timestamp - previous_->timestamp : 0;
  Noticed noticed;
  noticed.masked = result_.too_little_depth ? labeller_.labels().share() : 0;
  noticed.saturated = std::max(saturation_.share(), far_pile_.share());
  noticed.fixed = camera_tracker_.fixed_share();
  noticed.row_turn = camera_step.rolling.turn.norm();
  noticed.scale_sigma = camera_tracker_.scale_sigma();
  noticed.distortion = camera_tracker_.distortion(camera_);
  noticed.host_error = camera_tracker_.host_error();
  result_.diagnosis = watch_.update(*current_, depth_noise, step, options_.max_gap, result_.too_little_depth, noticed);
  late_masks_.await(current_, camera_step, segmented, options_.mask, tracks_.all());
  result_.stage_ms[static_cast<std::size_t>(Stage::Points)] = stopwatch_.lap();
}

/// Learns the depth's noise from the background, and predicts the places of the objects, which does not need it.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::learn_and_predict(const Interval& interval) {
  const std::vector<Track*>& tracks = tracks_.all();
  const Setup setup = this->setup();
  threads.run(1 + static_cast<int>(tracks.size()), [&](int thread, int i) {
    auto& worker = tracks_.workers()[static_cast<std::size_t>(thread)];
    if (i > 0) return tracks_.predict(*tracks[static_cast<std::size_t>(i - 1)], interval, setup, worker);
    camera_tracker_.learn_depth(interval.cur, interval.camera, camera_, options_.align,
                                camera_estimator.settings.min_points, depth_noise);
  });
}

/// Forgets what was concluded from motions of the camera that the newest one proved to be wrong.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::forget_wrong_motions() {
  tracks_.forget_motions(previous_->timestamp);
  late_masks_.revise(camera_tracker_.revised());
  labeller_.forget();
  discovery_.clear();
}

/// @return seconds since the previous frame; 0 if there is none to align to. After too long a gap the ids are kept, but
/// the earlier frames are dropped.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
double Dot<Camera, Classifier, Noise, Aligner>::start_interval(double timestamp) {
  const double seconds = current_ ? timestamp - current_->timestamp : 0;
  if (seconds <= options_.max_gap) return seconds;
  camera_tracker_.forget_frames();
  discovery_.clear();
  late_masks_.clear();
  labeller_.forget();
  tracks_.forget_references();
  return 0;
}

/// Adds the regions that contradict a static scene to the observations. Like those of the network they get a track,
/// fits and a belief. Until the belief is decided *moving* the track is a candidate and is not shown.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::discover(const FrameData& cur, const CameraStep& camera_step) {
  if (!camera_step.known() || !camera_tracker_.is_sure()) discovery_.clear();
  discovery_.advance(camera_step.T_cur_prev, camera_step.covariance, camera_step.alignment.state.gain,
                     camera_step.alignment.state.offset);
  explained_.resize(camera_.width(), camera_.height());
  explain_pixels<Discovery<Camera, Noise>>(tracks_.all(), observations_, cur.inverse_depth(), explained_);
  discovery_.find(camera_, discovery_.bounded(depth_noise), cur.pyramid, cur.depth, explained_, cur.timestamp);
  for (Mask& mask : discovery_.masks) observations_.add_discovered(mask, cur.inverse_depth(), camera_);
}

/// Stores the data that the next frames are compared with: points of the background and of each object.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::remember(const CameraStep& camera_step) {
  const FrameData& cur = *current_;
  const std::vector<Track*>& tracks = tracks_.all();
  const auto is_discovered = [&](std::uint32_t id) {
    const auto at = std::lower_bound(tracks.begin(), tracks.end(), id,
                                     [](const Track* t, std::uint32_t wanted) { return t->identity.id < wanted; });
    return at != tracks.end() && (*at)->identity.id == id && (*at)->identity.discovered;
  };
  if (options_.discover_unknown) discovery_.remember(labeller_.ids(), is_discovered, cur.timestamp);
  // What was cut off a mover's box may still be the mover's: the camera must not follow it.
  boxes_of_movers_.clear();
  for (const Track* t : tracks)
    if (t->observed && t->observed->cut_from[2] > 0 && t->belief.state == State::Moving)
      boxes_of_movers_.push_back(t->observed->cut_from);
  camera_tracker_.find_fixed_parts(cur, camera_step, labeller_.labels(), labeller_.ids(), boxes_of_movers_, camera_,
                                   kernels(), threads);
  const Setup setup = this->setup();
  threads.run(1 + static_cast<int>(tracks.size()), [&](int thread, int i) {
    auto& worker = tracks_.workers()[static_cast<std::size_t>(thread)];
    if (i > 0) return tracks_.remember(*tracks[static_cast<std::size_t>(i - 1)], cur, setup, worker);
    const Selector<Camera, Noise> select{
        camera_,  depth_noise, cur.pyramid, cur.inverse_depth().view(), options_.selection, worker.object.selection,
        kernels()};
    result_.too_little_depth =
        !camera_tracker_.take_background(cur, camera_step, select, camera_estimator.settings.min_points);
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::submit_masks(std::uint64_t frame_id, const Masks& masks) {
  check([&] {
    validate("masks", masks, camera_.width(), camera_.height());
    count("masks", masks);
  });
  prepare();
  const auto then = late_masks_.frames().find(frame_id);
  if (then == late_masks_.frames().end())
    bad_field("frame_id", std::to_string(frame_id) + " is none of the frames since the last segmentation, up to " +
                              to_text(options_.mask.late_seconds) + " s ago and " +
                              std::to_string(options_.mask.late_frames) + " at most");
  reset_unless_done([&] {
    tracks_.prepare(aligner, threads);
    drop_lost();
    late_masks_.apply(then, masks, current_->timestamp, {tracks_, observations_, labeller_, setup()});
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::count(const char* field, const Masks& masks) {
  observations_.count(field, masks, options_.mask.max_instances, camera_.width(), camera_.height());
}

/// Runs `body`, which refuses input. That changes nothing, but a lack of memory resets, as it does everywhere.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
template <typename Body>
void Dot<Camera, Classifier, Noise, Aligner>::check(Body&& body) {
  try {
    body();
  } catch (const std::bad_alloc&) {
    reset();
    throw;
  }
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::reset() noexcept {
  unprepared_.reset();
  dropped_.clear();
  current_.reset();
  previous_.reset();
  saturation_.forget();
  far_pile_.forget();
  camera_tracker_.forget();
  discovery_.clear();
  late_masks_.clear();
  watch_.forget();
  labeller_.forget();
  tracks_.clear();
  if constexpr (std::is_same_v<Noise, DepthNoise>) depth_noise.forget_scales();
}

/// Runs `body`. Resets on an exception, because a partly processed frame leaves no valid state. OpenCV has its own
/// exception for a lack of memory; it is rethrown as std::bad_alloc.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
template <typename Body>
void Dot<Camera, Classifier, Noise, Aligner>::reset_unless_done(Body&& body) {
  try {
    body();
  } catch (const cv::Exception& e) {
    reset();
    if (e.code == cv::Error::StsNoMem) throw std::bad_alloc();
    throw;
  } catch (...) {
    reset();
    throw;
  }
}

DOT_END_NAMESPACE
