// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dot/align/aligner.hpp"
#include "support/exact_points.hpp"

/// @file
/// Motion of an object with the camera's motion fixed, about the object's centroid. The bound is the camera's: without
/// noise the RMS error in the image stays under a twentieth of a pixel, here of some 300 points. For a box of 1 m at 3
/// m and 200 px focal length that is 0.75 mm sideways; along the ray, where the box's size tells, six times that; and
/// 10 mrad of tilt, which only foreshortening shows.

namespace {

using dot::Alignment;
using dot::AlignProblem;
using dot::DirectAligner;
using dot::Image;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr int kLevels = 3;
const Pinhole camera(small_camera());
const SE3d T_c{dot::so3::exp(Vector3<double>(0.01, -0.02, 0.01)), Vector3<double>(0.05, -0.02, -0.15)};

/// A box in the room that moves while the camera does: by `shift` in the world, and turning about its middle.
struct Pair {
  Rendering reference, current;
  SE3d T_o;
  PointSet points;
  Vector3<double> centroid = Vector3<double>::Zero();
  Pyramid image;
  Image<float> inverse_depth;

  Pair(const Vector3<double>& shift, const Vector3<double>& turn) {
    Body body = box(7, {0.6, 0.5, 0.4}, 50, 0.15, 1.2);
    body.T_world_body = {dot::so3::exp(Vector3<double>(0, 0.4, 0)), Vector3<double>(0.3, 0.1, 3.4)};
    Scene scene{{hopper(1), body}};
    reference = scene.render(camera, SE3d{});
    const SE3d before = body.T_world_body, after{dot::so3::exp(turn) * before.R, before.t + shift};
    T_o = object_motion(SE3d{}, before, after);
    scene.bodies[1].T_world_body = after;
    current = scene.render(camera, T_c.inverse());
    use(reference, current);
  }
  void use(const Rendering& seen_before, const Rendering& seen_now) {
    Pyramid pyramid;
    pyramid.build(seen_before.grey.view(), kLevels);
    points = exact_points(reference, camera, pyramid, 4, [&](int x, int y) { return inside(x, y); });
    image.build(seen_now.grey.view(), kLevels);
    inverse_depth = seen_now.inverse_depth();
    centroid.setZero();
    for (std::size_t i = 0; i < points.u.size(); ++i) centroid += X(i) / points.size();
  }
  bool inside(int x, int y) const {
    for (int j = y - 3; j <= y + 3; ++j)
      for (int i = x - 3; i <= x + 3; ++i)
        if (reference.ids(i, j) != 7) return false;
    return true;
  }
  Vector3<double> X(std::size_t i) const { return Vector3<double>(points.x[i], points.y[i], 1) / points.q[i]; }

  AlignProblem<Pinhole> problem(float depth_weight = 0) const {
    AlignProblem<Pinhole> p{points, image, camera};
    p.T_outer = T_c;
    p.centred = true;
    p.centroid = centroid;
    p.depth.inverse_depth = inverse_depth.view();
    p.depth.sigma = 0.002f;
    p.depth.agreement = 0.006f;
    p.depth.weight = depth_weight;
    return p;
  }
  static Alignment align(const AlignProblem<Pinhole>& problem) {
    DirectAligner<> aligner;
    Alignment a = aligner.align(problem, {T_c}, kLevels - 1);
    aligner.reject_outliers_and_refit(problem, a);
    return a;
  }
  double pixels_off(const Alignment& a) const {
    double sum = 0;
    for (std::size_t i = 0; i < points.u.size(); ++i)
      sum += (camera.project(Vector3<double>(a.state.T * X(i))) - camera.project(Vector3<double>(T_c * T_o * X(i))))
                 .squaredNorm();
    return std::sqrt(sum / points.size());
  }
  /// The twist about the moved centroid between two motions of the object; by default from the estimate to the truth.
  Vector6<double> error(const Alignment& a) const { return difference(T_c.inverse() * a.state.T, T_o); }
  Vector6<double> difference(const SE3d& from, const SE3d& to) const {
    const Vector3<double> c = from * centroid;
    return (SE3d::translation(-c) * to * from.inverse() * SE3d::translation(c)).log();
  }
};

void expect_exact(const Pair& pair, const Alignment& a) {
  EXPECT_LT(pair.pixels_off(a), 0.05);
  const Vector6<double> e = pair.error(a);
  EXPECT_LT(e.head<2>().norm(), 0.75e-3);
  EXPECT_LT(std::abs(e[2]), 4.5e-3);
  EXPECT_LT(e.tail<3>().norm(), 10e-3);
  EXPECT_GT(a.phi, 0.995);
  EXPECT_GT(a.inliers, 0.9 * a.seen);  // the motion hides some of the border
  EXPECT_EQ(a.inside, a.seen + a.occluded);
}

TEST(AlignObject, FindsATranslation) {
  for (const Vector3<double>& shift : {Vector3<double>(0.1, 0, 0), Vector3<double>(0, 0.06, -0.2)})
    for (const float depth_weight : {0.f, 0.05f}) {
      const Pair pair(shift, Vector3<double>::Zero());
      expect_exact(pair, Pair::align(pair.problem(depth_weight)));
    }
}

TEST(AlignObject, FindsARotation) {
  for (const Vector3<double>& turn : {Vector3<double>(0, 0.06, 0), Vector3<double>(0, 0, 0.08)})
    for (const float depth_weight : {0.f, 0.05f}) {
      const Pair pair(Vector3<double>::Zero(), turn);
      expect_exact(pair, Pair::align(pair.problem(depth_weight)));
    }
}

TEST(AlignObject, FindsBoth) {
  const Pair pair({0.06, 0.02, 0.1}, {0.02, -0.04, 0.03});
  for (const float depth_weight : {0.f, 0.05f}) expect_exact(pair, Pair::align(pair.problem(depth_weight)));
}

TEST(AlignObject, ThatStandsStaysWhereItIs) {
  const Pair pair(Vector3<double>::Zero(), Vector3<double>::Zero());
  expect_exact(pair, Pair::align(pair.problem()));
}

TEST(AlignObject, NoiseIsStatedHonestly) {
  // As for the camera: 1 +- 0.07 if the model were perfect, and a factor two for what it leaves out.
  Pair pair({0.06, 0.02, 0.1}, {0.02, -0.04, 0.03});
  const int seeds = 60;
  double chi2 = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Degradation before, after;
    before.noise = after.noise = 4;
    after.depth_noise = 0.002;
    before.seed = 2000 + 2 * seed;
    after.seed = before.seed + 1;
    pair.use(degraded(pair.reference, before), degraded(pair.current, after));
    const Alignment a = Pair::align(pair.problem(0.3f));
    const Vector6<double> e = pair.error(a);
    chi2 += e.dot(a.covariance.topLeftCorner<6, 6>().ldlt().solve(e)) / 6 / seeds;
  }
  EXPECT_GT(chi2, 0.5);
  EXPECT_LT(chi2, 2.5);
}

TEST(AlignObject, DepthModesPredictWhatADepthErrorDoes) {
  const Pair pair({0.06, 0.02, 0.1}, Vector3<double>::Zero());
  const auto align = [&](const PointSet& points, const Image<float>& measured, float weight) {
    AlignProblem<Pinhole> p = pair.problem(weight);
    p.depth.inverse_depth = measured.view();
    const AlignProblem<Pinhole> changed{points, pair.image, camera, p.depth, p.T_outer, true, p.centroid, p.prior};
    DirectAligner<> aligner;
    return aligner.align(changed, {T_c * pair.T_o}, 0);
  };
  const auto u_range = std::minmax_element(pair.points.u.begin(), pair.points.u.end());
  const auto v_range = std::minmax_element(pair.points.v.begin(), pair.points.v.end());
  const float u0 = *u_range.first, u1 = *u_range.second, v0 = *v_range.first, v1 = *v_range.second;
  const Alignment photometric = align(pair.points, pair.inverse_depth, 0);
  const Alignment both = align(pair.points, pair.inverse_depth, 1);
  for (std::size_t mode = 0; mode < 4; ++mode) {
    const Alignment& base = mode == 3 ? both : photometric;
    // x caused by an error of `size` 1/m in this mode.
    const auto effect = [&](float size) {
      PointSet points = pair.points;
      Image<float> measured = pair.inverse_depth;
      if (mode == 3)
        for (int y = 0; y < measured.height(); ++y)
          for (int x = 0; x < measured.width(); ++x) measured(x, y) += size;
      for (std::size_t i = 0; i < points.u.size() && mode < 3; ++i) {
        const float m[] = {1, 2 * (points.u[i] - u0) / (u1 - u0) - 1, 2 * (points.v[i] - v0) / (v1 - v0) - 1};
        points.q[i] += size * m[mode];
      }
      const Alignment off = align(points, measured, mode == 3 ? 1 : 0);
      return pair.difference(T_c.inverse() * base.state.T, T_c.inverse() * off.state.T);
    };
    // 2 cm: well above what the iterations leave. Central differences, as the second order is not small.
    const double size = 0.002;
    const Vector6<double> found = (effect(static_cast<float>(size)) - effect(static_cast<float>(-size))) / (2 * size);
    Vector6<double> metres;  // rotation as it shows at the box's border
    metres << 1, 1, 1, 0.5, 0.5, 0.5;
    const Vector6<double> predicted = base.depth_modes[mode].head<6>();
    EXPECT_LT((found - predicted).cwiseProduct(metres).norm(), 0.25 * found.cwiseProduct(metres).norm())
        << mode << "\nfound     " << found.transpose() << "\npredicted " << predicted.transpose();
  }
}

// Candidates are finished one after the other with one aligner; what the first excluded is nothing to the second.
TEST(AlignObject, FinishDoesNotDependOnTheCallBefore) {
  Pair pair({0.06, 0.02, 0.1}, Vector3<double>::Zero());
  Rendering spoilt = pair.current;  // a stain, as of a reflection, on a part of the object
  for (int y = 0; y < spoilt.ids.height(); ++y)
    for (int x = 0; x < spoilt.ids.width(); ++x)
      if (spoilt.ids(x, y) == 7 && (x + y) % 24 < 6)
        spoilt.grey(x, y) = static_cast<std::uint8_t>(255 - spoilt.grey(x, y));
  pair.use(pair.reference, spoilt);
  const AlignProblem<Pinhole> problem = pair.problem();
  const auto finish = [&](DirectAligner<>& aligner, const SE3d& T_o) {
    Alignment a;
    a.state.T = T_c * T_o;
    a.sigma_intensity = 2;
    aligner.reject_outliers_and_refit(problem, a);
    return a;
  };
  DirectAligner<> fresh, used;
  const Alignment expected = finish(fresh, pair.T_o);
  for (const double off : {0.02, 0.05}) {
    const Alignment other = finish(used, SE3d::translation(Vector3<double>(off, 0, 0)) * pair.T_o);
    EXPECT_LT(other.inliers, other.seen) << "excludes points";
    const Alignment again = finish(used, pair.T_o);
    EXPECT_EQ(again.sigma_intensity, expected.sigma_intensity) << off;
    EXPECT_EQ(again.state.T.t, expected.state.T.t) << off;
    EXPECT_EQ(again.inliers, expected.inliers) << off;
  }
}

TEST(AlignObject, CountsWhatTheDepthConfirms) {
  const Pair pair({0.06, 0.02, 0.1}, Vector3<double>::Zero());
  const Alignment good = Pair::align(pair.problem());
  EXPECT_EQ(good.with_depth, good.seen);
  EXPECT_GT(good.depth_agrees, 0.95 * good.with_depth);
  EXPECT_NEAR(good.depth_shift, 0, 5e-4);

  Pair other = pair;
  Degradation holes;
  holes.missing_depth = 0.5;
  other.inverse_depth = degraded(pair.current, holes).inverse_depth();
  const Alignment half = Pair::align(other.problem());
  EXPECT_NEAR(half.with_depth, 0.5 * half.seen, 4 * 0.5 * std::sqrt(half.seen));

  Degradation biased;
  biased.depth_bias[7] = -0.02;  // farther by 10 sigma
  other.inverse_depth = degraded(pair.current, biased).inverse_depth();
  const Alignment farther = Pair::align(other.problem());
  EXPECT_LT(farther.depth_agrees, 0.05 * good.seen);
  EXPECT_NEAR(farther.depth_shift, -0.02, 0.002);
  EXPECT_LT(farther.depth_spread, 0.1 * farther.depth_scatter);

  biased.depth_bias[7] = 0.2;  // something much nearer everywhere
  other.inverse_depth = degraded(pair.current, biased).inverse_depth();
  const Alignment hidden = Pair::align(other.problem());
  EXPECT_EQ(hidden.seen, 0);
  EXPECT_GT(hidden.occluded, 0.9 * pair.points.size());
  EXPECT_EQ(hidden.phi, 0);
}

TEST(AlignObject, PriorHoldsWhatTheImageDoesNotTell) {
  const Pair pair({0.1, 0, 0}, Vector3<double>::Zero());
  AlignProblem<Pinhole> problem = pair.problem();
  problem.prior = dot::Matrix6<double>::Identity() * 1e12;
  const SE3d held = T_c.inverse() * Pair::align(problem).state.T;
  EXPECT_LT((held * pair.centroid - pair.centroid).norm(), 1e-4);
  problem.prior = dot::Matrix6<double>::Identity() * 1e-2;  // 10 m, 10 rad
  expect_exact(pair, Pair::align(problem));
}

TEST(AlignObject, PriorHoldsTheContrast) {
  Pair pair({0.06, 0.02, 0.1}, Vector3<double>::Zero());
  Degradation darker;
  darker.gain = 0.8;
  pair.use(pair.reference, degraded(pair.current, darker));
  AlignProblem<Pinhole> problem = pair.problem();
  EXPECT_NEAR(Pair::align(problem).state.gain, 0.8, 0.01);
  problem.gain_information = 1e9;
  EXPECT_NEAR(Pair::align(problem).state.gain, 1, 1e-3);
}

}  // namespace
