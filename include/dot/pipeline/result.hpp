// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "dot/camera_motion/status.hpp"
#include "dot/diagnosis/diagnosis.hpp"
#include "dot/image/span.hpp"
#include "dot/image/view.hpp"
#include "dot/motion/reason.hpp"
#include "dot/motion/state.hpp"

/// @file
/// The tracker's output: plain values and views, without Eigen or OpenCV.

namespace dot {

/// The camera's motion over the last interval.
struct CameraResult {
  CameraStatus status = CameraStatus::FirstFrame;                         ///< how the motion was found
  std::array<double, 12> T_cur_prev{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< T_c of the middle row, 3x4
  std::array<double, 36> covariance{};  ///< left twist [translation; rotation], row-major, metres and radians
  double phi = 0;                       ///< Pearson correlation of reference and tracked intensities
  double gain = 1;                      ///< I_cur = gain I_prev + offset
  double offset = 0;                    ///< grey values
  double residual_sigma = 0;            ///< grey values, robust
  double reduced_chi2 = 0;              ///< of the inliers' residuals over their predicted sigma; near 1 if consistent
  int n_points = 0;                     ///< background points inside the image
  int n_inliers = 0;                    ///< of these, points that fit the line between intensities
};

/// An earlier motion of the camera that was wrong, and the right one. A host that has used it should use this instead.
struct CameraRevision {
  std::uint64_t frame_id = 0;                                             ///< of the frame that the motion led to
  double timestamp = 0;                                                   ///< of that frame, seconds
  std::array<double, 12> T_cur_prev{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< to that frame, row-major 3x4
  std::array<double, 36> covariance{};                                    ///< of its left twist, row-major
};

/// One object in one frame.
struct ObjectResult {
  std::uint32_t id = 0;                ///< of the track, never reused
  State state = State::NotObservable;  ///< after this frame: Static, Moving or NotObservable
  Reason reason = Reason::New;         ///< why there is no fit in this frame; None if there is one
  bool always_dynamic = false;         ///< flagged by the caller
  bool segmented = false;              ///< an instance of this frame's segmentation was associated
  bool discovered = false;             ///< found by its motion (Options::discover_unknown); no instance so far
  std::uint32_t instance_id = 0;       ///< of that instance
  std::int32_t class_id = -1;          ///< of the last instance associated
  float score = 0;                     ///< of the last instance associated
  std::array<int, 4> box{};            ///< x, y, width, height of its visible label pixels; zeros if there are none
  int area = 0;                        ///< visible label pixels
  double p_moving = 0.5;               ///< belief after this frame
  State last_decided = State::NotObservable;  ///< the last state that was Static or Moving, if any

  // The single fit of this frame. Valid if `reason` is None.
  std::array<double, 12> T_o{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< row-major 3x4, previous camera's axes: a point
                                                                   ///< at X_prev is at T_c T_o X_prev in this camera
  std::array<double, 36> covariance{};          ///< Sigma_x of T_o: twist about the centroid, photometric part only
  std::array<double, 3> velocity{};             ///< of the centroid, m/s, previous camera's axes
  std::array<double, 9> velocity_covariance{};  ///< includes the errors of camera and depth
  double speed = 0;                             ///< m/s
  std::array<double, 3> angular_velocity{};     ///< rad/s, previous camera's axes; without the prior that T_o contains
  std::array<double, 9> angular_covariance{};   ///< (rad/s)^2, includes the errors of camera and depth
  double point_speed = 0;         ///< m/s, of the object's points, turning included: root of the mean square
  double point_speed_sigma = 0;   ///< m/s, of the points' velocities: root of the mean trace of their covariances
  double phi = 0;                 ///< Pearson correlation
  double disparity_px = 0;        ///< d_d: median pixel distance between the points moved by T_c and by T_c T_o
  double disparity_noise_px = 0;  ///< RMS over points of sqrt(trace(G Sigma_x G'))
  double entropy = 0;             ///< H of Sigma_x, nats (paper eq. 7)
  double range = 0;               ///< depth of the centroid, metres
  double interval = 0;  ///< seconds that the fit spans: more than the last interval if the frame before gave no
                        ///< reference or no fit; T_o is then the share of the last interval at constant velocity
  int n_points = 0;     ///< points inside the image
  int n_inliers = 0;    ///< of these, points that fit the line between intensities

  // Fused over time.
  std::array<double, 3> fused_velocity{};    ///< m/s, this camera's axes
  std::array<double, 9> fused_covariance{};  ///< (m/s)^2, row-major 3x3; zeros if there is no fused velocity
};

/// The stages of `track` whose time is measured.
enum class Stage : std::uint8_t {
  Image,    ///< grey image, pyramids, inverse depth
  Camera,   ///< the camera's motion
  Masks,    ///< reading, predicting and associating masks; the noise of the depth
  Objects,  ///< the objects' motions and states
  Label,    ///< label and id images
  Points,   ///< points of the new frame, for the next ones
  Count     ///< number of stages
};

/// Name of a stage, lower case.
constexpr const char* to_string(Stage stage) {
  constexpr const char* names[] = {"image", "camera", "masks", "objects", "label", "points"};
  return stage < Stage::Count ? names[static_cast<int>(stage)] : "?";
}

/// The result of `track` or `label`; its views are valid until the next call on the same tracker but `prepare`.
struct Result {
  std::uint64_t frame_id = 0;     ///< Frame::id
  double timestamp = 0;           ///< Frame::timestamp
  double interval = 0;            ///< seconds since the previous frame, 0 if there is no reference
  bool too_little_depth = false;  ///< the frame has too few background points for a reference; older ones are kept;
                                  ///< false before `prepare`
  double disparity_bias_px = 0;   ///< for stereo: RMS over the image of the learnt bias that was subtracted
  Diagnosis diagnosis;            ///< what may be wrong with the last frames' images, depth and times; none before
                                  ///< `prepare`
  CameraResult camera;            ///< the camera's part
  Span<CameraRevision> revised;  ///< earlier frames whose camera motion this frame proved to be wrong, the oldest first
  ImageView<const std::uint8_t> labels;  ///< State of each pixel
  ImageView<const std::uint32_t> ids;    ///< track id of each pixel, 0 = background
  Span<ObjectResult> objects;            ///< by id: all tracks, including those without pixels and those just dropped
  int small_instances = 0;               ///< masks of this frame without a track that are too small to start one
  std::array<double, static_cast<int>(Stage::Count)> stage_ms{};  ///< milliseconds that each Stage took

  /// The object of this id, or null.
  const ObjectResult* find(std::uint32_t id) const {
    const ObjectResult* found = std::lower_bound(
        objects.begin(), objects.end(), id, [](const ObjectResult& object, std::uint32_t i) { return object.id < i; });
    return found != objects.end() && found->id == id ? found : nullptr;
  }
};

}  // namespace dot
