// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/lens_distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"
#include "dot/pipeline/dot.hpp"
#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::Alignment;
using dot::AlignProblem;
using dot::DirectAligner;
using dot::Dot;
using dot::LensDistortion;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::RadTan;
using dot::SE3d;
using dot::Suspicion;
using dot::Vector3;
using namespace dot::test;

/// A walk with a camera in the hand, through a lens of radial distortion k.
Film<RadTan> walk(double k) {
  Film<RadTan> film(RadTan(small_camera(), {k, 0, 0, 0, 0}));
  film.degradation.noise = 1;
  film.camera_path = [](double t) {
    const Vector3<double> turned(0.02 * std::sin(3 * t), 0.1 * std::sin(2 * t), 0.02 * t);
    return SE3d{dot::so3::exp(turned), Vector3<double>(0.3 * std::sin(2 * t), 0, t)};
  };
  return film;
}

/// Pixels by which k moves the corner of `small_camera`.
double corner(double k) {
  const dot::Intrinsics c = small_camera();
  double largest = 0;
  for (const double u : {0.0, c.width - 1.0})
    for (const double v : {0.0, c.height - 1.0}) {
      const double x = (u - c.cx) / c.fx, y = (v - c.cy) / c.fy;
      largest = std::max(largest, std::abs(k) * (x * x + y * y) * std::hypot(x * c.fx, y * c.fy));
    }
  return largest;
}

/// What is measured over 20 frames with a camera model of its own and exact depth.
template <typename Camera>
double measured(Film<RadTan>& film, const Camera& camera) {
  LensDistortion lens;
  DirectAligner<> aligner;
  film.advance();
  for (int i = 0; i < 20; ++i) {
    Pyramid before, image;
    before.build(std::as_const(film.seen().grey).view(), 3);
    const PointSet points = exact_points(film.seen(), camera, before, 5, [](int, int) { return true; });
    film.advance();
    image.build(std::as_const(film.seen().grey).view(), 3);
    const AlignProblem<Camera> problem{points, image, camera};
    Alignment a = aligner.align(problem, {film.T_c()}, 1);
    aligner.reject_outliers_and_refit(problem, a);
    lens.add(points, image.levels[0], camera, a, aligner.settings, 4);
  }
  return lens.shift(camera);
}

TEST(LensDistortion, IsMeasuredAtTheCorner) {
  for (const double k : {-0.05, 0.05}) {
    Film<RadTan> film = walk(k);
    const double shift = measured(film, Pinhole(small_camera()));
    EXPECT_GT(shift, 0.5 * corner(k)) << k;
    EXPECT_LT(shift, 1.2 * corner(k)) << k;
  }
}

TEST(LensDistortion, IsNoneWithTheRightModel) {
  for (const double k : {0.0, -0.2}) {
    Film<RadTan> film = walk(k);
    EXPECT_EQ(measured(film, RadTan(small_camera(), {k, 0, 0, 0, 0})), 0) << k;
  }
}

// Its images hardly tell k: what they say is chance.
TEST(LensDistortion, IsNoneOfACameraThatStands) {
  Film<RadTan> film = walk(0);
  film.camera_path = straight(Vector3<double>::Zero());
  EXPECT_EQ(measured(film, Pinhole(small_camera())), 0);
}

/// The diagnosis after 20 frames of a host that has not undistorted them.
Suspicion suspected(double k, bool along_the_ray = false) {
  Film<RadTan> film = walk(k);
  if (along_the_ray)
    film.spoil = [](int, Rendering& seen) {
      const Pinhole pinhole(small_camera());
      for (int y = 0; y < seen.depth.height(); ++y)
        for (int x = 0; x < seen.depth.width(); ++x)
          seen.depth(x, y) *= static_cast<float>(pinhole.unproject(dot::Vector2<double>(x, y)).norm());
    };
  Dot<> dot{Pinhole(small_camera())};
  Suspicion out{};
  for (int i = 0; i < 20; ++i) out = film.next(dot).diagnosis.reason;
  return out;
}

TEST(LensDistortion, IsNamedByTheDiagnosis) {
  EXPECT_EQ(suspected(-0.1), Suspicion::LensDistortion);
  EXPECT_EQ(suspected(0), Suspicion::None);
}

TEST(LensDistortion, AndSoIsDepthAlongTheRay) { EXPECT_EQ(suspected(0, true), Suspicion::LensDistortion); }

}  // namespace
