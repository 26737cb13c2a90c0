// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "dot/camera_motion/camera_tracker.hpp"
#include "dot/diagnosis/watch.hpp"
#include "dot/discovery/discovery.hpp"
#include "dot/frame/depth_saturation.hpp"
#include "dot/frame/far_pile.hpp"
#include "dot/frame/frame_store.hpp"
#include "dot/kernel/portable_kernels.hpp"
#include "dot/labels/labeller.hpp"
#include "dot/late_masks/late_masks.hpp"
#include "dot/motion/classifier.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "dot/pipeline/stopwatch.hpp"
#include "dot/threads/threads.hpp"
#include "dot/tracks/tracks.hpp"

DOT_BEGIN_NAMESPACE

/// Whether an aligner has a member for the kernels that it uses.
template <typename Aligner, typename = void>
inline constexpr bool has_kernels_v = false;
template <typename Aligner>
inline constexpr bool has_kernels_v<
    Aligner, std::enable_if_t<std::is_same_v<decltype(Aligner::reduction.kernels), const kernel::Kernels*>>> = true;

/// The pipeline: labels each object of each frame static, moving or not observable.
///
///     dot::Dot<> dot(dot::Pinhole(intrinsics), options);
///     const dot::Result& result = dot.track(frame);
///
/// Each policy is a plain struct and a public member; set it before the first frame.
/// @tparam Camera      camera/concept.hpp
/// @tparam Classifier  motion/classifier.hpp
/// @tparam Noise       camera/depth_noise.hpp
/// @tparam Aligner     align/aligner.hpp
template <typename Camera = Pinhole, typename Classifier = VelocityClassifier, typename Noise = DepthNoise,
          typename Aligner = DirectAligner<>>
class Dot {
  static_assert(is_camera_v<Camera>, "Camera must satisfy the concept in dot/camera/concept.hpp");
  static_assert(is_classifier_v<Classifier>, "Classifier must satisfy the concept in dot/motion/classifier.hpp");
  static_assert(is_depth_noise_v<Noise>, "Noise must satisfy the concept in dot/camera/depth_noise.hpp");

 public:
  Classifier classifier;                   ///< decides whether an object moves
  Noise depth_noise;                       ///< of the depth; the pipeline learns its scales where it is a DepthNoise
  Aligner aligner;                         ///< aligns points to images
  CameraMotionEstimator camera_estimator;  ///< the camera's motion
  ObjectMotionEstimator object_estimator;  ///< the objects' motions
  Threads threads;                         ///< they call the policies concurrently, each with a copy of the aligner

  /// @throws std::invalid_argument naming the option that is out of range.
  explicit Dot(const Camera& camera, const Options& options = {});

  /// Labels the objects of one frame, and prepares for the next one. The result is valid until the next call.
  /// @throws std::invalid_argument naming the bad field of `frame`; the state is then unchanged.
  /// @throws std::bad_alloc if memory runs out. All frames and objects are then forgotten, as by `reset`; so they are
  /// after an exception of a host's pool.
  const Result& track(const Frame& frame);

  /// `track` in two steps, for a host that waits for the labels: this one returns as soon as they are ready. The result
  /// is valid until the next call but `prepare`, which sets its `too_little_depth`, `diagnosis` and time of
  /// Stage::Points. If the next call prepares, these are never seen. @throws as `track`.
  const Result& label(const Frame& frame);

  /// Prepares for the next frame what `label` left: points of the new one. Without this call the next one does it. May
  /// run in another thread while all other parts of the result are read. Does nothing if all is prepared.
  /// @throws as `track`, but std::invalid_argument.
  void prepare();

  /// Takes masks that arrive late, for an earlier frame that was given to `track` without masks. A network may take
  /// longer than a frame. The masks are moved to the present by all motions measured since, and appear in the next
  /// result. The last result does not change, but for what `prepare` sets. Masks must come in the order of their
  /// frames, for frames after the last segmented one, and at most Options::mask.late_seconds late.
  /// @param frame_id Frame::id; the newest, if several frames have it.
  /// @throws std::invalid_argument naming the bad field, or frame_id if it is none of these frames; the state is then
  /// unchanged.
  /// @throws std::bad_alloc if memory runs out. All frames and objects are then forgotten, as by `reset`; so they are
  /// after an exception of a host's pool.
  void submit_masks(std::uint64_t frame_id, const Masks& masks);

  /// Forgets all frames and objects. Keeps the buffers and never reuses an id.
  void reset() noexcept;

  /// The settings given to the constructor.
  const Options& options() const { return options_; }

 private:
  using TracksT = Tracks<Camera, Classifier, Noise, Aligner>;
  using Setup = typename TracksT::Setup;

  void label_objects(const Frame& frame);
  double start_interval(double timestamp);
  double unmeasured_from(const ImageRef& depth);
  CameraStep track_camera(const Frame& frame, double seconds);
  void learn_and_predict(const Interval& interval);
  void forget_wrong_motions();
  void count(const char* field, const Masks& masks);
  void discover(const FrameData& cur, const CameraStep& camera_step);
  void prepare_next(const CameraStep& camera_step, bool segmented);
  void remember(const CameraStep& camera_step);
  void drop_lost();
  void write_result(const Frame& frame, const CameraStep& camera_step);
  template <typename Body>
  void reset_unless_done(Body&& body);
  template <typename Body>
  void check(Body&& body);

  /// The aligner's kernels, so that all stages use the same. If it has none, the portable ones.
  const kernel::Kernels& kernels() const {
    if constexpr (has_kernels_v<Aligner>)
      return *aligner.reduction.kernels;
    else
      return portable_kernels();
  }
  Setup setup() const {
    return {camera_,
            classifier,
            depth_noise,
            object_estimator,
            options_.mask,
            options_.selection,
            options_.depth_noise.source,
            camera_tracker_.overlaid(),
            kernels(),
            threads};
  }

  Camera camera_;
  Options options_;

  DepthSaturation saturation_;
  FarPile far_pile_;
  FrameStore frames_;
  FramePtr current_, previous_;
  CameraTracker<Camera, Noise, Aligner> camera_tracker_;
  Discovery<Camera, Noise> discovery_;
  Image<std::uint8_t> explained_;  ///< explanation of each pixel, for the discovery
  Observations observations_;
  std::vector<std::array<int, 4>> boxes_of_movers_;  ///< that were cut to silhouettes, in this frame
  TracksT tracks_;
  Labeller<Camera, Noise> labeller_;
  LateMasks<Camera, Classifier, Noise, Aligner> late_masks_;

  /// What `prepare` needs to know of the frame that was labelled last.
  struct Labelled {
    CameraStep camera;
    bool segmented;
  };
  std::optional<Labelled> unprepared_;

  Watch watch_;
  std::vector<ObjectResult> objects_;
  std::vector<ObjectResult> dropped_;  ///< lost since the last result, for the next one
  std::vector<CameraRevision> revised_;
  Result result_;
  Stopwatch stopwatch_;
};

DOT_END_NAMESPACE

#include "dot/pipeline/impl/dot.hpp"
#include "dot/pipeline/impl/write_result.hpp"
