// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <Eigen/Cholesky>

#include "dot/align/aligner.hpp"
#include "support/exact_points.hpp"

/// @file
/// The depth residual is q_measured(p') - q'. Its derivative in the aligner is that of q' alone: that of q_measured,
/// grad q . dp'/dx, is left out. On a slanted surface it is as large as the other. These tests compare the aligner with
/// Gauss-Newton on the whole derivative, on a plane that is turned away by up to 65 degrees.

namespace {

using dot::Alignment;
using dot::AlignProblem;
using dot::AlignState;
using dot::DirectAligner;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector2;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

const Pinhole camera(small_camera());
const SE3d T_c{dot::so3::exp(Vector3<double>(0.01, -0.02, 0.01)), Vector3<double>(0.05, -0.02, -0.15)};
constexpr double kImageNoise = 4;      // grey values
constexpr double kDepthNoise = 0.002;  // 1/m

/// A slanted board before a wall; it moves aside and nearer while the camera moves.
struct Board {
  Rendering reference, current;
  SE3d T_o;
  Vector3<double> normal, place;  ///< of its plane in the new camera: normal . (X - place) = 0
  PointSet points;
  Vector3<double> centroid = Vector3<double>::Zero();
  Pyramid image;
  dot::Image<float> inverse_depth;

  explicit Board(double slant) {
    Body body;
    body.id = 7;
    body.quads.push_back(
        {Vector3<double>::Zero(), Vector3<double>(0.8, 0, 0), Vector3<double>(0, 0.5, 0), Texture(50, 0.2, 1.2)});
    body.T_world_body = {dot::so3::exp(Vector3<double>(0, slant, 0)), Vector3<double>(0.1, 0, 3)};
    Scene scene{{hopper(1), body}};
    reference = scene.render(camera, SE3d{});
    const SE3d before = body.T_world_body, after{before.R, before.t + Vector3<double>(0.06, 0.02, -0.05)};
    T_o = object_motion(SE3d{}, before, after);
    scene.bodies[1].T_world_body = after;
    current = scene.render(camera, T_c.inverse());
    const SE3d T_cur_body = T_c * after;
    normal = T_cur_body.R.col(2), place = T_cur_body.t;
    Pyramid pyramid;
    pyramid.build(reference.grey.view(), 2);
    points = exact_points(reference, camera, pyramid, 4, [&](int x, int y) {
      for (int j = y - 3; j <= y + 3; ++j)
        for (int i = x - 3; i <= x + 3; ++i)
          if (reference.ids(i, j) != 7) return false;
      return true;
    });
    for (std::size_t i = 0; i < points.u.size(); ++i) centroid += X(i) / points.size();
  }
  Vector3<double> X(std::size_t i) const { return Vector3<double>(points.x[i], points.y[i], 1) / points.q[i]; }

  void see(unsigned seed) {
    Degradation d;
    d.noise = kImageNoise, d.depth_noise = kDepthNoise, d.seed = 100 + seed;
    const Rendering seen = degraded(current, d);
    image.build(seen.grey.view(), 2);
    inverse_depth = seen.inverse_depth();
  }
  AlignProblem<Pinhole> problem(float weight) const {
    AlignProblem<Pinhole> p{points, image, camera};
    p.T_outer = T_c;
    p.centred = true;
    p.centroid = centroid;
    p.depth.inverse_depth = inverse_depth.view();
    p.depth.sigma = static_cast<float>(kDepthNoise);
    p.depth.agreement = static_cast<float>(3 * kDepthNoise);
    p.depth.weight = weight;
    return p;
  }
  Vector6<double> error(const SE3d& T) const {
    const SE3d estimate = T_c.inverse() * T;
    const Vector3<double> c = estimate * centroid;
    return (SE3d::translation(-c) * T_o * estimate.inverse() * SE3d::translation(c)).log();
  }

  /// measured - predicted inverse depth of the exact board, a smooth function of the pose.
  /// @param measured_at pose at which it is measured.
  double exact_difference(const SE3d& T, const SE3d& measured_at, std::size_t i) const {
    const Vector3<double> ray = camera.unproject<double>(camera.project<double>(Vector3<double>(measured_at * X(i))));
    return normal.dot(ray) / normal.dot(place) - 1 / (T * X(i)).z();
  }
};

/// Gauss-Newton from the truth with numeric derivatives.
/// @param whole that of the depth residual with the gradient of the measured depth.
SE3d align_numerically(const Board& board, const AlignProblem<Pinhole>& problem, bool whole) {
  dot::DefaultReduction reduction;
  const dot::ResidualNoise noise{static_cast<float>(kImageNoise)};
  AlignState state{T_c * board.T_o};
  const auto residuals = [&](const AlignState& at, dot::PointResiduals& out) {
    reduction.residuals(board.points, 0, camera, board.image.levels[0], at, noise, problem.depth_at(0), out);
  };
  const auto stepped = [&](const AlignState& from, int k, double by) {
    AlignState to = from;
    if (k == 6) to.gain += by;
    if (k == 7) to.offset += by;
    if (k >= 6) return to;
    const Vector3<double> c = from.T * board.centroid;
    to.T = SE3d::translation(c) * SE3d::exp(by * Vector6<double>::Unit(k)) * SE3d::translation(-c) * from.T;
    return to;
  };
  for (int iteration = 0; iteration < 8; ++iteration) {
    dot::PointResiduals here, plus[8], minus[8];
    residuals(state, here);
    const double steps[8] = {1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 0.1};
    for (int k = 0; k < 8; ++k)
      residuals(stepped(state, k, steps[k]), plus[k]), residuals(stepped(state, k, -steps[k]), minus[k]);
    dot::Matrix8 H = dot::Matrix8::Zero();
    dot::Vector8 g = dot::Vector8::Zero();
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (!here.seen(i)) continue;
      dot::Vector8 J, J_depth;
      for (int k = 0; k < 8; ++k) {
        J[k] = static_cast<double>(plus[k].r[i] - minus[k].r[i]) / (2 * steps[k]);
        const SE3d after = stepped(state, k, steps[k]).T, before = stepped(state, k, -steps[k]).T;
        J_depth[k] = (board.exact_difference(after, whole ? after : state.T, i) -
                      board.exact_difference(before, whole ? before : state.T, i)) /
                     (2 * steps[k]);
      }
      const double w = 1 / (kImageNoise * kImageNoise);
      H += w * J * J.transpose(), g += w * J * static_cast<double>(here.r[i]);
      if (!here.has_depth(i)) continue;
      const double wd = static_cast<double>(problem.depth.weight) / (kDepthNoise * kDepthNoise);
      H += wd * J_depth * J_depth.transpose(), g += wd * J_depth * static_cast<double>(here.r_depth[i]);
    }
    const dot::Vector8 x = -H.ldlt().solve(g);
    for (int k = 6; k < 8; ++k) state = stepped(state, k, x[k]);
    const Vector3<double> c = state.T * board.centroid;
    state.T = SE3d::translation(c) * SE3d::exp(x.head<6>()) * SE3d::translation(-c) * state.T;
  }
  return state.T;
}

/// Root mean square of the centroid's errors over the seeds, metres.
struct Errors {
  double squares = 0;
  int n = 0;
  void add(const Vector6<double>& e) { squares += e.head<3>().squaredNorm(), ++n; }
  double rms() const { return std::sqrt(squares / n); }
};

TEST(DepthGradient, LeftOutOfTheDerivativeItCostsNothingOnSlantedPlanes) {
  constexpr int seeds = 60;
  for (const double slant : {0.0, 0.8, 1.13})
    for (const float weight : {0.05f, 0.3f}) {
      SCOPED_TRACE("slant " + std::to_string(slant) + ", weight " + std::to_string(weight));
      Board board(slant);
      ASSERT_GT(board.points.size(), 150);
      Errors whole, part;
      double chi2 = 0;
      for (unsigned seed = 0; seed < seeds; ++seed) {
        board.see(seed);
        const AlignProblem<Pinhole> problem = board.problem(weight);
        whole.add(board.error(align_numerically(board, problem, true)));
        part.add(board.error(align_numerically(board, problem, false)));
        DirectAligner<> aligner;
        Alignment a = aligner.align(problem, {T_c * board.T_o}, 0);
        aligner.reject_outliers_and_refit(problem, a);
        const Vector6<double> e = board.error(a.state.T);
        chi2 += e.dot(a.covariance.topLeftCorner<6, 6>().ldlt().solve(e)) / 6 / seeds;
      }
      EXPECT_LT(part.rms(), 1.05 * whole.rms());
      // The aligner's covariance is honest as elsewhere: 1, and a factor two for what the model leaves out.
      EXPECT_GT(chi2, 0.5);
      EXPECT_LT(chi2, 2);
    }
}

// The comparison can fail: without texture along the slant the photometric part says nothing of that direction, and
// only the whole derivative knows that the board did not come nearer but went aside.
TEST(DepthGradient, TheWholeDerivativeIsLargeOnSlantedPlanes) {
  Board board(1.13);
  board.see(0);
  const SE3d truth = T_c * board.T_o;
  const SE3d aside{dot::Matrix3<double>::Identity(), Vector3<double>(1e-3, 0, 0)};
  double whole = 0, part = 0;
  for (std::size_t i = 0; i < board.points.u.size(); ++i) {
    whole += std::abs(board.exact_difference(aside * truth, aside * truth, i));
    part += std::abs(board.exact_difference(aside * truth, truth, i));
  }
  EXPECT_GT(whole, 10 * part);
}

}  // namespace
