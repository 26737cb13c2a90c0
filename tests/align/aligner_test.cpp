// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/aligner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/exact_points.hpp"

/// @file
/// Camera motion on scenes of known motion. What the aligner cannot know better: images are rounded to grey values and
/// interpolated between pixels (a few tenths of a grey value at gradients of ten per pixel), averaged over hundreds of
/// points. So without noise the mean error in the image must stay under a twentieth of a pixel. At 200 px focal length
/// and 4 m that is 1 mm or 0.25 mrad each; translation and rotation trade against each other by a few times that.

namespace {

using dot::Alignment;
using dot::AlignProblem;
using dot::DirectAligner;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr int kLevels = 3;
const Pinhole camera(small_camera());
const auto everywhere = [](int, int) { return true; };

SE3d motion(double x, double y, double z, double pitch, double yaw, double roll) {
  return {dot::so3::exp(Vector3<double>(pitch, yaw, roll)), Vector3<double>(x, y, z)};
}

/// One scene before and after a motion of the camera.
struct Pair {
  Scene scene{{hopper(1, 0.5, 4)}};
  SE3d T_cur_ref;
  Rendering reference, current;
  PointSet points;
  Pyramid image;

  explicit Pair(const SE3d& T, const Degradation& of_current = {}, const Degradation& of_reference = {})
      : T_cur_ref(T) {
    reference = degraded(scene.render(camera, SE3d{}), of_reference);
    Pyramid pyramid;
    pyramid.build(reference.grey.view(), kLevels);
    points = exact_points(reference, camera, pyramid, 8, everywhere);
    current = scene.render(camera, T.inverse());
    image.build(degraded(current, of_current).grey.view(), kLevels);
  }
  AlignProblem<Pinhole> problem() const { return {points, image, camera}; }

  Alignment align(const SE3d& start) const {
    DirectAligner<> aligner;
    Alignment a = aligner.align(problem(), {start}, kLevels - 1);
    aligner.reject_outliers_and_refit(problem(), a);
    return a;
  }
  /// RMS distance in the image between where a pose puts the points and where they are.
  double pixels_off(const SE3d& T, const SE3d& other) const {
    double sum = 0;
    for (std::size_t i = 0; i < points.u.size(); ++i) {
      const Vector3<double> X = Vector3<double>(points.x[i], points.y[i], 1) / points.q[i];
      sum += (camera.project(Vector3<double>(T * X)) - camera.project(Vector3<double>(other * X))).squaredNorm();
    }
    return std::sqrt(sum / points.size());
  }
  double pixels_off(const Alignment& a) const { return pixels_off(a.state.T, T_cur_ref); }
};

/// The left twist between the truth and an estimate.
Vector6<double> error(const Pair& pair, const Alignment& a) { return (pair.T_cur_ref * a.state.T.inverse()).log(); }

void expect_exact(const Pair& pair, const Alignment& a) {
  EXPECT_LT(pair.pixels_off(a), 0.05);
  EXPECT_LT(error(pair, a).head<3>().norm(), 4e-3);
  EXPECT_LT(error(pair, a).tail<3>().norm(), 1e-3);
  EXPECT_GT(a.phi, 0.995);
  EXPECT_TRUE(a.converged);
  EXPECT_GT(a.inliers, 0.95 * a.seen);
}

TEST(AlignCamera, FindsATranslation) {
  for (const SE3d& T : {motion(0.1, 0, 0, 0, 0, 0), motion(0, -0.08, 0, 0, 0, 0), motion(0, 0, -0.3, 0, 0, 0)}) {
    const Pair pair(T);
    expect_exact(pair, pair.align(SE3d{}));
  }
}

TEST(AlignCamera, FindsARotation) {
  for (const SE3d& T : {motion(0, 0, 0, 0.03, 0, 0), motion(0, 0, 0, 0, -0.04, 0), motion(0, 0, 0, 0, 0, 0.06)}) {
    const Pair pair(T);
    expect_exact(pair, pair.align(SE3d{}));
  }
}

TEST(AlignCamera, FindsBoth) {
  const Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03));
  expect_exact(pair, pair.align(SE3d{}));
}

TEST(AlignCamera, FindsItByTheGradientsOfEitherImage) {
  const Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03));
  for (const dot::GradientSource gradient : {dot::GradientSource::Reference, dot::GradientSource::Mean}) {
    DirectAligner<> aligner;
    aligner.settings.gradient = gradient;
    Alignment a = aligner.align(pair.problem(), {SE3d{}}, kLevels - 1);
    aligner.reject_outliers_and_refit(pair.problem(), a);
    expect_exact(pair, a);
  }
}

TEST(AlignCamera, RefinesAPrediction) {
  const SE3d T = motion(0.6, 0.1, -0.5, 0.05, -0.12, 0.1);
  const Pair pair(T);
  expect_exact(pair, pair.align(motion(0.01, -0.02, 0.03, 0.005, 0, -0.01) * T));
}

TEST(AlignCamera, ComesFromFarAwayOverThePyramid) {
  for (const SE3d& T :
       {motion(0.4, 0, 0, 0, 0, 0), motion(0, 0, 0, 0, 0.09, 0), motion(0.25, 0, -0.2, 0.05, 0, 0.05)}) {
    const Pair pair(T);
    EXPECT_GT(pair.pixels_off(SE3d{}, T), 15);
    expect_exact(pair, pair.align(SE3d{}));
  }
}

TEST(AlignCamera, RecoversGainAndOffset) {
  for (const auto& [gain, offset] : {std::pair{0.7, 20.0}, std::pair{1.25, -35.0}, std::pair{1.0, 12.0}}) {
    Degradation exposure;
    exposure.gain = gain;
    exposure.offset = offset;
    const Pair pair(motion(0.05, 0, -0.1, 0, 0.02, 0), exposure);
    const Alignment a = pair.align(SE3d{});
    expect_exact(pair, a);
    // Interpolation takes some contrast off, at the middle of the grey values nothing.
    EXPECT_NEAR(a.state.gain, gain, 0.01);
    EXPECT_NEAR(a.state.gain * 128 + a.state.offset, gain * 128 + offset, 0.2);
  }
}

TEST(AlignCamera, StaysWhereItIsRight) {
  const Pair pair{SE3d{}};
  const Alignment a = pair.align(SE3d{});
  EXPECT_LT(error(pair, a).norm(), 1e-6);
  EXPECT_NEAR(a.state.gain, 1, 1e-5);
  EXPECT_NEAR(a.state.offset, 0, 1e-3);
  EXPECT_EQ(a.inliers, pair.points.size());
  EXPECT_EQ(a.seen, pair.points.size());
  EXPECT_NEAR(a.phi, 1, 1e-6);
}

TEST(AlignCamera, NoiseIsMeasuredAndStatedHonestly) {
  // Mean of chi^2 / 6 over the seeds. A perfect model gives 1 +- 0.07. The model is none: the blur correlates
  // neighbouring points, which the covariance takes as independent (up to 2 for points 8 px apart with noisy
  // gradients), and the gradient noise term allows for errors that this scene has not (down to 0.5).
  const SE3d T = motion(0.05, -0.02, -0.15, 0.01, -0.02, 0.01);
  const Pair clean(T);
  const int seeds = 60;
  double chi2 = 0, variance = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Degradation before, after;
    before.noise = after.noise = 5;
    before.seed = 1000 + 2 * seed;
    after.seed = before.seed + 1;
    Pyramid pyramid;
    pyramid.build(degraded(clean.reference, before).grey.view(), kLevels);
    Pair noisy = clean;
    noisy.points = exact_points(clean.reference, camera, pyramid, 8, everywhere);
    noisy.image.build(degraded(clean.current, after).grey.view(), kLevels);
    const Alignment a = noisy.align(T);
    const Vector6<double> e = error(noisy, a);
    chi2 += e.dot(a.covariance.topLeftCorner<6, 6>().ldlt().solve(e)) / 6 / seeds;
    variance += a.reduced_chi2 / seeds;
    EXPECT_LT(noisy.pixels_off(a), 0.3);
    EXPECT_GT(a.phi, 0.97);
  }
  EXPECT_GT(chi2, 0.5);
  EXPECT_LT(chi2, 2.5);
  EXPECT_NEAR(variance, 1, 0.3);
}

TEST(AlignCamera, FinishRejectsOutliers) {
  Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03));
  Random random(31);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < pair.points.u.size(); ++i) {
    if (random.uniform() >= 0.2) continue;
    ++wrong;
    const auto value = static_cast<float>(random.uniform(20, 235));
    for (int l = 0; l < kLevels; ++l) pair.points.intensity[static_cast<std::size_t>(l)][i] = value;
  }
  const Alignment a = pair.align(SE3d{});
  EXPECT_LT(pair.pixels_off(a), 0.05);
  // Some of the replaced values happen to be within the bound of the right ones.
  EXPECT_GT(a.inliers, a.seen - 1.02 * static_cast<double>(wrong));
  EXPECT_LT(a.inliers, a.seen - 0.8 * static_cast<double>(wrong));
  EXPECT_GT(a.phi, 0.99);
  EXPECT_NEAR(a.state.gain, 1, 0.02);
}

TEST(AlignCamera, CorrelationIsThatOfWhatIsSeen) {
  const SE3d T = motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03);
  Degradation exposed;
  exposed.gain = 0.7, exposed.offset = 20, exposed.noise = 0.5;
  const Pair pair(T, exposed);
  DirectAligner<> aligner;
  EXPECT_GT(aligner.correlation(pair.problem(), T, 0, 0.5), 0.99);
  EXPECT_LT(aligner.correlation(pair.problem(), SE3d{}, 0, 0.5), 0.9);
  const SE3d aside = motion(0, 0, 0, 0, 0.7, 0);
  EXPECT_EQ(aligner.correlation(pair.problem(), aside, 0, 0.6), -1);
  EXPECT_GT(aligner.correlation(pair.problem(), aside, 0, 0.1), -1);
}

// Outliers of one alignment are none of the next one's business.
TEST(AlignCamera, TheScaleDoesNotRememberOutliers) {
  Degradation noisy;
  noisy.noise = 6;  // a scale above its floor
  Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03), noisy);
  Random random(32);
  for (std::size_t i = 0; i < pair.points.u.size(); i += 5)
    for (int l = 0; l < kLevels; ++l)
      pair.points.intensity[static_cast<std::size_t>(l)][i] = static_cast<float>(random.uniform(20, 235));
  DirectAligner<> used, fresh;
  Alignment a = used.align(pair.problem(), {SE3d{}}, kLevels - 1);
  used.reject_outliers_and_refit(pair.problem(), a);
  ASSERT_LT(a.inliers, a.seen);
  EXPECT_EQ(used.intensity_sigma(pair.problem(), a.state, 0), fresh.intensity_sigma(pair.problem(), a.state, 0));
}

// A level starts from the scale of the coarser one, where the noise is averaged out.
TEST(AlignCamera, TheScaleDoesNotDependOnItsStart) {
  Degradation noisy;
  noisy.noise = 12;
  Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03), noisy);
  for (std::size_t i = 0; i < pair.points.q.size(); ++i) pair.points.sigma_q[i] = 0.3f * pair.points.q[i];
  DirectAligner<> aligner;
  const Alignment a = aligner.align(pair.problem(), {pair.T_cur_ref}, kLevels - 1);
  EXPECT_LT(aligner.intensity_sigma(pair.problem(), a.state, kLevels - 1), 0.5 * a.sigma_intensity);
  EXPECT_NEAR(a.sigma_intensity, aligner.intensity_sigma(pair.problem(), a.state, 0), 0.03 * a.sigma_intensity);
}

/// A weakly textured room, and in it a small high-contrast thing that turns about the camera: to its points the camera
/// seems to have turned.
struct Captured {
  SE3d turn;
  PointSet points;
  Pyramid image;

  explicit Captured(double yaw) : turn(motion(0, 0, 0, 0, yaw, 0)) {
    Body thing = box(7, {0.55, 0.55, 0.1}, 50, 0.25, 1, 40);
    thing.T_world_body.t = {0, 0, 3};
    Scene scene{{hopper(1, 0.5, 4, 5), thing}};
    const Rendering reference = scene.render(camera, SE3d{});
    scene.bodies[1].T_world_body = turn * thing.T_world_body;
    Pyramid before;
    before.build(reference.grey.view(), kLevels);
    image.build(scene.render(camera, SE3d{}).grey.view(), kLevels);
    points = exact_points(reference, camera, before, 4,
                          [](int x, int y) { return x % 16 < 4 || (x > 110 && x < 210 && y > 70); });
  }
  AlignProblem<Pinhole> problem() const { return {points, image, camera}; }
};

TEST(AlignCamera, TukeyRanksTheMajorityFirstWhereHuberIsCaptured) {
  const Captured c(0.02);
  DirectAligner<> aligner;
  const double sigma = aligner.intensity_sigma(c.problem(), {SE3d{}}, 0);
  const auto huber = [&](const SE3d& T) {
    const dot::ResidualNoise noise{static_cast<float>(sigma), 0.06f, 1.345f};
    return aligner.reduction.linearize(c.points, 0, camera, c.image.levels[0], {T, 1, 0}, noise, {}, nullptr).cost;
  };
  const auto tukey = [&](const SE3d& T) { return aligner.tukey_cost(c.problem(), {T, 1, 0}, 0, sigma); };
  EXPECT_GT(huber(SE3d{}), huber(c.turn));
  EXPECT_LT(tukey(SE3d{}), 0.8 * tukey(c.turn));
}

// Huber's cost leads from where the majority is, the identity, to the minority, at 3.6 pixels.
TEST(AlignCamera, NearKeepsToTheMajorityThatHubersCostLeaves) {
  const Captured c(0.018);
  DirectAligner<> aligner;
  const auto pixels = [&](const Alignment& a) { return camera.intrinsics().fx * dot::so3::log(a.state.T.R).norm(); };
  for (const int level : {0, 1}) {
    EXPECT_GT(pixels(aligner.align(c.problem(), {SE3d{}}, level, level)), 3);
    EXPECT_LT(pixels(aligner.align_near(c.problem(), {SE3d{}}, level)), 0.5);
  }
}

// Without a minority it is the same.
TEST(AlignCamera, NearFindsWhatIsNear) {
  const Pair pair(motion(0.05, -0.03, -0.1, 0.01, -0.02, 0.03));
  DirectAligner<> aligner;
  Alignment a = aligner.align_near(pair.problem(), {motion(0.01, 0, 0, 0, 0.004, 0) * pair.T_cur_ref}, 0);
  aligner.reject_outliers_and_refit(pair.problem(), a);
  expect_exact(pair, a);
}

// What the coarse levels saw must not pass for what the finest one sees.
TEST(AlignCamera, SeenAreThePointsOfTheFinestLevel) {
  Pair pair{SE3d{}};
  DirectAligner<> aligner;
  EXPECT_GT(aligner.align(pair.problem(), {}, kLevels - 1).seen, 100);
  pair.image.levels[0].resize(4, 4);  // too small to sample
  EXPECT_EQ(aligner.align(pair.problem(), {}, kLevels - 1).seen, 0);
}

TEST(AlignCamera, RankOfWhatNobodySeesIsInfinite) {
  const Pair pair{SE3d{}};
  DirectAligner<> aligner;
  EXPECT_TRUE(std::isinf(aligner.tukey_cost(pair.problem(), {motion(0, 0, -50, 0, 0, 0)}, 0, 5)));
  EXPECT_TRUE(std::isfinite(aligner.tukey_cost(pair.problem(), {SE3d{}}, 0, 5)));
  const Alignment a = aligner.align(pair.problem(), {motion(0, 0, -50, 0, 0, 0)}, kLevels - 1);
  EXPECT_TRUE(a.state.T.t.allFinite());
}

TEST(AlignCamera, RankCountsWhatLeavesWhereAsked) {
  const SE3d T = motion(0, 0, 0, 0, 0.4, 0);  // a quarter of the points leave the view
  const Pair pair(T);
  DirectAligner<> aligner;
  AlignProblem<Pinhole> problem = pair.problem();
  const double free = aligner.tukey_cost(problem, {T}, 0, 5);
  problem.unseen_cost = 3;
  const double costly = aligner.tukey_cost(problem, {T}, 0, 5);
  EXPECT_GT(costly, free + 0.5);
  EXPECT_LT(costly, 3);
}

}  // namespace
