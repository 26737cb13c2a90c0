// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// What is found of the camera's motion while its velocity is unknown, and what is believed.

#include "dot/camera_motion/estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include "dot/tracker.hpp"
#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::Alignment;
using dot::CameraMotionEstimator;
using dot::DirectAligner;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

const Pinhole camera(small_camera());
/// 24 degrees wide: a small turn moves the image far.
const dot::Intrinsics tele{750, 750, 159.5, 119.5, 320, 240, 0.2};

Pyramid pyramid_of(const Rendering& view) {
  Pyramid pyramid;
  pyramid.build(view.grey.view(), 3);
  return pyramid;
}

const std::vector<const PointSet*> no_objects;
const dot::MotionEvidence nobody{no_objects, {}};

/// From standing still at `reference`, without a velocity.
Alignment found(const Rendering& reference, const Rendering& current, double metres, double radians = 0.12,
                const Pinhole& by = camera, const CameraMotionEstimator& estimator = {}) {
  const Pyramid before = pyramid_of(reference);
  const PointSet points = exact_points(
      reference, by, before, 4, [](int, int) { return true; }, 0.001f);
  DirectAligner<> aligner;
  dot::MinimaWorkspace workspace;
  const dot::CameraSearch search{metres, radians, before, {}};
  return estimator.estimate(points, pyramid_of(current), by, {SE3d{}}, &search, nobody, aligner, workspace);
}

class FarForward : public testing::TestWithParam<double> {};

// Of the yard's wall and ground, half is nearer than 10 m.
TEST_P(FarForward, IsFoundWithoutAPrediction) {
  Scene scene;
  scene.bodies.push_back(yard(100));
  const SE3d T_world_camera = SE3d::translation(Vector3<double>(0, 0, GetParam()));
  const Alignment a = found(scene.render(camera, SE3d{}), scene.render(camera, T_world_camera), 18);
  EXPECT_LT((a.state.T.t + T_world_camera.t).norm(), 0.01 * std::abs(GetParam()));
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
}

INSTANTIATE_TEST_SUITE_P(Metres, FarForward, testing::Values(0.5, 3.0, 6.0, -3.0));

// As when the camera comes out of a tunnel, or into one.
TEST(CameraSearch, FollowsTheExposure) {
  Scene scene;
  scene.bodies.push_back(yard(100));
  const Rendering before = scene.render(camera, SE3d{});
  for (const double metres : {1.5, 3.0, 4.5, 6.0, 7.5})
    for (const double gain : {0.4, 0.7, 1.3}) {
      const SE3d T_world_camera = SE3d::translation(Vector3<double>(0, 0, metres));
      Rendering now = scene.render(camera, T_world_camera);
      for (int y = 0; y < camera.height(); ++y)
        for (int x = 0; x < camera.width(); ++x) now.intensity(x, y) = static_cast<float>(gain) * now.intensity(x, y);
      now.round();
      const Alignment a = found(before, now, 18);
      EXPECT_LT((a.state.T.t + T_world_camera.t).norm(), 0.01 * metres) << metres << " m, gain " << gain;
    }
}

/// Of the camera in the world: axis times degrees, and metres ahead; and the points that a host wants seen, of 4800.
struct Turn {
  Vector3<double> degrees;
  double ahead;
  int min_points = 100;

  friend void PrintTo(const Turn& turn, std::ostream* out) {
    *out << turn.degrees.transpose() << " degrees, " << turn.ahead << " m ahead, " << turn.min_points << " points";
  }
};
class LargeTurn : public testing::TestWithParam<Turn> {};

// The image moves by up to 100 of its 320 pixels.
TEST_P(LargeTurn, IsFoundWithoutAPrediction) {
  Scene scene;
  scene.bodies.push_back(yard(100));
  const Pinhole narrow(tele);
  const SE3d T_world_camera{dot::so3::exp(Vector3<double>(GetParam().degrees / 57.29577951)), {0, 0, GetParam().ahead}};
  const Rendering before = scene.render(narrow, SE3d{}), now = scene.render(narrow, T_world_camera);
  CameraMotionEstimator estimator;
  estimator.settings.min_points = GetParam().min_points;
  const Alignment a = found(before, now, 4, 0.12, narrow, estimator);
  const SE3d off = a.state.T * T_world_camera;
  EXPECT_LT(off.t.norm(), 0.1);  // a narrow view hardly tells a turn from a shift
  EXPECT_LT(dot::so3::log(off.R).norm(), 0.005);
  EXPECT_TRUE(estimator.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
}

INSTANTIATE_TEST_SUITE_P(Axes, LargeTurn,
                         testing::Values(Turn{{0, 6, 0}, 0}, Turn{{0, -7, 0}, 0.5}, Turn{{5, 0, 0}, 0.5},
                                         Turn{{-4, 5, 0}, 0.5}, Turn{{2, -5, 4}, 0.5}, Turn{{-3, 3, 0}, 0.5, 1000}));

/// The yard, its points as the camera sees them from the origin, and the search of its motion from there.
struct SearchedYard {
  Scene scene;
  Pyramid before;
  PointSet points;
  DirectAligner<> aligner;
  dot::MinimaWorkspace workspace;

  SearchedYard() {
    scene.bodies.push_back(yard(100));
    const Rendering reference = scene.render(camera, SE3d{});
    before = pyramid_of(reference);
    points = exact_points(
        reference, camera, before, 4, [](int, int) { return true; }, 0.001f);
  }
  Pyramid seen_from(const SE3d& T_world_camera) const { return pyramid_of(scene.render(camera, T_world_camera)); }
  /// The starts of the search with some effort, in the view `now`.
  const std::vector<dot::AlignState>& starts(const Pyramid& now, const dot::CameraSearch::Effort& effort) {
    const dot::CameraSearch search{6, 0.12, before, {}};
    const dot::AlignProblem<Pinhole> problem{points, now, camera};
    search.find(problem, 10, 10, aligner, workspace);
    search.find_shifts(problem, 10, 10, effort, aligner, workspace);
    return workspace.starts;
  }
};

// A turn that was looked for alone is off by what a shift has moved the image, and the shift by that.
TEST(CameraSearch, ImprovesWhatItFound) {
  SearchedYard yard;
  double found = 0, improved = 0;
  for (const double degrees : {3.0, -4.0, 5.0, -2.0, 1.0}) {
    const SE3d T_world_camera{dot::so3::exp(Vector3<double>(0, degrees / 57.29577951, 0)), {0.3, 0, 2.3}};
    const Pyramid now = yard.seen_from(T_world_camera);
    const auto nearest = [&](int rounds) {
      double pixels = std::numeric_limits<double>::infinity();
      for (const dot::AlignState& place : yard.starts(now, {8, 40, rounds, 350}))
        pixels = std::min(pixels, pose_distance(yard.points, camera, place.T, T_world_camera.inverse()));
      return pixels;
    };
    found += nearest(0);
    improved += nearest(2);
  }
  EXPECT_LT(improved, 0.6 * found);
}

// What costs more than twice as much as the best place is not aligned.
TEST(CameraSearch, DropsHopelessPlaces) {
  SearchedYard yard;
  const Pyramid now = yard.seen_from({dot::so3::exp(Vector3<double>(0, 0.02, 0)), {0.1, 0, 0.5}});
  std::vector<double> costs;
  for (const dot::AlignState& place : yard.starts(now, dot::CameraSearch::kThorough))
    costs.push_back(yard.aligner.tukey_cost(dot::AlignProblem<Pinhole>{yard.points, now, camera}, place,
                                            dot::CameraSearch::level_of(4), 10));
  ASSERT_FALSE(costs.empty());
  // The costs of all points are not quite those of the part that decides.
  EXPECT_LT(*std::max_element(costs.begin(), costs.end()), 2.5 * *std::min_element(costs.begin(), costs.end()));
  EXPECT_EQ(yard.starts(now, {8, 1, 1, 350}).size(), 1u);
}

// Places of an earlier search are no rotations of this one, even where hardly any rotation fits.
TEST(TurnSearch, DoesNotDependOnTheCallBefore) {
  Scene scene;
  scene.bodies.push_back(yard(100));
  const Pyramid before = pyramid_of(scene.render(camera, SE3d{}));
  const SE3d turned{dot::so3::exp(Vector3<double>(0, 0.02, 0)), Vector3<double>::Zero()};
  const Pyramid now = pyramid_of(scene.render(camera, turned));
  DirectAligner<> aligner;
  for (const double radians : {0.0, 0.12}) {
    dot::MinimaWorkspace fresh, used;
    const SE3d elsewhere{dot::so3::exp(Vector3<double>(0, 0, 0.5)), Vector3<double>::Zero()};
    used.tried.assign(20, {-2, dot::AlignState{elsewhere}});  // better than any correlation
    const dot::TurnSearch search{radians, before};
    search.find(now, camera, aligner, fresh);
    search.find(now, camera, aligner, used);
    ASSERT_EQ(used.turns.size(), fresh.turns.size());
    for (std::size_t i = 0; i < fresh.turns.size(); ++i) {
      EXPECT_EQ(used.turns[i].first, fresh.turns[i].first);
      EXPECT_EQ(used.turns[i].second.T.R, fresh.turns[i].second.T.R);
    }
  }
}

// A kerb, a pothole: it moves otherwise than before.
TEST(Jerk, IsFoundThoughAnotherVelocityIsKnown) {
  constexpr int jerk = 5;
  Film<> film{Pinhole(tele)};
  film.camera_path = [](double t) {
    const bool turned = t > 0.1 * jerk - 0.05 && t < 0.1 * jerk + 0.05;
    const Vector3<double> turn = turned ? Vector3<double>(0.06, 0.08, 0.03) : Vector3<double>(0, 0, 0);
    return SE3d{dot::so3::exp(turn), {0, 0, 1.5 * t}};
  };
  dot::Tracker tracker(tele);
  film.next(tracker);
  for (int i = 1; i < 9; ++i) {
    const dot::Result& result = film.next(tracker);
    EXPECT_EQ(result.camera.status, dot::CameraStatus::Tracked) << i;
    EXPECT_LT((SE3d::from_row_major(result.camera.T_cur_prev) * film.T_c().inverse()).log().norm(), 0.1) << i;
  }
}

/// A wall 5 m away whose pattern repeats every 24 pixels, moved to the left by `shift` of that, and over it one that
/// does not repeat.
Rendering tiles(double shift, double contrast_of_the_rest) {
  const Texture rest(7, 1, 4, contrast_of_the_rest);
  Rendering view;
  view.intensity.resize(camera.width(), camera.height());
  view.depth.resize(camera.width(), camera.height());
  const double k = 6.283185307179586 / 24;
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const double u = x + 24 * shift;
      const double grey = 128 + 30 * (std::sin(k * u) + std::sin(k * y)) + rest(u / 40, y / 40.0) - 128;
      view.intensity(x, y) = static_cast<float>(grey);
      view.depth(x, y) = 5;
    }
  view.round();
  return view;
}

TEST(AmbiguousMotion, IsNotBelievedUnlessExpected) {
  const Alignment a = found(tiles(0, 0), tiles(0.5, 0), 1);
  EXPECT_LT(a.margin, 0.01) << a.state.T.t.transpose();
  EXPECT_FALSE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, true)) << "phi " << a.phi << " margin " << a.margin;
}

TEST(AmbiguousMotion, IsBelievedWhereSomethingElseTells) {
  const Alignment a = found(tiles(0, 15), tiles(0.4, 15), 1);
  EXPECT_NEAR(a.state.T.t.x(), -0.4 * 24 * 5 / 200, 0.02);
  EXPECT_GT(a.margin, 0.1);
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
}

/// A wall 5 m away, moved by `shift` pixels; over a third of it lie shadows with soft edges, moved by `shadows`.
Rendering shadowed_wall(double shift, double shadows, double contrast = 12) {
  const Texture fine(3, 3, 8, contrast);
  Rendering view;
  view.intensity.resize(camera.width(), camera.height());
  view.depth.resize(camera.width(), camera.height());
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      double dark = 0;
      if (y > 80 && y < 160)
        for (const int edge : {30, 70, 120, 190, 250, 290})
          dark += 20 * std::tanh((x - shadows - edge) / 6) * (edge % 20 ? 1 : -1);
      view.intensity(x, y) = static_cast<float>(fine(x - shift, y) - dark);
      view.depth(x, y) = 5;
    }
  view.round();
  return view;
}

// A coarse level shows little but the shadows.
TEST(MovingShadows, DoNotCaptureTheSearch) {
  for (const double shift : {16.0, 20.0}) {
    const Alignment a = found(shadowed_wall(0, 0), shadowed_wall(shift, shift + 5), 1);
    EXPECT_NEAR(a.state.T.t.x(), shift * 5 / 200, 0.01);
  }
}

// Nor the refinement: where little else has contrast, Huber's cost leads from the truth to what the shadows do.
TEST(MovingShadows, DoNotCaptureTheRefinement) {
  constexpr double shift = 3;
  const SE3d truth = SE3d::translation(Vector3<double>(shift * 5 / 200, 0, 0));
  const Rendering reference = shadowed_wall(0, 0, 3);
  const Pyramid before = pyramid_of(reference);
  const PointSet points = exact_points(
      reference, camera, before, 4, [](int, int) { return true; }, 0.001f);
  for (const double shadows : {4.0, 5.0}) {
    const Pyramid now = pyramid_of(shadowed_wall(shift, shift + shadows, 3));
    DirectAligner<> aligner;
    const Alignment huber = aligner.align(dot::AlignProblem<Pinhole>{points, now, camera}, {truth}, 1, 1);
    EXPECT_GT(pose_distance(points, camera, huber.state.T, truth), 3);
    dot::MinimaWorkspace workspace;
    const Alignment a =
        CameraMotionEstimator{}.estimate(points, now, camera, {truth}, nullptr, nobody, aligner, workspace);
    EXPECT_LT(pose_distance(points, camera, a.state.T, truth), 0.2);
  }
}

/// A road 1.5 m below the camera, which is `ahead` metres further and turned to the right by `yaw` radians, and a wall
/// at 20 m. Across the road lie shadows with soft edges, moved by `shadows` metres.
Rendering shadowed_road(double ahead, double shadows, double yaw = 0) {
  const Texture fine(3, 3, 8, 8);
  const dot::Intrinsics& k = camera.intrinsics();
  Rendering view;
  view.intensity.resize(camera.width(), camera.height());
  view.depth.resize(camera.width(), camera.height());
  const double c = std::cos(yaw), si = std::sin(yaw);
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const double right = (x - k.cx) / k.fx, down = (y - k.cy) / k.fy;
      const double to_side = c * right + si, to_front = c - si * right;  // of the ray, in the road's directions
      const double wall = (20 - ahead) / to_front;
      const bool on_road = down * wall > 1.5;
      const double z = on_road ? 1.5 / down : wall, across = to_side * z, along = to_front * z + ahead;
      double dark = 0;
      for (const double edge : {3.2, 4.1, 5.5})
        if (on_road) dark += 25 * std::tanh((along - shadows - edge) / 0.12) * (edge == 4.1 ? -1 : 1);
      const double grey = on_road ? fine(20 * across, 8 * along) : fine(6 * across, 6 * down * z);
      view.intensity(x, y) = static_cast<float>(grey - dark);
      view.depth(x, y) = static_cast<float>(z);
    }
  view.round();
  return view;
}

// What the shadows lead to is a minimum of its own; the truth lies along the optical axis.
TEST(MovingShadows, AreLeftAlongTheAxis) {
  constexpr double ahead = 0.25;
  const Rendering reference = shadowed_road(0, 0);
  const Pyramid before = pyramid_of(reference);
  const PointSet points = exact_points(
      reference, camera, before, 3, [](int, int) { return true; }, 0.001f);
  for (const double shadows : {0.1, 0.15, 0.2}) {
    const Pyramid now = pyramid_of(shadowed_road(ahead, shadows));
    const SE3d captured = SE3d::translation(Vector3<double>(0, 0, shadows - ahead));
    DirectAligner<> aligner;
    dot::MinimaWorkspace workspace;
    const Alignment a =
        CameraMotionEstimator{}.estimate(points, now, camera, {captured}, nullptr, nobody, aligner, workspace);
    EXPECT_LT((a.state.T.t + Vector3<double>(0, 0, ahead)).norm(), 0.005) << shadows;
  }
}

// The camera goes on as predicted, but turns: the coarse levels find the turn, and the motion of the shadows with it.
TEST(UnexpectedTurn, IsFoundAtThePredictedPlace) {
  constexpr double ahead = 0.25;
  const Rendering reference = shadowed_road(0, 0);
  const Pyramid before = pyramid_of(reference);
  const PointSet points = exact_points(
      reference, camera, before, 3, [](int, int) { return true; }, 0.001f);
  const SE3d predicted = SE3d::translation({0, 0, -ahead});
  const dot::TurnSearch turns{0.12, before};
  int wrong_without = 0;
  for (const double yaw : {-0.06, -0.03, 0.03, 0.06})
    for (const double shadows : {0.1, 0.15, 0.2}) {
      const Pyramid now = pyramid_of(shadowed_road(ahead, shadows, yaw));
      const SE3d truth = SE3d{dot::so3::exp(Vector3<double>(0, -yaw, 0)), Vector3<double>::Zero()} * predicted;
      const auto error = [&](const dot::TurnSearch* searched) {
        DirectAligner<> aligner;
        dot::MinimaWorkspace workspace;
        dot::MotionEvidence evidence{no_objects, {}, 0.2};
        evidence.turns = searched;
        const Alignment a =
            CameraMotionEstimator{}.estimate(points, now, camera, {predicted}, nullptr, evidence, aligner, workspace);
        return (a.state.T * truth.inverse()).log().norm();
      };
      EXPECT_LT(error(&turns), 0.01) << yaw << " rad, shadows moved by " << shadows << " m";
      wrong_without += error(nullptr) > 0.05 ? 1 : 0;
    }
  EXPECT_GT(wrong_without, 0);
}

// Where the place changes, near points move in the image as well; that is no turn.
TEST(UnexpectedTurn, IsToldByPixels) {
  const Rendering reference = shadowed_road(0, 0);
  const PointSet points = exact_points(reference, camera, pyramid_of(reference), 3, [](int, int) { return true; });
  const SE3d predicted = SE3d::translation({0, 0, -1});
  const double pixel = 1 / camera.intrinsics().fx;
  const auto turned = [&](double pixels) {
    return SE3d{dot::so3::exp(Vector3<double>(0, pixels * pixel, 0)), {0.5, 0, -1.5}};
  };
  EXPECT_FALSE(dot::UnexpectedTurn::is_in(points, camera, turned(2), predicted));
  EXPECT_TRUE(dot::UnexpectedTurn::is_in(points, camera, turned(6), predicted));
}

TEST(Accepts, AsksForABetterCorrelationWithoutAVelocity) {
  const CameraMotionEstimator estimator;
  Alignment a;
  a.covariance.setIdentity();
  a.seen = 1000, a.inliers = 900;
  a.phi = 0.5 * (estimator.settings.min_phi + estimator.settings.min_phi_unexpected);
  EXPECT_TRUE(estimator.accepts(a, true));
  EXPECT_FALSE(estimator.accepts(a, false));
  a.phi = 0.9;
  EXPECT_TRUE(estimator.accepts(a, false));
  a.inliers = 100;
  EXPECT_FALSE(estimator.accepts(a, true));
}

TEST(CameraMotionEstimator, DoesNotAcceptWhatHasNoCovariance) {
  CameraMotionEstimator estimator;
  Alignment a;
  a.covariance.setIdentity();
  a.seen = a.inliers = 500;
  a.phi = 0.99;
  ASSERT_TRUE(estimator.accepts(a, true));
  a.covariance(0, 0) = -1e-3;
  EXPECT_FALSE(estimator.accepts(a, true));
  a.covariance(0, 0) = 1;
  a.covariance(0, 1) = a.covariance(1, 0) = 1.5;  // more than any correlation
  EXPECT_FALSE(estimator.accepts(a, true));
  a.covariance(0, 1) = a.covariance(1, 0) = std::nan("");
  EXPECT_FALSE(estimator.accepts(a, true));
}

}  // namespace
