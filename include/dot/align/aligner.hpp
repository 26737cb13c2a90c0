// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>

#include "dot/align/alignment.hpp"
#include "dot/align/kernel_reduction.hpp"
#include "dot/align/pearson.hpp"
#include "dot/align/problem.hpp"
#include "dot/align/robust.hpp"
#include "dot/align/settings.hpp"

DOT_BEGIN_NAMESPACE

/// Direct aligner: Gauss-Newton on the Huber cost, coarse to fine, with jointly estimated gain and offset
/// (paper eq. 1-5). Buffers are kept from call to call.
template <typename Reduction = DefaultReduction>
struct DirectAligner {
  AlignSettings settings;  ///< set before the first call
  Reduction reduction;     ///< sums over the points

  /// Refines `start` over the levels coarsest..finest.
  template <typename Camera>
  Alignment align(const AlignProblem<Camera>& problem, const AlignState& start, int coarsest, int finest = 0) {
    Alignment a;
    a.state = start;
    excluded_.assign(static_cast<std::size_t>(problem.points.size()), 0);
    are_current_ = false;
    for (int level = coarsest; level >= finest; --level) refine(problem, level, a, level == finest);
    return a;
  }

  /// Refines `start` on one level by the points that fit it, like a redescending cost. The minimum of these points may
  /// be no minimum of Huber's cost of all points.
  template <typename Camera>
  Alignment align_near(const AlignProblem<Camera>& problem, const AlignState& start, int level) {
    Alignment a;
    a.state = start;
    excluded_.assign(static_cast<std::size_t>(problem.points.size()), 0);
    are_current_ = false;
    refine(problem, level, a, true, true);
    return a;
  }

  /// Rejects outliers by their distance to the fitted line between intensities (paper, section 3.4), refines once more
  /// on level 0, and fills the statistics.
  /// @param just_aligned `a` was returned by the last call on this aligner, for level 0. Then the points that it
  /// excluded do not count for the residual scale. Otherwise all points count, because the exclusions are of another
  /// alignment.
  template <typename Camera>
  void reject_outliers_and_refit(const AlignProblem<Camera>& problem, Alignment& a, bool just_aligned = false) {
    const auto size = static_cast<std::size_t>(problem.points.size());
    const PointResiduals& p = residuals_;
    if (!just_aligned || excluded_.size() != size) excluded_.assign(size, 0);
    if (!just_aligned || !are_current_ || p.size() != size) residuals(problem, 0, a.state, a.sigma_intensity);
    a.sigma_intensity = scale_of_residuals();
    const auto r2 = [&](std::size_t i) { return sq(static_cast<double>(p.r[i])); };
    const auto s2 = [&](std::size_t i) { return sq(a.sigma_intensity) + static_cast<double>(p.extra[i]); };
    exclude_outliers(a);
    are_current_ = true;
    refine(problem, 0, a, true);
    // Statistics over all points, including the excluded ones.
    if (!are_current_) residuals(problem, 0, a.state, a.sigma_intensity);
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
        scratch_.push_back(p.r_depth[i]);
        a.depth_agrees += std::abs(p.r_depth[i]) < problem.depth.agreement;
      }
      if (r2(i) > sq(settings.outlier) * s2(i)) continue;
      ++a.inliers;
      sum += r2(i) / s2(i);
      pearson.add(static_cast<double>(problem.points.intensity[0][i]), static_cast<double>(p.value[i]));
    }
    a.inside = a.seen + a.occluded;
    a.phi = pearson.correlation();
    a.depth_shift = scratch_.empty() ? 0 : static_cast<double>(median(scratch_.begin(), scratch_.end()));
    a.depth_spread = scatter_about(a.depth_shift);
    a.depth_scatter = scatter_about(0);
    a.reduced_chi2 = a.inliers ? sum / a.inliers : 0;
  }

  /// Mean Tukey cost over the visible points of a level, with a given sigma_I. It ranks local minima. Includes the
  /// depth term and, if the problem sets it, a cost of hidden points. Infinite if too few points are visible.
  template <typename Camera>
  double tukey_cost(const AlignProblem<Camera>& problem, const AlignState& state, int level, double sigma_intensity) {
    are_current_ = false;
    const kernel::Costs costs = reduction.costs(
        problem.points, level, problem.camera.at_level(level), problem.image.levels[static_cast<std::size_t>(level)],
        problem.quads_at(level), state, residual_noise(sigma_intensity), problem.depth_at(level), residuals_);
    if (costs.seen < 10) return std::numeric_limits<double>::infinity();
    const double sum = costs.sum + problem.photometric_cost(state);
    if (problem.unseen_cost <= 0) return sum / costs.seen;
    const int all = problem.points.size();
    return (sum + problem.unseen_cost * (all - costs.seen)) / all;
  }

  /// Sets `costs` to the Tukey cost of each point on a level, with a given sigma_I. Negative if the point is not seen.
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

  /// Correlation of the visible points' intensities with those of a level at a pose, in [-1, 1]. It is -1 if less than
  /// `min_share` of all points are visible.
  template <typename Camera>
  double correlation(const AlignProblem<Camera>& problem, const SE3d& T, int level, double min_share) {
    are_current_ = false;
    const kernel::Moments m = reduction.moments(problem.points, level, problem.camera.at_level(level),
                                                problem.image.levels[static_cast<std::size_t>(level)],
                                                problem.quads_at(level), {T}, residuals_);
    if (m.seen < 10 || m.seen < min_share * problem.points.size()) return -1;
    const float n = static_cast<float>(m.seen), vx = m.xx - m.x * m.x / n, vy = m.yy - m.y * m.y / n;
    return vx > 0 && vy > 0 ? static_cast<double>((m.xy - m.x * m.y / n) / std::sqrt(vx * vy)) : 0;
  }

  /// Robust sigma_I of a level at a pose: the value for which the median normalised residual is that of a normal.
  template <typename Camera>
  double intensity_sigma(const AlignProblem<Camera>& problem, const AlignState& state, int level) {
    excluded_.clear();
    residuals(problem, level, state, 1);
    return scale_of_residuals();
  }

  /// Gain and offset at a given motion, by a robust line fit between the intensities. For a motion that was not
  /// aligned.
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
  static constexpr std::size_t kScalePoints = 1000;         ///< enough for the residual scale, to 4 %
  static constexpr double kStep = 0.02, kCoarseStep = 0.5;  ///< squared sigmas: smaller steps end level 0, others
  static constexpr double kSameScale = 0.02;  ///< relative difference up to which two residual scales are the same
  static double sq(double x) { return x * x; }

  ResidualNoise residual_noise(double sigma_intensity) const {
    return {static_cast<float>(sigma_intensity), static_cast<float>(settings.gradient_noise),
            static_cast<float>(settings.huber), static_cast<float>(settings.tukey), settings.gradient};
  }

  /// Excludes the outliers among the residuals that were computed last.
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
    are_current_ = false;
  }

  /// Robust sigma_I of the residuals that are not excluded: that for which the median of r^2 / (sigma_I^2 + extra) is
  /// the one of a normal, 1 / c^2 with c = kSigmaOfMedian. Half of the points then have c^2 r^2 - extra <= sigma_I^2,
  /// so that sigma_I^2 is the median of the left side.
  double scale_of_residuals() {
    const PointResiduals& p = residuals_;
    scratch_.resize(p.size());
    constexpr auto c2 = static_cast<float>(kSigmaOfMedian * kSigmaOfMedian);
    const auto least = static_cast<float>(sq(settings.min_intensity_sigma));
    std::size_t n = 0;
    const std::size_t step = std::max<std::size_t>(1, p.size() / kScalePoints);
    for (std::size_t i = 0; i < p.size(); i += step) {
      scratch_[n] = std::max(least, c2 * p.r[i] * p.r[i] - p.extra[i]);
      n += p.seen(i) && !(i < excluded_.size() && excluded_[i]);
    }
    scratch_.resize(n);
    return std::max(settings.min_intensity_sigma, static_cast<double>(std::sqrt(median_of_magnitudes(scratch_))));
  }

  /// Robust sigma of the values in `scratch_` about one.
  double scatter_about(double middle) {
    magnitudes_.resize(scratch_.size());
    for (std::size_t i = 0; i < scratch_.size(); ++i)
      magnitudes_[i] = std::abs(scratch_[i] - static_cast<float>(middle));
    return static_cast<double>(mad_sigma(magnitudes_));
  }

  /// H and g of a twist [x; a; b] from those of the twist about axes that are turned by R, [A x; a; b].
  static void turn(const Matrix3<double>& R, Matrix8& H) {
    for (const int k : {0, 3}) H.middleCols<3>(k) = (H.middleCols<3>(k) * R).eval();
    for (const int k : {0, 3}) H.middleRows<3>(k) = (R.transpose() * H.middleRows<3>(k)).eval();
  }
  static void turn(const Matrix3<double>& R, Vector8& g) {
    for (const int k : {0, 3}) g.segment<3>(k) = (R.transpose() * g.segment<3>(k)).eval();
  }

  /// One level of a problem.
  template <typename Camera>
  struct OnLevel {
    const AlignProblem<Camera>& problem;
    int level;
    Camera camera;
    const Image<std::uint8_t>& image;
    DepthTerm depth;
  };

  /// The normal equations of the last accepted state.
  struct Solved {
    Eigen::LDLT<Matrix8> solver;
    std::array<Vector8, 4> modes;  ///< NormalEquations::modes
    Matrix3<double> R;             ///< turn from the axes of x to those of the modes
  };

  /// Gauss-Newton on one level. On level 0 it is repeated if the first round changed the residual scale or did not
  /// converge. @param near as in `align_near`.
  template <typename Camera>
  void refine(const AlignProblem<Camera>& problem, int level, Alignment& a, bool want_covariance, bool near = false);

  /// Gauss-Newton at one residual scale, until the cost rises or a step is small. @param last set if any state was
  /// accepted.
  template <typename Camera>
  void step_to_minimum(const OnLevel<Camera>& on, Alignment& a, std::optional<Solved>& last);

  /// Adds the priors of the motion T_o, which has moved the centroid to `moved`, and of gain and offset.
  template <typename Camera>
  static void add_priors(const AlignProblem<Camera>& problem, const AlignState& state, const SE3d& T_o,
                         const Vector3<double>& moved, NormalEquations& sums);

  PointResiduals residuals_;
  bool are_current_ = false;  ///< whether they are those of the alignment at hand, on the level that is refined
  std::vector<std::uint8_t> excluded_;
  Buffer<float> scratch_, magnitudes_;
};

DOT_END_NAMESPACE

#include "dot/align/impl/refine.hpp"
