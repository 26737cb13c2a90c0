// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "dot/pipeline/dot.hpp"

/// @file
/// `track` and what concerns the whole frame: camera, references, result.

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
void Dot<Camera, Classifier, Noise, Aligner>::reset() noexcept {
  has_previous_ = false;
  camera_state_ = {};
  forget_background();
  depth_learning_.forget();
  bias_learning_.forget();
  discovery_.clear();
  if constexpr (std::is_same_v<Noise, DepthNoise>)
    depth_noise.pixel_scale = depth_noise.common_scale = depth_noise.change_scale = 1;
  tracks_.clear();
  history_.clear();
  segmented_before_ = false;
  segmented_frame_.known = false;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::forget_background() noexcept {
  background_.clear();
  T_cur_background_ = {};
  background_seconds_ = 0;
  background_guessed_ = false;
  guess_covariance_.setZero();
}

/// Runs `body`. On an exception everything is forgotten: the state of half a frame is not one to go on from. OpenCV has
/// an exception of its own for a lack of memory; it leaves as std::bad_alloc.
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

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
const Result& Dot<Camera, Classifier, Noise, Aligner>::track(const Frame& frame) {
  validate(frame, camera_.width(), camera_.height(), has_previous_, current_.timestamp);
  clock_ = std::chrono::steady_clock::now();
  if (frame.masks) count_instances("frame.masks", *frame.masks);
  reset_unless_done([&] { label_objects(frame); });
  return result_;
}

/// Algorithm 1 of the paper, and what prepares the next frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::label_objects(const Frame& frame) {
  while (workers_.size() < static_cast<std::size_t>(std::max(1, threads.count)))
    workers_.push_back({aligner, {}, {}, {}, {}, {}, {}, {}, {}, {}});

  build(frame);  // pyramid, inverse depth
  take_time(Stage::Image);
  camera_motion(frame);  // T_c from the background of the previous frame, or the host's
  take_time(Stage::Camera);
  predict_tracks();  // masks warped into this frame
  observed_.clear();
  segmented_ = frame.masks.has_value();
  if (segmented_) read_masks(*frame.masks, current_.inverse_depth());
  if (options_.discover_unknown) discover();  // what moves in the background, as further masks
  associate();                                // network masks to tracks; nothing to do without
  take_time(Stage::Masks);
  follow_and_decide(all_tracks());  // Algorithm 1: T_o of each object, nearest first, and its state
  take_time(Stage::Objects);
  place_masks();  // warped by T_c T_o; new objects
  label();
  take_time(Stage::Label);
  make_references();  // points of this frame for the next ones
  take_time(Stage::Points);
  write_result(frame);
  await_masks(frame);  // which may come later
  has_previous_ = true;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::take_time(Stage stage) {
  const auto now = std::chrono::steady_clock::now();
  result_.stage_ms[static_cast<std::size_t>(stage)] = std::chrono::duration<double, std::milli>(now - clock_).count();
  clock_ = now;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::build(const Frame& frame) {
  const double interval = frame.timestamp - current_.timestamp;
  std::swap(previous_, current_);
  current_.dt = has_previous_ ? interval : 0;
  if (current_.dt > options_.max_gap) {  // too long ago to align to: keep the ids, drop what was seen
    current_.dt = 0;
    forget_background();
    depth_learning_.clear();
    discovery_.clear();
    history_.clear();
    segmented_before_ = segmented_frame_.known = false;
    for (TrackT& t : tracks_) t.references.clear(), t.no_reference = Reason::NoReference, t.has_motion = false;
  }
  current_.timestamp = frame.timestamp;
  current_.bias = bias_learning_.bias();
  background_.take(current_.bias, camera_.width(), camera_.height());
  const int levels =
      pyramid_levels(frame.image.width, frame.image.height, std::min(options_.align.max_levels, PointSet::kMaxLevels));
  threads.run(2, [&](int, int part) {
    const int width = frame.image.width, height = frame.image.height;
    if (part == 0)
      current_.pyramid.build(width, height, GreyRows(frame.image, grey_rows_), levels, kernels());
    else if (current_.bias.is_zero())
      current_.depth.build(width, height, InverseDepthRows(frame.depth, options_.selection.max_depth, kernels()),
                           levels, kernels());
    else
      current_.depth.build(
          width, height,
          UnbiasedDepthRows(frame.depth, options_.selection.max_depth, current_.bias, depth_rows_, kernels()), levels,
          kernels());
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::camera_motion(const Frame& frame) {
  CameraState& c = camera_state_;
  c.alignment = {};
  c.covariance.setZero();
  std::vector<SE3d>& predicted = camera_starts_;
  predicted.clear();
  if (frame.camera_prior) predicted.push_back(SE3d::from_row_major(*frame.camera_prior).normalized());
  predicted.push_back(SE3d::exp(c.rate * current_.dt));
  c.T_cur_prev = predicted.front();
  if (current_.dt <= 0) {
    c.status = CameraStatus::FirstFrame;
    c.T_cur_prev = {};
    c.rate_known = false;
    return;
  }
  if (frame.camera_motion) {
    c.status = CameraStatus::FromHost;
    c.T_cur_prev = SE3d::from_row_major(frame.camera_motion->T_cur_prev).normalized();
    const Eigen::Map<const Matrix6<double>, Eigen::Unaligned> covariance(frame.camera_motion->covariance.data());
    c.covariance = 0.5 * (covariance + covariance.transpose());
    const AlignProblem<Camera> problem{background_, current_.pyramid, camera_};
    c.alignment.state = workers_[0].aligner.photometry(problem, c.T_cur_prev * T_cur_background_);
    c.alignment.sigma_intensity = workers_[0].aligner.intensity_sigma(problem, c.alignment.state, 0);
  } else if (background_.size() < options_.camera.min_points) {
    c.status = CameraStatus::TooLittleDepth;
  } else {
    const SE3d T_prev_background = T_cur_background_;
    for (SE3d& T : predicted) T = T * T_prev_background;
    const auto estimate = [&](const CameraSearch* search) {
      c.alignment = camera_estimator.estimate(background_, current_.pyramid, camera_, predicted, search,
                                              workers_[0].aligner, workers_[0].minima);
    };
    const CameraSettings& s = options_.camera;
    const CameraSearch search{s.search_speed * current_.dt, s.search_turn * current_.dt, before().pyramid,
                              T_prev_background};
    estimate(c.rate_known ? nullptr : &search);
    bool ok = camera_estimator.accepts(c.alignment, c.rate_known || frame.camera_prior.has_value());
    if (!ok && c.rate_known) {  // it moved otherwise than before
      estimate(&search);
      ok = camera_estimator.accepts(c.alignment, false);
    }
    const Alignment& a = c.alignment;
    c.status = ok ? CameraStatus::Tracked : CameraStatus::Lost;
    if (ok) {
      c.T_cur_prev = a.state.T * T_prev_background.inverse();
      c.covariance = s.covariance_scale * a.covariance.template topLeftCorner<6, 6>();
    }
  }
  if (!c.known()) guess_camera_motion();
  c.rate_known = c.known();
  if (c.status == CameraStatus::Tracked && background_guessed_) {
    // The previous frame's place was a guess, and only the way since the frame before that is known well.
    const Matrix6<double> Ad = c.T_cur_prev.adjoint();
    c.covariance += Ad * guess_covariance_ * Ad.transpose();
    c.rate = c.alignment.state.T.log() / (background_seconds_ + current_.dt);
  } else if (c.known()) {
    c.rate = c.T_cur_prev.log() / current_.dt;
  }
  if constexpr (std::is_same_v<Noise, DepthNoise>) learn_depth();
}

/// The covariance of a motion of which nothing is known but its limits: uniform within what a search would look at.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::guess_camera_motion() {
  const double metres = options_.camera.search_speed * current_.dt, radians = options_.camera.search_turn * current_.dt;
  camera_state_.covariance.setZero();
  camera_state_.covariance.diagonal() << Vector3<double>::Constant(metres * metres / 3),
      Vector3<double>::Constant(radians * radians / 3);
}

/// How wrong the depth is, by what the background shows.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::learn_depth() {
  const CameraState& c = camera_state_;
  if (!c.known()) {
    depth_learning_.clear();
    return;
  }
  if (!background_guessed_)
    depth_learning_.learn(camera_, c.T_cur_prev, current_.inverse_depth(), current_.timestamp, depth_noise,
                          current_.bias);
  else
    depth_learning_.clear();
  const DepthNoiseSettings& s = depth_noise.settings;
  bias_learning_.prior = s.source == DepthSource::Stereo ? s.stereo_bias_px / depth_noise.focal_baseline : 0;
  if (background_.size() >= options_.camera.min_points)
    bias_learning_.learn(background_, current_.pyramid.levels[0], camera_, c.alignment, options_.align, current_.dt);
}

/// The tracks for which `condition` holds, by id; valid until the next call.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
template <typename Condition>
auto Dot<Camera, Classifier, Noise, Aligner>::tracks_that(Condition&& condition) -> std::vector<TrackT*>& {
  selected_.clear();
  for (TrackT& t : tracks_)
    if (condition(std::as_const(t))) selected_.push_back(&t);
  return selected_;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::make_references() {
  if (options_.discover_unknown) discovery_.remember(ids_, current_.timestamp);
  threads.run(1 + static_cast<int>(tracks_.size()), [this](int worker, int i) {
    if (i == 0)
      add_background(workers_[static_cast<std::size_t>(worker)]);
    else
      add_reference(tracks_[static_cast<std::size_t>(i - 1)], workers_[static_cast<std::size_t>(worker)]);
  });
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::add_background(Worker& worker) {
  const Selector<Camera, Noise> select = selector(current_, worker);
  // What no object covers, with a margin for ragged outlines.
  const int width = labels_.width(), height = labels_.height();
  background_mask_.resize(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* label = labels_.row(y);
    std::uint8_t* out = background_mask_.row(y);
    for (int x = 0; x < width; ++x) out[x] = label[x] ? 0 : 255;
  }
  erode<4>(std::as_const(background_mask_).view(), mask_rows_, background_mask_.view());
  if constexpr (std::is_same_v<Noise, DepthNoise>)
    depth_learning_.remember(camera_, current_.inverse_depth(), background_mask_, current_.timestamp, current_.bias);
  fresh_.clear();
  const SelectionSettings& s = options_.selection;
  select({{0, 0, camera_.width(), camera_.height()},
          background_mask_.view(),
          current_.inverse_depth().view(),
          s.background_points,
          s.window_radius,
          s.min_gradient},
         fresh_);
  result_.too_little_depth = fresh_.size() < options_.camera.min_points;
  if (result_.too_little_depth) {  // go on with the points that the camera was last aligned to
    const CameraState& c = camera_state_;
    const Matrix6<double> Ad = c.T_cur_prev.adjoint();
    T_cur_background_ = c.T_cur_prev * T_cur_background_;
    background_seconds_ += current_.dt;
    guess_covariance_ = (Ad * guess_covariance_ * Ad.transpose()).eval();
    if (!c.known()) guess_covariance_ += c.covariance, background_guessed_ = true;
  } else {
    select.sample_intensities(fresh_);
    std::swap(background_, fresh_);
    background_.bias = current_.bias;
    T_cur_background_ = {};
    background_seconds_ = 0;
    background_guessed_ = false;
    guess_covariance_.setZero();
  }
}

/// The object as its mask shows it in this frame.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::add_reference(TrackT& object, Worker& worker) {
  while (!object.references.empty() &&
         current_.timestamp - object.references.back().timestamp > options_.object.reference_seconds + 1e-6)
    object.references.pop_back();
  if (stands(object)) return;
  if (!object.followed) {
    object.references.clear();
    object.no_reference = Reason::TooManyObjects;
    return;
  }
  thin_newest(object.references, options_.object.reference_seconds);
  const Vector3<double> centre = anchor(object.mask, current_.inverse_depth(), worker);
  if (object.visible && centre.z() > 0) {
    // What is half hidden shows a part that is not its middle: then the middle is where its motion carried it.
    const double size = std::sqrt(1.0 * object.mask.area) * centre.z() / camera_.intrinsics().fx;
    if (size > 0.7 * object.size || !object.is_ahead()) object.position = {centre, true};
    object.size = std::max(object.size, size);
  }
  ObjectReference& r = object.references.push_front();
  r.restart(current_.timestamp);
  const Reason reason = object.visible ? make_reference(current_, object.mask, centre, worker, r) : Reason::Hidden;
  if (reason == Reason::None) return;
  object.references.pop_front();
  object.no_reference = reason;
}

/// Fills in what a mask shows of an object. @return why that is not enough, None if it is.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
Reason Dot<Camera, Classifier, Noise, Aligner>::make_reference(const Current& frame, const Mask& mask,
                                                               const Vector3<double>& centre, Worker& worker,
                                                               ObjectReference& r) const {
  if (mask.area < options_.selection.min_object_pixels) return Reason::TooFewPixels;
  const ObjectPoints found = select_object(selector(frame, worker), {mask.x, mask.y, mask.width(), mask.height()},
                                           mask.pixels.view(), mask.area, r.points);
  // Where a matcher finds nothing, beyond its range or in the dark, what depth there is may be its mistakes.
  if (options_.depth_noise.source != DepthSource::Lidar &&
      found.pixels_with_depth < options_.selection.min_depth_share * mask.area)
    return Reason::TooLittleDepth;
  if (r.points.size() < options_.object.min_points)
    return found.shape_known ? Reason::TooLittleTexture : Reason::TooLittleDepth;
  r.points.bias = frame.bias;
  r.centre();
  r.anchor = centre;
  r.area = found.pixels_with_depth;
  return Reason::None;
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::write_result(const Frame& frame) {
  const auto copy = [](const auto& m, auto& out) {
    for (Eigen::Index r = 0; r < m.rows(); ++r)
      for (Eigen::Index c = 0; c < m.cols(); ++c) out[static_cast<std::size_t>(r * m.cols() + c)] = m(r, c);
  };
  result_.frame_id = frame.id;
  result_.timestamp = frame.timestamp;
  result_.interval = current_.dt;
  if constexpr (std::is_same_v<Noise, DepthNoise>)
    result_.disparity_bias_px = current_.bias.is_zero() ? 0 : current_.bias.rms() * depth_noise.focal_baseline;
  const CameraState& c = camera_state_;
  CameraResult& camera = result_.camera;
  camera = {};
  camera.status = c.status;
  camera.T_cur_prev = c.T_cur_prev.row_major();
  copy(c.covariance, camera.covariance);
  camera.phi = c.alignment.phi;
  camera.gain = c.alignment.state.gain;
  camera.offset = c.alignment.state.offset;
  camera.residual_sigma = c.alignment.sigma_intensity;
  camera.normalised_variance = c.alignment.normalised_variance;
  camera.n_points = c.alignment.seen;
  camera.n_inliers = c.alignment.inliers;

  result_.small_instances = small_instances_;
  objects_.clear();
  for (const TrackT& t : tracks_) {
    if (t.candidate) continue;
    ObjectResult& o = objects_.emplace_back();
    o.id = t.id;
    o.state = t.state;
    o.last_decided = t.last_decided;
    o.reason = t.fit.reason;
    o.always_dynamic = t.always_dynamic;
    o.segmented = t.segmented;
    o.discovered = t.discovered;
    o.instance_id = o.segmented ? t.instance_id : 0;
    o.class_id = t.class_id;
    o.score = t.score;
    o.p_moving = t.p_moving;
    if (t.fit.ok()) {
      o.T_o = t.fit.T_o.row_major();
      copy(t.fit.sigma, o.covariance);
      copy(t.fit.motion.velocity, o.velocity);
      copy(t.fit.motion.covariance, o.velocity_covariance);
      o.speed = t.fit.motion.velocity.norm();
      o.disparity_px = t.fit.motion.disparity_px;
      o.disparity_noise_px = t.fit.motion.disparity_noise_px;
      o.entropy = t.fit.motion.entropy;
      o.range = t.fit.motion.range;
      o.interval = t.fit.motion.interval;
    }
    o.phi = t.fit.phi;
    o.n_points = t.fit.n_points;
    o.n_inliers = t.fit.n_inliers;
    copy(t.velocity, o.fused_velocity);
    copy(t.velocity_covariance, o.fused_covariance);
    if (t.is_shown()) {
      o.area = t.mask.area;
      o.box = t.mask.box();
    }
  }
  result_.labels = labels_.view();
  result_.ids = ids_.view();
  result_.objects = {objects_.data(), objects_.size()};
}

DOT_END_NAMESPACE
