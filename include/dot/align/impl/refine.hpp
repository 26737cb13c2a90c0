// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Cholesky>

/// @file
/// Definitions of align/aligner.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Reduction>
template <typename Camera>
void DirectAligner<Reduction>::refine(const AlignProblem<Camera>& problem, int level, Alignment& a,
                                      bool want_covariance, bool near) {
  const Camera camera = problem.camera.at_level(level);
  const Image<std::uint8_t>& image = problem.image.levels[static_cast<std::size_t>(level)];
  const DepthTerm depth = problem.depth_at(level);
  std::optional<Eigen::LDLT<Matrix8>> last;  // at the last accepted pose
  std::array<Vector8, 4> modes;
  Matrix3<double> modes_R;
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
    const ResidualNoise noise = residual_noise(a.sigma_intensity);
    AlignState accepted = a.state;
    double accepted_cost = std::numeric_limits<double>::infinity();
    a.converged = false;
    for (int iteration = 0; iteration < settings.max_iterations; ++iteration) {
      // A = T_outer Tr(c') maps x to the twist about the centroid in the camera's axes: T <- A exp(x) A^-1 T.
      const SE3d T_o = problem.T_outer.inverse() * a.state.T;
      const Vector3<double> moved = problem.centred ? Vector3<double>(T_o * problem.centroid) : Vector3<double>::Zero();
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
      // Slight damping relative to each parameter keeps directions that no point constrains from diverging.
      Matrix8 damped = H;
      damped.diagonal() += 1e-7 * H.diagonal() + Vector8::Constant(1e-9);
      const Eigen::LDLT<Matrix8> solver(damped);
      const Vector8 x = -solver.solve(g);
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

DOT_END_NAMESPACE
