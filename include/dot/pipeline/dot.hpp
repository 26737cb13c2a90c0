// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "dot/image/convert.hpp"
#include "dot/image/morphology.hpp"
#include "dot/kernel/portable_kernels.hpp"
#include "dot/mask/association.hpp"
#include "dot/mask/grow.hpp"
#include "dot/mask/hidden.hpp"
#include "dot/motion/classifier.hpp"
#include "dot/pipeline/bias_learning.hpp"
#include "dot/pipeline/camera_motion.hpp"
#include "dot/pipeline/depth_learning.hpp"
#include "dot/pipeline/discovery.hpp"
#include "dot/pipeline/frame_history.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/recycling_list.hpp"
#include "dot/pipeline/threads.hpp"
#include "dot/pipeline/track.hpp"
#include "dot/pipeline/validate.hpp"
#include "dot/points/select_object.hpp"

DOT_BEGIN_NAMESPACE

/// Whether an aligner tells which kernels it uses.
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
  Classifier classifier;
  Noise depth_noise;
  Aligner aligner;
  CameraMotionEstimator camera_estimator;
  ObjectMotionEstimator object_estimator;
  Threads threads;  ///< they call the policies at the same time, each with a copy of the aligner

  /// @throws std::invalid_argument naming the option that is out of range.
  explicit Dot(const Camera& camera, const Options& options = {});

  /// Labels the objects of one frame. The result is valid until the next call.
  /// @throws std::invalid_argument naming the bad field of `frame`; nothing has changed then.
  /// @throws std::bad_alloc, or what a host's pool throws; everything is forgotten then, as by `reset`.
  const Result& track(const Frame& frame);

  /// Masks of an earlier frame, given to `track` without, that arrive only now: a network may take longer than a frame.
  /// They are carried to the present with all that has been measured since, and show in the next result; the last one
  /// is not changed. They come in the order of their frames, from after the last that was segmented, and at most
  /// Options::mask.late_seconds late.
  /// @param frame_id Frame::id; the newest, if several frames have it.
  /// @throws std::invalid_argument naming the bad field, or frame_id when it is none of these frames; nothing has
  /// changed then.
  /// @throws std::bad_alloc, or what a host's pool throws; everything is forgotten then, as by `reset`.
  void submit_masks(std::uint64_t frame_id, const Masks& masks);

  /// Forgets all frames and objects; keeps buffers and never reuses an id.
  void reset() noexcept;

  const Options& options() const { return options_; }

 private:
  using TrackT = Track<typename Classifier::Memory>;

  struct Current {
    Pyramid pyramid;
    DepthPyramid depth;  ///< without `bias`
    DepthBias bias;
    double timestamp = 0;
    double dt = 0;  ///< seconds since the reference, 0 when there is none
    const Image<float>& inverse_depth() const { return depth.levels[0]; }
  };
  struct CameraState {
    CameraStatus status = CameraStatus::FirstFrame;
    SE3d T_cur_prev;
    Matrix6<double> covariance = Matrix6<double>::Zero();
    Alignment alignment;
    Vector6<double> rate = Vector6<double>::Zero();  ///< twist per second, for the prediction
    bool rate_known = false;
    bool known() const { return status == CameraStatus::Tracked || status == CameraStatus::FromHost; }
  };
  /// A frame without segmentation, whose masks may still come.
  struct Past {
    std::uint64_t id = 0;  ///< the caller's
    Current frame;
    CameraState camera;
    ObjectReference since;     ///< what has moved since; of no object and without points
    bool camera_known = true;  ///< its motion, in every frame since
    double timestamp() const { return frame.timestamp; }
  };
  struct Observed {
    std::uint32_t instance_id = 0;
    Mask mask;
    std::int32_t class_id = -1;
    float score = 0;
    bool always_dynamic = false;
    bool discovered = false;  ///< by its motion, not by a network
    const TrackT* track = nullptr;
    Vector3<double> centre = Vector3<double>::Zero();  ///< as `anchor` says
  };

  /// What a thread works with.
  struct Worker {
    Aligner aligner;
    MinimaWorkspace minima;
    std::vector<SE3d> starts;
    std::vector<std::pair<double, const Observed*>> nearest;  ///< masks without a track, with squared distances
    ObjectReference here;                                     ///< the object that `look_back` looks at
    WarpWorkspace warp;
    WarpedMask moved;  ///< not trimmed
    HiddenPart hidden;
    TemplateWorkspace outline;
    SelectionWorkspace selection;
  };

  /// The previous frame, which the history has if its masks may still come.
  const Current& before() { return history_.empty() ? previous_ : std::prev(history_.end())->frame; }

  template <typename Body>
  void reset_unless_done(Body&& body);
  void label_objects(const Frame& frame);
  void forget_background() noexcept;
  void build(const Frame& frame);
  void camera_motion(const Frame& frame);
  void guess_camera_motion();
  void learn_depth();
  void predict_tracks();
  void predict(TrackT& t, Worker& worker);
  void warp_outline(TrackT& object, const SE3d& T_frame_outline, const Image<float>& inverse_depth, Worker& worker);
  void count_instances(const char* field, const Masks& masks);
  void read_masks(const Masks& masks, const Image<float>& inverse_depth);
  void discover();
  Noise bounded_noise() const;
  void absorb();
  /// A candidate that turned out to stand is remembered for a while, lest it is found again, and not followed.
  bool stands(const TrackT& t) const { return t.candidate && t.state == State::Static; }
  void confirm(TrackT& object);
  void support(TrackT& object);
  template <typename Condition>
  std::vector<TrackT*>& tracks_that(Condition&& condition);
  std::vector<TrackT*>& all_tracks() {
    return tracks_that([](const TrackT&) { return true; });
  }
  void associate();
  static bool may_touch(const TrackT& a, const TrackT& b);
  void follow(TrackT& object, Worker& worker);
  KnownVelocity known_velocity(const TrackT& object, const ObjectReference& r) const;
  void set_starts(const TrackT& object, const ObjectReference& reference, Worker& worker) const;
  Vector3<double> anchor(const Mask& mask, const Image<float>& inverse_depth, Worker& worker) const;
  void advance(TrackT& object, Worker& worker);
  void match(const std::vector<TrackT*>& tracks);
  void match(const std::vector<TrackT*>& tracks, bool discovered);
  void give(Observed& o, TrackT& t);
  Observed& observe();
  void find_again();
  void follow_and_decide(std::vector<TrackT*>& tracks);
  void start_tracks();
  void choose_followed();
  void look_back(TrackT& object, Worker& worker);
  void decide(TrackT& object, const Matrix3<double>& R_cur_fit, double dt);
  void place_masks();
  void place(TrackT& object, Worker& worker);
  void keep_hidden(TrackT& object, const Image<float>& inverse_depth, Worker& worker);
  void take_outline(TrackT& object, const Image<float>& inverse_depth, Worker& worker);
  std::vector<TrackT*>& far_to_near();
  void paint(const std::vector<TrackT*>& order, Image<std::uint32_t>& ids) const;
  void show_new_parts(const TrackT& object, std::array<int, 4>& box);
  void label();
  double depth_tolerance(double q) const;
  /// Those of the aligner, so that one choice holds for all; without, the portable ones.
  const kernel::Kernels& kernels() const {
    if constexpr (has_kernels_v<Aligner>)
      return *aligner.reduction.kernels;
    else
      return portable_kernels();
  }
  Selector<Camera, Noise> selector(const Current& frame, Worker& worker) const {
    return {camera_,          depth_noise, frame.pyramid, frame.inverse_depth().view(), options_.selection,
            worker.selection, kernels()};
  }
  void make_references();
  void add_background(Worker& worker);
  void add_reference(TrackT& object, Worker& worker);
  Reason make_reference(const Current& frame, const Mask& mask, const Vector3<double>& centre, Worker& worker,
                        ObjectReference& r) const;
  void await_masks(const Frame& frame);
  void apply_late_masks(Past& then, const Masks& masks);
  SE3d T_cur_then(const TrackT& object, const Past& then) const;
  void adopt(TrackT& object, const Past& then);
  void renew_reference(TrackT& object, const Past& then, const Mask& mask, const Vector3<double>& centre);
  void catch_up(std::vector<TrackT*>& started, double start);
  void write_result(const Frame& frame);
  void take_time(Stage stage);

  static constexpr std::ptrdiff_t kNearestMasks = 3;   ///< without a track, tried as starts of an object's motion
  static constexpr double kMostBoxes = 32;             ///< areas of the image that the boxes of all instances may have
  static constexpr int kReach = 32;                    ///< pixels that even a small object may move unexpectedly
  static constexpr double kMaxLearntScale = 3;         ///< of the shared depth noise, over its prior
  static constexpr double kConfirmedSeconds = 0.05;    ///< of fits that agree, from which on a discovery is shown
  static constexpr double kMaxConfirmedSeconds = 0.5;  ///< beyond which no more are counted
  static constexpr float kSameSurface = 0.05f;         ///< relative difference of inverse depth
  static constexpr double kMinSupport = 0.15;          ///< of a discovered object, share of its mask
  static constexpr double kSupportSeconds = 0.3;       ///< over which it is smoothed
  static constexpr double kCandidateSeconds = 0.25;    ///< what was discovered must be seen again by then

  Camera camera_;
  Options options_;
  std::uint32_t next_id_ = 1;  ///< tracks_ is in the order of ids
  bool has_previous_ = false;

  Current current_;
  Current previous_;  ///< its images, unless they are in history_
  CameraState camera_state_;
  PointSet background_;              ///< of the previous frame, or of the last one that had points
  SE3d T_cur_background_;            ///< from that frame to the current one; the identity once `track` has new points
  double background_seconds_ = 0;    ///< from that frame to the previous one
  bool background_guessed_ = false;  ///< T_cur_background_ is a guess for a part of the way, whose covariance is
  Matrix6<double> guess_covariance_ = Matrix6<double>::Zero();
  PointSet fresh_;
  DepthLearning depth_learning_;
  DepthBiasLearning bias_learning_;
  Discovery<Camera, Noise> discovery_;
  std::vector<Worker> workers_;  ///< one for each of the threads
  RecyclingList<TrackT> tracks_;
  RecyclingList<Observed> observed_;
  int small_instances_ = 0;
  bool segmented_ = false;
  SegmentedFrame segmented_frame_;  ///< the last one
  bool segmented_before_ = false;   ///< it is the previous frame, whose images it takes over with the next labels
  SE3d T_cur_segmented_;            ///< camera motion since
  FrameHistory<Past> history_;      ///< whose masks may still come
  Image<std::uint8_t> nearer_;      ///< where objects nearer than those being followed were found
  std::vector<int> rounds_;         ///< in which the objects are followed
  std::vector<TrackT*> at_once_;    ///< those of one round

  Image<std::uint8_t> labels_;
  Image<std::uint32_t> ids_;
  std::vector<ObjectResult> objects_;
  Result result_;

  GrowWorkspace grow_workspace_;
  IdRuns id_runs_;                       ///< of the masks being read
  Image<std::uint8_t> blocked_;          ///< where nothing is to be discovered
  Image<std::uint8_t> background_mask_;  ///< 255: no object there nor near
  Image<std::uint8_t> grey_rows_, mask_rows_;
  Image<float> depth_rows_;
  std::vector<SE3d> camera_starts_;
  std::vector<TrackT*> selected_;  ///< by `tracks_that`
  /// Buffers of what continues tracks by observed masks.
  struct {
    std::vector<Observed*> open;  ///< without a track
    std::vector<Outline> predicted, observed;
    SparseAssignWorkspace association;
  } matching_;
  std::chrono::steady_clock::time_point clock_;
};

DOT_END_NAMESPACE

#include "dot/pipeline/impl/dot.hpp"
#include "dot/pipeline/impl/dot_discovery.hpp"
#include "dot/pipeline/impl/dot_late_masks.hpp"
#include "dot/pipeline/impl/dot_masks.hpp"
#include "dot/pipeline/impl/dot_objects.hpp"
