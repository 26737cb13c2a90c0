// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "dot/align/kernel_reduction.hpp"
#include "dot/align/pearson.hpp"
#include "dot/align/robust.hpp"
#include "dot/align/settings.hpp"
#include "dot/image/depth_pyramid.hpp"

DOT_BEGIN_NAMESPACE

/// What to align: points of a reference to an image, T_i_j = T_outer T_o.
///
/// The unknown x moves T_o by a left twist about the region's centroid c, T_o <- Tr(c') exp(x) Tr(-c') T_o with
/// c' = T_o c (an object: its rotation error does not leak into metres of translation), or about the camera's origin
/// when `centred` is false (the camera itself: T_outer = 1, T_c <- exp(x) T_c; paper eq. 3).
template <typename Camera>
struct AlignProblem {
  const PointSet& points;
  const Pyramid& image;
  const Camera& camera;
  DepthTerm depth{};
  SE3d T_outer{};
  bool centred = false;
  Vector3<double> centroid = Vector3<double>::Zero();  ///< c, camera axes of the reference
  Matrix6<double> prior = Matrix6<double>::Zero();     ///< information of [T_o c - c; log R_o] about zero
  AlignState photometry{};                             ///< expected gain and offset
  double gain_information = 0;                         ///< of the gain about that
  double offset_information = 0;                       ///< of the offset about that
  double hidden_cost = 0;  ///< what a hidden point, or one that left the image, counts when minima are ranked
  const DepthPyramid* depth_pyramid = nullptr;  ///< of the new frame; null: depth.inverse_depth serves at all levels

  /// The depth term at a pyramid level.
  DepthTerm depth_at(int level) const {
    DepthTerm term = depth;
    if (depth_pyramid)
      term.inverse_depth = depth_pyramid->levels[static_cast<std::size_t>(level)].view(), term.level = level;
    return term;
  }

  /// Cost of gain and offset being unexpected; keeps a flat region from explaining everything by no contrast at all.
  double photometric_cost(const AlignState& s) const {
    const double a = s.gain - photometry.gain, b = s.offset - photometry.offset;
    return 0.5 * (gain_information * a * a + offset_information * b * b);
  }
};

/// Result of an alignment.
struct Alignment {
  AlignState state;             ///< T = T_i_j
  Matrix8 H = Matrix8::Zero();  ///< information of [x; a; b], prior included
  Matrix8 covariance = Matrix8::Zero();
  /// x that a unit of each depth error mode causes (NormalEquations::modes)
  std::array<Vector8, 4> depth_modes{Vector8::Zero(), Vector8::Zero(), Vector8::Zero(), Vector8::Zero()};
  double sigma_intensity = 0;  ///< grey values, level 0
  double normalised_variance = 0;
  double phi = 0;  ///< Pearson correlation of the inliers
  int inside = 0, seen = 0, occluded = 0, inliers = 0;
  int with_depth = 0, depth_agrees = 0;  ///< seen points with measured depth; those that agree with the prediction
  double depth_scatter = 0;  ///< robust sigma of measured minus predicted inverse depth, 1/m; 0 where there is none
  /// Share by which the cost of the next best minimum is higher, where several were compared.
  double margin = std::numeric_limits<double>::infinity();
  int iterations = 0;
  bool converged = false;
};

/// Whether the covariance of the motion is one: finite and positive definite. Of a few points that say next to nothing
/// rounding makes others.
inline bool has_covariance(const Alignment& a) {
  return a.covariance.allFinite() &&
         Eigen::LLT<Matrix6<double>>(a.covariance.topLeftCorner<6, 6>()).info() == Eigen::Success;
}

/// Direct aligner: Gauss-Newton on the Huber cost, coarse to fine, with jointly estimated gain and offset
/// (paper eq. 1-5). Buffers are kept from call to call.
template <typename Reduction = DefaultReduction>
struct DirectAligner {
  AlignSettings settings;
  Reduction reduction;

  /// Refines `start` over the levels coarsest..finest.
  template <typename Camera>
  Alignment align(const AlignProblem<Camera>& problem, const AlignState& start, int coarsest, int finest = 0) {
    Alignment a;
    a.state = start;
    excluded_.assign(static_cast<std::size_t>(problem.points.size()), 0);
    for (int level = coarsest; level >= finest; --level) refine(problem, level, a, level == finest);
    return a;
  }

  /// Refines `start` on one level by the points that fit it, as a redescending cost would: their minimum may be none of
  /// Huber's cost of all points.
  template <typename Camera>
  Alignment align_near(const AlignProblem<Camera>& problem, const AlignState& start, int level) {
    Alignment a;
    a.state = start;
    excluded_.assign(static_cast<std::size_t>(problem.points.size()), 0);
    refine(problem, level, a, true, true);
    return a;
  }

  /// Takes outliers by their distance to the fitted line between intensities (paper, section 3.4), refines once more on
  /// level 0, and fills the statistics.
  /// @param just_aligned `a` is what the last call on this aligner returned: points that it excluded do not count for
  /// the residual scale. Otherwise all do: those that another alignment excluded say nothing of this one.
  template <typename Camera>
  void finish(const AlignProblem<Camera>& problem, Alignment& a, bool just_aligned = false) {
    const auto size = static_cast<std::size_t>(problem.points.size());
    if (!just_aligned || excluded_.size() != size) excluded_.assign(size, 0);
    residuals(problem, 0, a.state, a.sigma_intensity);
    a.sigma_intensity = scale_of_residuals(a.sigma_intensity);
    const PointResiduals& p = residuals_;
    const auto r2 = [&](std::size_t i) { return sq(static_cast<double>(p.r[i])); };
    const auto s2 = [&](std::size_t i) { return sq(a.sigma_intensity) + static_cast<double>(p.extra[i]); };
    exclude_outliers(a);
    refine(problem, 0, a, true);
    // Statistics over all points, the excluded too.
    residuals(problem, 0, a.state, a.sigma_intensity);
    Pearson pearson;
    double sum = 0;
    scratch_.clear();
    a.inside = a.seen = a.occluded = a.inliers = a.with_depth = a.depth_agrees = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      a.occluded += p.occluded(i);
      if (!p.seen(i)) continue;
      ++a.seen;
      if (p.has_depth(i)) {
        ++a.with_depth;
        scratch_.push_back(std::abs(p.r_depth[i]));
        a.depth_agrees += std::abs(p.r_depth[i]) < problem.depth.agreement;
      }
      if (r2(i) > sq(settings.outlier) * s2(i)) continue;
      ++a.inliers;
      sum += r2(i) / s2(i);
      pearson.add(static_cast<double>(problem.points.intensity[0][i]), static_cast<double>(p.value[i]));
    }
    a.inside = a.seen + a.occluded;
    a.phi = pearson.correlation();
    a.depth_scatter = static_cast<double>(mad_sigma(scratch_));
    a.normalised_variance = a.inliers ? sum / a.inliers : 0;
  }

  /// Mean Tukey cost over the visible points of a level, with a given sigma_I; ranks local minima. Includes the depth
  /// term and, where the problem sets it, a cost of hidden points. Infinite when nothing is visible.
  template <typename Camera>
  double rank(const AlignProblem<Camera>& problem, const AlignState& state, int level, double sigma_intensity) {
    residuals(problem, level, state, sigma_intensity);
    const PointResiduals& p = residuals_;
    const float s2 = static_cast<float>(sq(sigma_intensity)), c = static_cast<float>(settings.tukey);
    int seen = 0;
    for (std::size_t i = 0; i < p.size(); ++i) seen += p.seen(i);
    // What is not seen has no residual, and that costs nothing.
    double sum = tukey_cost_sum(p.r.data(), p.extra.data(), p.size(), s2, c);
    if (problem.depth.weight > 0)
      sum += static_cast<double>(problem.depth.weight) *
             tukey_cost_sum(p.r_depth.data(), nullptr, p.size(), problem.depth.sigma * problem.depth.sigma, c);
    if (seen < 10) return std::numeric_limits<double>::infinity();
    sum += problem.photometric_cost(state);
    if (problem.hidden_cost <= 0) return sum / seen;
    const int all = problem.points.size();
    return (sum + problem.hidden_cost * (all - seen)) / all;
  }

  /// Sets `costs` to the Tukey cost of each point on a level, with a given sigma_I; negative where it is not seen.
  template <typename Camera>
  void point_costs(const AlignProblem<Camera>& problem, const AlignState& state, int level, double sigma_intensity,
                   std::vector<float>& costs) {
    residuals(problem, level, state, sigma_intensity);
    const PointResiduals& p = residuals_;
    costs.resize(p.size());
    tukey_costs(p.r.data(), p.extra.data(), p.size(), static_cast<float>(sq(sigma_intensity)),
                static_cast<float>(settings.tukey), costs.data());
    for (std::size_t i = 0; i < p.size(); ++i) costs[i] = p.seen(i) ? costs[i] : -1;
  }

  /// Correlation of the visible points' intensities with those of a level at a pose, in [-1, 1]; -1 where less than
  /// `min_share` of all are visible.
  template <typename Camera>
  double correlation(const AlignProblem<Camera>& problem, const SE3d& T, int level, double min_share) {
    residuals(problem, level, {T}, 1);
    const PointResiduals& p = residuals_;
    const std::vector<float>& reference = problem.points.intensity[static_cast<std::size_t>(level)];
    float n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const float seen = p.seen(i), a = seen * (reference[i] - 128), b = seen * (p.value[i] - 128);
      n += seen, x += a, y += b, xx += a * a, xy += a * b, yy += b * b;
    }
    if (n < 10 || n < static_cast<float>(min_share) * static_cast<float>(p.size())) return -1;
    const float vx = xx - x * x / n, vy = yy - y * y / n;
    return vx > 0 && vy > 0 ? static_cast<double>((xy - x * y / n) / std::sqrt(vx * vy)) : 0;
  }

  /// Robust sigma_I of a level at a pose: the value at which the median normalised residual is that of a normal.
  template <typename Camera>
  double intensity_sigma(const AlignProblem<Camera>& problem, const AlignState& state, int level) {
    excluded_.clear();
    residuals(problem, level, state, 1);
    return scale_of_residuals();
  }

  /// Gain and offset at a given motion, by a line through the intensities, robustly: for a motion that was not aligned.
  template <typename Camera>
  AlignState photometry(const AlignProblem<Camera>& problem, const SE3d& T) {
    AlignState state{T};
    for (int pass = 0; pass < 3; ++pass) {
      const double limit = pass == 0 ? 1e9 : 2 * intensity_sigma(problem, state, 0);
      residuals(problem, 0, state, 1);
      Pearson line;
      for (std::size_t i = 0; i < residuals_.size(); ++i)
        if (residuals_.seen(i) && std::abs(residuals_.r[i]) < limit)
          line.add(static_cast<double>(problem.points.intensity[0][i]), static_cast<double>(residuals_.value[i]));
      if (line.n < 10 || line.slope() <= 0) return AlignState{T};
      state.gain = line.slope();
      state.offset = line.intercept();
    }
    return state;
  }

 private:
  static constexpr std::size_t kScalePoints = 1000;         ///< that tell the residual scale, to 4 %
  static constexpr int kScalePasses = 20;                   ///< mostly two
  static constexpr double kSettled = 0.005;                 ///< share of a scale by which an iteration may change it
  static constexpr double kStep = 0.02, kCoarseStep = 0.5;  ///< squared sigmas: smaller ones end level 0, or another
  static constexpr double kSameScale = 0.02;  ///< share by which two residual scales may differ and be the same
  static double sq(double x) { return x * x; }

  ResidualNoise residual_noise(double sigma_intensity) const {
    return {static_cast<float>(sigma_intensity), static_cast<float>(settings.gradient_noise),
            static_cast<float>(settings.huber), settings.gradient};
  }

  /// Of the residuals that were computed last.
  void exclude_outliers(const Alignment& a) {
    const PointResiduals& p = residuals_;
    for (std::size_t i = 0; i < p.size(); ++i)
      excluded_[i] = p.seen(i) && sq(static_cast<double>(p.r[i])) >
                                      sq(settings.outlier) * (sq(a.sigma_intensity) + static_cast<double>(p.extra[i]));
  }

  template <typename Camera>
  void residuals(const AlignProblem<Camera>& problem, int level, const AlignState& state, double sigma_intensity) {
    reduction.residuals(problem.points, level, problem.camera.at_level(level),
                        problem.image.levels[static_cast<std::size_t>(level)], state, residual_noise(sigma_intensity),
                        problem.depth_at(level), residuals_);
  }

  /// Robust sigma_I of the residuals that count, by fixed point: the median of squares is the square of the median.
  /// @param sigma to start from; 0: what it would be without any other noise.
  double scale_of_residuals(double sigma = 0) {
    const PointResiduals& p = residuals_;
    squares_.resize(p.size());
    extra_.resize(p.size());
    std::size_t n = 0;
    const std::size_t step = std::max<std::size_t>(1, p.size() / kScalePoints);
    for (std::size_t i = 0; i < p.size(); i += step) {
      squares_[n] = p.r[i] * p.r[i];
      extra_[n] = p.extra[i];
      n += p.seen(i) && !(i < excluded_.size() && excluded_[i]);
    }
    if (sigma <= 0) {
      scratch_.assign(squares_.begin(), squares_.begin() + static_cast<std::ptrdiff_t>(n));
      sigma = std::max(settings.min_intensity_sigma, sigma_of_median_square());
    }
    for (int pass = 0; pass < kScalePasses; ++pass) {
      const float s2 = static_cast<float>(sigma * sigma);
      scratch_.resize(n);
      for (std::size_t i = 0; i < n; ++i) scratch_[i] = squares_[i] / (s2 + extra_[i]);
      const double before =
          std::exchange(sigma, std::max(settings.min_intensity_sigma, sigma * sigma_of_median_square()));
      if (std::abs(sigma - before) < kSettled * before) break;
    }
    return sigma;
  }
  double sigma_of_median_square() {
    return static_cast<double>(kSigmaOfMedian * std::sqrt(median_of_magnitudes(scratch_)));
  }

  /// H and g of [A x; a; b], the twist about the axes turned by R, from those of [x; a; b].
  static void turn(const Matrix3<double>& R, Matrix8& H) {
    for (const int k : {0, 3}) H.middleCols<3>(k) = (H.middleCols<3>(k) * R).eval();
    for (const int k : {0, 3}) H.middleRows<3>(k) = (R.transpose() * H.middleRows<3>(k)).eval();
  }
  static void turn(const Matrix3<double>& R, Vector8& g) {
    for (const int k : {0, 3}) g.segment<3>(k) = (R.transpose() * g.segment<3>(k)).eval();
  }

  /// Gauss-Newton on one level, on level 0 again where the first round changed the residual scale or did not converge.
  template <typename Camera>
  void refine(const AlignProblem<Camera>& problem, int level, Alignment& a, bool want_covariance, bool near = false) {
    const Camera camera = problem.camera.at_level(level);
    const Image<std::uint8_t>& image = problem.image.levels[static_cast<std::size_t>(level)];
    const DepthTerm depth = problem.depth_at(level);
    std::optional<Eigen::LDLT<Matrix8>> last;  // of the last pose that was accepted
    std::array<Vector8, 4> modes;
    Matrix3<double> modes_R;
    a.seen = 0;
    for (int round = 0; round < 2; ++round) {
      const double scale_before = a.sigma_intensity;
      residuals(problem, level, a.state, a.sigma_intensity);
      if (near) std::fill(excluded_.begin(), excluded_.end(), std::uint8_t{0});
      a.sigma_intensity = scale_of_residuals(a.sigma_intensity);
      if (near) exclude_outliers(a);
      if (round > 0 && a.converged && std::abs(a.sigma_intensity - scale_before) < kSameScale * scale_before) break;
      const ResidualNoise noise = residual_noise(a.sigma_intensity);
      AlignState accepted = a.state;
      double accepted_cost = std::numeric_limits<double>::infinity();
      a.converged = false;
      for (int iteration = 0; iteration < settings.max_iterations; ++iteration) {
        // From x to the twist about the centroid in the camera's axes, A = T_outer Tr(c'): T <- A exp(x) A^-1 T.
        const SE3d T_o = problem.T_outer.inverse() * a.state.T;
        const Vector3<double> moved =
            problem.centred ? Vector3<double>(T_o * problem.centroid) : Vector3<double>::Zero();
        const SE3d A = problem.T_outer * SE3d::translation(moved);
        NormalEquations sums =
            reduction.linearize(problem.points, level, camera, image, a.state, noise, depth, excluded_.data(), A.t);
        if (sums.seen < 10) {
          a.state = accepted;
          break;
        }
        ++a.iterations;
        a.seen = sums.seen;
        Matrix8& H = sums.H;
        Vector8& g = sums.g;
        turn(A.R, H), turn(A.R, g);
        double cost = sums.cost;
        if (problem.centred) {
          Vector6<double> p;
          p << moved - problem.centroid, so3::log(T_o.R);
          H.topLeftCorner<6, 6>() += problem.prior;
          g.head<6>() += problem.prior * p;
          cost += 0.5 * p.dot(problem.prior * p) / sums.seen;
        }
        H(6, 6) += problem.gain_information;
        H(7, 7) += problem.offset_information;
        g[6] += problem.gain_information * (a.state.gain - problem.photometry.gain);
        g[7] += problem.offset_information * (a.state.offset - problem.photometry.offset);
        cost += problem.photometric_cost(a.state) / sums.seen;
        if (cost > accepted_cost) {
          a.state = accepted;
          a.converged = true;
          break;
        }
        accepted = a.state;
        accepted_cost = cost;
        // A whiff of damping relative to each parameter keeps a direction that no point sees from exploding.
        Matrix8 damped = H;
        damped.diagonal() += 1e-7 * H.diagonal() + Vector8::Constant(1e-9);
        const Eigen::LDLT<Matrix8> solver(damped);
        const Vector8 x = -solver.solve(g);
        a.H = H;
        last = solver;
        modes = sums.modes, modes_R = A.R;
        if (!x.allFinite()) break;
        const double decrease = -g.dot(x);  // x' H x: the step in squared sigmas
        a.state.T = (A * SE3d::exp(x.head<6>()) * A.inverse() * a.state.T).normalized();
        a.state.gain += x[6];
        a.state.offset += x[7];
        if (decrease < (level > 0 ? kCoarseStep : kStep)) {
          a.converged = true;
          break;
        }
      }
      if (level > 0) break;
    }
    if (!last || !want_covariance) return;
    a.covariance = last->solve(Matrix8::Identity());
    for (std::size_t m = 0; m < 4; ++m) {
      turn(modes_R, modes[m]);
      a.depth_modes[m] = -last->solve(modes[m]);
    }
  }

  PointResiduals residuals_;
  std::vector<std::uint8_t> excluded_;
  Buffer<float> scratch_, squares_, extra_;
};

DOT_END_NAMESPACE
