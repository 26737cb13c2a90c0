// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "dot/align/aligner.hpp"
#include "dot/object_motion/reference.hpp"
#include "dot/object_motion/settings.hpp"
#include "dot/points/plane_fit.hpp"

DOT_BEGIN_NAMESPACE

/// The data of a frame that an object's fit uses.
template <typename Camera>
struct ObjectScene {
  const Pyramid& image;                     ///< of the frame
  const Camera& camera;                     ///< of level 0
  const DepthPyramid& depth;                ///< of the frame
  ImageView<const std::uint8_t> occluders;  ///< non-zero where a nearer object was found already
};

/// Information matrix of the prior on the twist of T_o, which has mean zero, over `dt` seconds.
DOT_INLINE Matrix6<double> prior_information(const MotionPriorSettings& prior, double dt);

/// Takes the prior out of a fitted rotation. The fit gives the mean w of prior and data, with covariance S, which is
/// near zero and well known if there are hardly any data. The data alone give K w, K = (S^-1 - P)^-1 S^-1, where P is
/// the information of the prior. A tenth of the prior is left in, so that K is bounded. @param S photometric part.
DOT_INLINE Matrix3<double> without_prior(const Matrix3<double>& S, const MotionPriorSettings& prior, double dt);

/// Metres before the camera; a nearer centroid is implausible.
inline constexpr double kNearestCentroid = 0.05;

/// The alignment of an object's reference to a frame: T_o with the camera's motion fixed (paper, section 3.3, eq. 4-5).
template <typename Camera, typename Noise>
AlignProblem<Camera> object_problem(const ReferencePair& pair, const ObjectScene<Camera>& scene,
                                    const MotionPriorSettings& prior, const Noise& noise) {
  constexpr double kUnseenCost = 1;      // of a point that is not seen: an inlier costs about 0.45, an outlier 3.7
  constexpr double kAgreeingSigmas = 3;  // largest difference of agreeing depths
  const ObjectReference& reference = pair.reference;
  AlignProblem<Camera> problem{reference.points, scene.image, scene.camera};
  problem.T_outer = pair.camera.T_now_ref;
  problem.centred = true;
  problem.centroid = reference.centroid;
  problem.prior = prior_information(prior, pair.seconds);
  problem.photometry = {SE3d{}, pair.camera.gain, pair.camera.offset};
  problem.gain_information = 1 / (prior.gain * prior.gain);
  problem.offset_information = 1 / (prior.offset * prior.offset);
  problem.unseen_cost = kUnseenCost;
  const double q = 1 / std::max(kNearestCentroid, reference.centroid.z());
  const double pixel = noise.pixel_sigma(q), change = noise.shared_drift_sigma(q);
  problem.depth.inverse_depth = scene.depth.levels[0].view();
  problem.depth_pyramid = &scene.depth;
  problem.depth.occluders = scene.occluders;
  problem.depth.sigma = static_cast<float>(std::sqrt(pixel * pixel + change * change));
  // The noise is learnt from the background. The depth on an object may be worse.
  problem.depth.agreement = static_cast<float>(
      kAgreeingSigmas * std::max(std::sqrt(pixel * pixel + change * change),
                                 std::hypot(noise.prior_pixel_sigma(q), noise.prior_shared_sigma(q))));
  // Neighbouring depths are not independent, and all depths share the change of the common error. Together they count
  // as N = 1 / (A_corr / area + change^2 / pixel^2) measurements.
  const double n =
      1 / (1.0 * kCorrelatedArea / std::max(kCorrelatedArea, reference.area) + change * change / (pixel * pixel));
  problem.depth.weight = static_cast<float>(n / std::max(1, reference.points.size()));
  return problem;
}

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/prior_information.hpp"
#endif
