// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "dot/align/aligner.hpp"
#include "dot/align/residual_sums.hpp"
#include "dot/camera/depth_bias.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Learns the bias of the depth from the static background. Where its depth is wrong, the camera's motion shifts it in
/// the image by more or by less than predicted.
///
/// With the residual r, its derivatives J by [x; a; b] of eq. 3, and dr/dq by the inverse depth, a frame's points
/// constrain the pose and the remaining bias, delta, with its terms phi, by
///
///     r + J [x; a; b] - dr/dq phi' delta = 0
///
/// with Tukey weights. Pose, gain and offset are eliminated, so that only residuals that no motion explains count. The
/// frames are summed with exponential fading. Without motion dr/dq is zero, and nothing is learnt. A depth sensor
/// without such a bias should not get one from noise. So the estimate is shrunk by the share that noise alone would
/// have in its size (positive-part James-Stein estimator), and is zero within the 95 % ellipsoid about zero.
///
/// A bias and a motion together fit lines to the shifts over the inverse depth: the motion is the slope. Noise of the
/// inverse depth flattens such a line, and the bias takes up the rest. So nothing is learnt where noise is too large a
/// share of the variation that no bias explains, as over even ground seen from above.
class DepthBiasLearning {
 public:
  static constexpr double kMemory = 10;     ///< seconds, time constant of the fading
  static constexpr double kCorrelated = 9;  ///< points that count as one with independent error
  /// Largest share of noise in the variation of the inverse depth, as the motion would be too short by about that.
  static constexpr double kMostNoise = 0.01;

  double prior = 0;  ///< 1/m, standard deviation of each coefficient; 0: no bias is assumed or learnt

  /// Forgets what was learnt.
  void forget() {
    information_.setZero();
    weighted_.setZero();
  }

  /// The bias to subtract from the measured inverse depth.
  DepthBias bias() const;

  /// @param points of the background. @param image level 0. @param a their alignment to it.
  /// @param dt seconds since the last frame.
  template <typename Camera>
  void learn(const PointSet& points, const Image<std::uint8_t>& image, const Camera& camera, const Alignment& a,
             const AlignSettings& settings, double dt) {
    const double keep = std::exp(-dt / kMemory);
    information_ *= keep;
    weighted_ *= keep;
    if (!(prior > 0)) return;
    ResidualSums<kTerms> sums;
    Variation variation;
    const double to_s = 2.0 / image.width(), to_t = 2.0 / image.height();
    visit_fitting(points, 1, image, camera, a, settings, [&](const FittingPoint& p) {
      const Terms terms = DepthBias::terms(to_s * static_cast<double>(points.u[p.i]) - 1,
                                           to_t * static_cast<double>(points.v[p.i]) - 1);
      sums.add(p, -p.dr_dq * terms);
      if (p.i % kForShare == 0)
        variation.add(terms, static_cast<double>(points.q[p.i]), static_cast<double>(points.sigma_q[p.i]),
                      p.weight * p.dr_dq * p.dr_dq);
    });
    if (variation.share_of_noise() < kMostNoise) add(sums, points.bias);
  }

 private:
  static constexpr int kTerms = DepthBias::kTerms;
  static constexpr std::size_t kForShare = 4;  ///< each so-many-th point is enough for the share of noise
  using Terms = DepthBias::Terms;
  using Information = Eigen::Matrix<double, kTerms, kTerms>;

  /// Variation of the points' inverse depth that no bias explains.
  class Variation {
   public:
    void add(const Terms& terms, double q, double sigma, double weight) {
      Row row;
      row << terms, q;
      sums_.noalias() += (weight * row) * row.transpose();
      noise_ += weight * sigma * sigma;
    }
    /// Share of it that is noise; 1 if there is none.
    double share_of_noise() const;

   private:
    using Row = Eigen::Matrix<double, kTerms + 1, 1>;
    Eigen::Matrix<double, kTerms + 1, kTerms + 1> sums_ = Eigen::Matrix<double, kTerms + 1, kTerms + 1>::Zero();
    double noise_ = 0;
  };

  /// Adds a frame's information about the bias.
  void add(const ResidualSums<kTerms>& sums, const DepthBias& taken);

  Information information_ = Information::Zero();  ///< of the coefficients, of all frames
  Terms weighted_ = Terms::Zero();                 ///< sum over the frames of information times estimate
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/camera_motion/impl/bias_learning.hpp"
#endif
