// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "dot/diagnosis/depth_step.hpp"
#include "dot/diagnosis/diagnosis.hpp"
#include "dot/frame/frame_data.hpp"

DOT_BEGIN_NAMESPACE

/// What the stages have noticed of a frame. Shares are of its pixels, 0 to 1.
struct Noticed {
  double masked = 0;       ///< share that objects cover; looked at if there are too few points beside them
  double saturated = 0;    ///< share whose depth was left out (DepthSaturation, FarPile)
  double fixed = 0;        ///< share that does not move with the scene (FixedParts)
  double row_turn = 0;     ///< radians, of the last row against the first; 0 if that may be chance (RollingShutter)
  double scale_sigma = 0;  ///< of the depth's scale from frame to frame, relative (ScaleJitter)
  double distortion = 0;   ///< pixels, of a radial distortion that the camera model lacks (LensDistortion)
  double host_error = 0;   ///< pixels, of a motion of the camera from the host that was refuted (HostMotionCheck)
};

/// Notices input that no tracker can work with. It looks at a few rows of what `track` has computed.
class Watch {
 public:
  /// Share of the image: with so much covered, masks are the cause of too few points.
  static constexpr double kMasked = 0.6;

  /// @param noise of the depth. @param seconds since the frame before, 0 for the first. @param max_gap of the frames,
  /// seconds. @param too_few_points for the next frame's camera motion.
  template <typename Noise>
  Diagnosis update(const FrameData& frame, const Noise& noise, double seconds, double max_gap, bool too_few_points,
                   const Noticed& noticed = {}) {
    const std::size_t level = frame.pyramid.size() > 1 ? 1 : 0;
    const bool first = !(seconds > 0);
    if (first || seconds > max_gap) step_.clear();
    const double sigma = step_.measured() > 0 ? noise.prior_pixel_sigma(step_.mean_inverse_depth()) : 0;
    step_.add(frame.pyramid.levels[level], frame.depth.levels[level], static_cast<float>(kNoiseOfEnds * sigma));
    gaps_.add(!first && (seconds > max_gap || seconds < kShortestStep));
    // Whether a driver has repeated an image is known when another one comes. A camera without noise, as a simulated
    // one, stands for a while now and then.
    if (frame.repeats == 0) {
      for (; run_ > 0 && run_ <= FrameData::kLongestRun; --run_) repeats_.add(true);
      repeats_.add(false);
    }
    run_ = frame.repeats;
    few_points_.add(too_few_points);
    const double measured =
        step_.pixels() > 0 ? static_cast<double>(step_.measured()) / static_cast<double>(step_.pixels()) : 1;
    const bool little_depth = too_few_points && measured < kLittleDepth;
    no_depth_.add(little_depth);
    if (little_depth) little_depth_ = measured;
    const bool covered = too_few_points && noticed.masked > kMasked;
    covered_.add(covered);
    if (covered) last_.masked = noticed.masked;
    saturated_.add(noticed.saturated > 0);
    if (noticed.saturated > 0) last_.saturated = noticed.saturated;
    fixed_.add(noticed.fixed > 0);
    if (noticed.fixed > 0) last_.fixed = noticed.fixed;
    rolling_.add(noticed.row_turn > 0);
    if (noticed.row_turn > 0) last_.row_turn = noticed.row_turn;
    unsteady_.add(noticed.scale_sigma > kUnsteady);
    distorted_.add(noticed.distortion > 0);
    if (noticed.distortion > 0) last_.distortion = noticed.distortion;
    host_wrong_.add(noticed.host_error > 0);
    if (noticed.host_error > 0) last_.host_error = noticed.host_error;

    if (gaps_.share() > 0.5) return {Suspicion::ImplausibleTimes, seconds};
    if (repeats_.times() > 1 && repeats_.share() >= kRepeats) return {Suspicion::RepeatedImages, repeats_.share()};
    if (run_ >= Share::kFrames) return {Suspicion::RepeatedImages, 1};
    if (few_points_.share() > 0.5) {
      // Depth may come with some of the frames alone, so that this frame does not tell what the others lack.
      if (no_depth_.share() > 0.5 * few_points_.share()) return {Suspicion::TooLittleDepth, little_depth_};
      if (covered_.share() > 0.5 * few_points_.share()) return {Suspicion::MasksCoverImage, last_.masked};
      return {Suspicion::TooLittleTexture, few_points_.share()};
    }
    const double depth = step_.mean_inverse_depth() > 0 ? 1 / step_.mean_inverse_depth() : 1;
    if (depth > kFarthest || depth < kNearest) return {Suspicion::ImplausibleDepth, depth};
    if (const int lag = step_.lag(); lag != 0) return {Suspicion::DepthOutOfStep, static_cast<double>(lag)};
    if (host_wrong_.share() > 0.5) return {Suspicion::HostMotion, last_.host_error};
    if (saturated_.share() > 0.5) return {Suspicion::SaturatedDepth, last_.saturated};
    if (fixed_.share() > 0.5) return {Suspicion::FixedPart, last_.fixed};
    if (distorted_.share() > 0.5) return {Suspicion::LensDistortion, last_.distortion};
    if (rolling_.share() > 0.5) return {Suspicion::RollingShutter, last_.row_turn};
    if (unsteady_.share() > 0.5) return {Suspicion::UnsteadyScale, noticed.scale_sigma};
    return {};
  }

  /// Starts afresh, as at the first frame.
  void forget() noexcept {
    step_.clear();
    gaps_ = repeats_ = few_points_ = no_depth_ = covered_ = saturated_ = fixed_ = rolling_ = unsteady_ = distorted_ =
        host_wrong_ = {};
    run_ = 0;
  }

 private:
  /// Share of the last 16 frames of which something is true, 0 before the eighth.
  struct Share {
    std::uint32_t bits = 0;
    int count = 0;

    static constexpr int kFrames = 16;

    void add(bool value) {
      bits = (bits << 1 | (value ? 1u : 0u)) & ((1u << kFrames) - 1);
      count = std::min(count + 1, kFrames);
    }
    int times() const {
      int ones = 0;
      for (std::uint32_t b = bits; b != 0; b &= b - 1) ++ones;
      return ones;
    }
    double share() const {
      constexpr int kEnough = 8;
      return count < kEnough ? 0 : static_cast<double>(times()) / count;
    }
  };

  static constexpr double kNoiseOfEnds = 8;      ///< sigmas of the depth: smaller steps are no ends of things
  static constexpr double kShortestStep = 5e-4;  ///< seconds
  static constexpr double kRepeats = 0.12;       ///< share of repeated images that disturbs
  static constexpr double kLittleDepth = 0.05;   ///< share of the pixels
  static constexpr double kUnsteady = 0.01;      ///< of the scale; no sensor tried here reaches it
  static constexpr double kFarthest = 150, kNearest = 0.1;  ///< metres, harmonic mean

  DepthStep step_;
  Share gaps_, repeats_, few_points_, no_depth_, covered_, saturated_, fixed_, rolling_, unsteady_, distorted_,
      host_wrong_;
  double little_depth_ = 0;  ///< share of the pixels with depth in the last frame that had too little
  Noticed last_;             ///< of the last frames that had any
  int run_ = 0;              ///< FrameData::repeats of the newest frame
};

DOT_END_NAMESPACE
