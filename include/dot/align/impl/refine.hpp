// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of align/aligner.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Reduction>
template <typename Camera>
void DirectAligner<Reduction>::refine(const AlignProblem<Camera>& problem, int level, Alignment& a,
                                      bool want_covariance, bool near) {
  const OnLevel<Camera> on{problem, level, problem.camera.at_level(level),
                           problem.image.levels[static_cast<std::size_t>(level)], problem.depth_at(level)};
  std::optional<Solved> last;
  a.seen = 0;
  for (int round = 0; round < 2; ++round) {
    const double scale_before = a.sigma_intensity;
    if (!are_current_) residuals(problem, level, a.state, a.sigma_intensity);
    if (near) std::fill(excluded_.begin(), excluded_.end(), std::uint8_t{0});
    a.sigma_intensity = scale_of_residuals();
    if (near) exclude_outliers(a);
    if (round > 0 && a.converged && std::abs(a.sigma_intensity - scale_before) < kSameScale * scale_before) {
      are_current_ = true;
      break;
    }
    are_current_ = false;
    step_to_minimum(on, a, last);
    if (level > 0) break;
  }
  if (!last || !want_covariance) return;
  a.covariance = last->solver.solve(Matrix8::Identity());
  for (std::size_t m = 0; m < 4; ++m) {
    turn(last->R, last->modes[m]);
    a.depth_modes[m] = -last->solver.solve(last->modes[m]);
  }
}

template <typename Reduction>
template <typename Camera>
void DirectAligner<Reduction>::step_to_minimum(const OnLevel<Camera>& on, Alignment& a, std::optional<Solved>& last) {
  const ResidualNoise noise = residual_noise(a.sigma_intensity);
  AlignState accepted = a.state;
  double accepted_cost = std::numeric_limits<double>::infinity();
  a.converged = false;
  for (int iteration = 0; iteration < settings.max_iterations; ++iteration) {
    // A = T_outer Tr(c') maps x to the twist about the centroid in the camera's axes: T <- A exp(x) A^-1 T.
    const SE3d T_o = on.problem.T_outer.inverse() * a.state.T;
    const Vector3<double> moved =
        on.problem.centred ? Vector3<double>(T_o * on.problem.centroid) : Vector3<double>::Zero();
    const SE3d A = on.problem.T_outer * SE3d::translation(moved);
    NormalEquations sums = reduction.linearize(on.problem.points, on.level, on.camera, on.image, a.state, noise,
                                               on.depth, excluded_.data(), A.t);
    if (sums.seen < 10) {
      a.state = accepted;
      return;
    }
    ++a.iterations;
    a.seen = sums.seen;
    turn(A.R, sums.H), turn(A.R, sums.g);
    add_priors(on.problem, a.state, T_o, moved, sums);
    if (sums.cost > accepted_cost) {
      a.state = accepted;
      a.converged = true;
      return;
    }
    accepted = a.state;
    accepted_cost = sums.cost;
    // Slight damping relative to each parameter keeps directions that no point constrains from diverging.
    Matrix8 damped = sums.H;
    damped.diagonal() += 1e-7 * sums.H.diagonal() + Vector8::Constant(1e-9);
    last = Solved{Eigen::LDLT<Matrix8>(damped), sums.modes, A.R};
    const Vector8 x = -last->solver.solve(sums.g);
    if (!x.allFinite()) return;
    const double decrease = -sums.g.dot(x);  // x' H x: the step in squared sigmas
    a.state.T = (A * SE3d::exp(x.head<6>()) * A.inverse() * a.state.T).normalized();
    a.state.gain += x[6];
    a.state.offset += x[7];
    if (decrease < (on.level > 0 ? kCoarseStep : kStep)) {
      a.converged = true;
      return;
    }
  }
}

template <typename Reduction>
template <typename Camera>
void DirectAligner<Reduction>::add_priors(const AlignProblem<Camera>& problem, const AlignState& state, const SE3d& T_o,
                                          const Vector3<double>& moved, NormalEquations& sums) {
  Matrix8& H = sums.H;
  Vector8& g = sums.g;
  if (problem.centred) {
    Vector6<double> p;
    p << moved - problem.centroid, so3::log(T_o.R);
    H.topLeftCorner<6, 6>() += problem.prior;
    g.head<6>() += problem.prior * p;
    sums.cost += 0.5 * p.dot(problem.prior * p) / sums.seen;
  }
  H(6, 6) += problem.gain_information;
  H(7, 7) += problem.offset_information;
  g[6] += problem.gain_information * (state.gain - problem.photometry.gain);
  g[7] += problem.offset_information * (state.offset - problem.photometry.offset);
  sums.cost += problem.photometric_cost(state) / sums.seen;
}

DOT_END_NAMESPACE
