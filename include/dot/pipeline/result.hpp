// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "dot/image/span.hpp"
#include "dot/image/view.hpp"
#include "dot/motion/state.hpp"

/// @file
/// What comes out of the tracker: plain values and views, neither Eigen nor OpenCV.

namespace dot {

/// Why an object has no motion estimate in this frame (or was dropped after it).
enum class Reason : std::uint8_t {
  None,              ///< it has one
  New,               ///< first seen in this frame, and the frame before tells no motion
  NoReference,       ///< the frames before this one were dropped (gap in time, or reset)
  TooFewPixels,      ///< its mask is too small
  TooLittleDepth,    ///< its mask has too little valid depth
  TooLittleTexture,  ///< too few pixels with a gradient
  LeavesImage,       ///< too small a part of it stays inside the image
  Occluded,          ///< nearer things hide too much of it
  Diverged,          ///< the alignment did not converge
  LowCorrelation,    ///< reference and tracked intensities do not correlate (phi)
  TooFewInliers,     ///< too few points agree with the fitted line between intensities
  DepthDisagrees,    ///< the motion found contradicts the measured depth
  Implausible,       ///< the motion found is faster than Options::object.max_speed
  Hidden,            ///< neither its prediction nor a mask shows it in this frame
  CameraLost,        ///< no camera motion, hence no object motion
  Lost,              ///< not seen for longer than Options::mask.keep_seconds: dropped after this frame
  TooManyObjects     ///< not among the Options::object.max_fitted largest: carried on at its last velocity
};

enum class CameraStatus : std::uint8_t {
  FirstFrame,      ///< no reference yet, or references dropped: T_cur_prev is the identity and means nothing
  Tracked,         ///< estimated from the image
  FromHost,        ///< taken from Frame::camera_motion
  TooLittleDepth,  ///< no earlier frame had enough background points with depth; T_cur_prev is a guess: the host's
                   ///< prior, or constant velocity, with the covariance of a motion of which only the limits are known
  Lost             ///< the alignment failed; T_cur_prev is a guess likewise
};

/// The camera's motion over the last interval.
struct CameraResult {
  CameraStatus status = CameraStatus::FirstFrame;
  std::array<double, 12> T_cur_prev{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< T_c, row-major 3x4
  std::array<double, 36> covariance{};  ///< left twist [translation; rotation], row-major, metres and radians
  double phi = 0;                       ///< Pearson correlation of reference and tracked intensities
  double gain = 1;                      ///< I_cur = gain I_prev + offset
  double offset = 0;                    ///< grey values
  double residual_sigma = 0;            ///< grey values, robust
  double normalised_variance = 0;       ///< of the inliers' residuals over their predicted sigma; near 1 when honest
  int n_points = 0;                     ///< background points inside the image
  int n_inliers = 0;
};

/// One object in one frame.
struct ObjectResult {
  std::uint32_t id = 0;  ///< of the track, never reused
  State state = State::NotObservable;
  Reason reason = Reason::New;
  bool always_dynamic = false;    ///< flagged by the caller
  bool segmented = false;         ///< an instance of this frame's segmentation was associated
  bool discovered = false;        ///< found by its motion (Options::discover_unknown); no instance so far
  std::uint32_t instance_id = 0;  ///< of that instance
  std::int32_t class_id = -1;     ///< of the last instance associated
  float score = 0;                ///< of the last instance associated
  std::array<int, 4> box{};       ///< x, y, width, height of its visible label pixels; zeros when it shows none
  int area = 0;                   ///< visible label pixels
  double p_moving = 0.5;          ///< belief after this frame
  State last_decided = State::NotObservable;  ///< the last state that was Static or Moving, if ever

  // The single fit of this frame; meaningful where `reason` is None.
  std::array<double, 12> T_o{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< row-major 3x4, previous camera's axes: a point
                                                                   ///< at X_prev is at T_c T_o X_prev in this camera
  std::array<double, 36> covariance{};          ///< Sigma_x of T_o: twist about the centroid, photometric part only
  std::array<double, 3> velocity{};             ///< of the centroid, m/s, previous camera's axes
  std::array<double, 9> velocity_covariance{};  ///< with the camera's and the depth's share
  double speed = 0;                             ///< m/s
  double phi = 0;                               ///< Pearson correlation
  double disparity_px = 0;        ///< d_d: median pixel distance between the points moved by T_c and by T_c T_o
  double disparity_noise_px = 0;  ///< RMS over points of sqrt(trace(G Sigma_x G'))
  double entropy = 0;             ///< H of Sigma_x, nats (paper eq. 7)
  double range = 0;               ///< depth of the centroid, metres
  double interval = 0;  ///< seconds that the fit spans: more than the last interval where the frame before gave no
                        ///< reference or no fit; T_o is then the share of the last interval at constant velocity
  int n_points = 0;     ///< points inside the image
  int n_inliers = 0;

  // Fused over time.
  std::array<double, 3> fused_velocity{};  ///< m/s, this camera's axes
  std::array<double, 9> fused_covariance{};
};

/// Where the time of one `track` went.
enum class Stage : std::uint8_t { Image, Camera, Masks, Objects, Label, Points, Count };

/// Name of a stage, lower case.
constexpr const char* to_string(Stage stage) {
  constexpr const char* names[] = {"image", "camera", "masks", "objects", "label", "points"};
  return stage < Stage::Count ? names[static_cast<int>(stage)] : "?";
}

/// The result of `track`; its views are valid until the next call on the same tracker.
struct Result {
  std::uint64_t frame_id = 0;
  double timestamp = 0;
  double interval = 0;            ///< seconds since the previous frame, 0 when there is no reference
  bool too_little_depth = false;  ///< the frame gives too few background points to be a reference; older ones serve on
  double disparity_bias_px = 0;   ///< of stereo: RMS over the image of the bias learnt and taken from the depth
  CameraResult camera;
  ImageView<const std::uint8_t> labels;  ///< State of each pixel
  ImageView<const std::uint32_t> ids;    ///< track id of each pixel, 0 = background
  Span<ObjectResult> objects;            ///< all live tracks by id, those without pixels too
  int small_instances = 0;               ///< of this frame's masks: without a track, too small to start one
  std::array<double, static_cast<int>(Stage::Count)> stage_ms{};

  /// The object of this id, or null.
  const ObjectResult* find(std::uint32_t id) const {
    const ObjectResult* found = std::lower_bound(
        objects.begin(), objects.end(), id, [](const ObjectResult& object, std::uint32_t i) { return object.id < i; });
    return found != objects.end() && found->id == id ? found : nullptr;
  }
};

/// Name of a reason, lower case with underscores; empty for None.
constexpr const char* to_string(Reason reason) {
  constexpr const char* names[] = {"",
                                   "new",
                                   "no_reference",
                                   "too_few_pixels",
                                   "too_little_depth",
                                   "too_little_texture",
                                   "leaves_image",
                                   "occluded",
                                   "diverged",
                                   "low_correlation",
                                   "too_few_inliers",
                                   "depth_disagrees",
                                   "implausible",
                                   "hidden",
                                   "camera_lost",
                                   "lost",
                                   "too_many_objects"};
  return reason <= Reason::TooManyObjects ? names[static_cast<int>(reason)] : "?";
}

/// Name of a camera status, lower case with underscores.
constexpr const char* to_string(CameraStatus status) {
  constexpr const char* names[] = {"first_frame", "tracked", "from_host", "too_little_depth", "lost"};
  return status <= CameraStatus::Lost ? names[static_cast<int>(status)] : "?";
}

}  // namespace dot
