// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera/radtan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "support/numeric_jacobian.hpp"

namespace {

using dot::Intrinsics;
using dot::Pinhole;
using dot::RadTan;
using dot::Vector2;
using dot::Vector3;
using dot::test::jacobian_matches;
using dot::test::JacobianCheck;
using dot::test::matrices_match;

using Distortion = std::array<double, 5>;

const Intrinsics room{520.9, 521.0, 325.1, 249.7, 640, 480, 0};
const Distortion none{};

/// Lenses whose image lies in the domain: none, barrel, pincushion, mixed, tangential, barrel with tangential.
const std::vector<Distortion> lenses{none,
                                     {-0.28, 0.09, 0, 0, -0.012},
                                     {0.2, -0.05, 0, 0, 0.01},
                                     {0.2312, -0.7849, -0.0033, -0.0001, 0.9172},
                                     {0, 0, 5e-3, -8e-3, 0},
                                     {-0.28, 0.09, 1.5e-3, -7e-4, -0.012}};

template <typename S>
class RadTanOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RadTanOf, Scalars);

/// Pixels that OpenCV 4.6's projectPoints gives for the same camera and points.
TYPED_TEST(RadTanOf, AgreesWithOpenCv) {
  using S = TypeParam;
  const S tolerance = std::is_same_v<S, double> ? S(1e-13) : S(1e-6);
  const RadTan camera(room, {-0.28, 0.09, 1.5e-3, -7e-4, -0.012});
  const auto expect = [&](const Vector3<S>& X, double u, double v) {
    EXPECT_TRUE(matrices_match(camera.project(X), Vector2<S>(static_cast<S>(u), static_cast<S>(v)), tolerance));
  };
  expect({S(0.5), S(-0.3), 2}, 452.174190563113, 173.488676388925);
  expect({S(-1.6), S(0.9), 3}, 72.4892104658729, 392.036660982405);
  expect({S(1.2), S(1.1), S(2.5)}, 549.272391988471, 455.703911347579);
  expect({0, 0, 1}, 325.1, 249.7);
}

TYPED_TEST(RadTanOf, WithoutDistortionEqualsPinhole) {
  using S = TypeParam;
  const S tolerance = S(4) * Eigen::NumTraits<S>::epsilon();
  const RadTan camera(room, none);
  const Pinhole pinhole(room);
  for (int v = 0; v < room.height; v += 40)
    for (int u = 0; u < room.width; u += 40) {
      const Vector2<S> pixel(static_cast<S>(u), static_cast<S>(v));
      EXPECT_TRUE(matrices_match(camera.unproject(pixel), pinhole.unproject(pixel), tolerance));
      const Vector3<S> X = S(2.5) * pinhole.unproject(pixel);
      Eigen::Matrix<S, 2, 3> J;
      Eigen::Matrix<S, 2, 3> J_pinhole;
      EXPECT_LE((camera.project(X, &J) - pinhole.project(X, &J_pinhole)).norm(), S(1000) * tolerance);
      EXPECT_TRUE(matrices_match(J, J_pinhole, tolerance));
    }
}

TYPED_TEST(RadTanOf, RoundTripOverTheImage) {
  using S = TypeParam;
  // In pixels: rounding is that of the image's size, also where the pixel is near zero.
  const S tolerance = std::is_same_v<S, double> ? S(1e-12) : S(5e-4);
  for (std::size_t lens = 0; lens < lenses.size(); ++lens) {
    const RadTan camera(room, lenses[lens]);
    for (int v = 0; v < room.height; v += 20)
      for (int u = 0; u < room.width; u += 20)
        for (const double depth : {0.4, 6.0}) {
          const Vector2<S> pixel(static_cast<S>(u + 0.3), static_cast<S>(v - 0.4));
          const Vector3<S> ray = camera.unproject(pixel);
          EXPECT_EQ(ray.z(), S(1));
          const Vector3<S> X = static_cast<S>(depth) * ray;
          EXPECT_LE((camera.project(X) - pixel).norm(), tolerance) << "lens " << lens << " at " << pixel.transpose();
        }
  }
}

TYPED_TEST(RadTanOf, RoundTripFromPointsOfTheDomain) {
  using S = TypeParam;
  const S tolerance = std::is_same_v<S, double> ? S(1e-12) : S(1e-5);
  for (std::size_t lens = 0; lens < lenses.size(); ++lens) {
    const RadTan camera(room, lenses[lens]);
    for (double x = -0.6; x <= 0.6; x += 0.05)
      for (double y = -0.45; y <= 0.45; y += 0.05) {
        const Vector3<S> ray(static_cast<S>(x), static_cast<S>(y), 1);
        EXPECT_TRUE(matrices_match(camera.unproject(camera.project(ray)), ray, tolerance)) << "lens " << lens;
      }
  }
}

TYPED_TEST(RadTanOf, JacobianIsTheDerivative) {
  using S = TypeParam;
  for (std::size_t lens = 0; lens < lenses.size(); ++lens) {
    const RadTan camera(room, lenses[lens]);
    for (const double depth : {1.0, 8.0}) {
      JacobianCheck<S> check;
      check.step = static_cast<S>(depth * (std::is_same_v<S, double> ? 1e-5 : 5e-3));
      for (int v = 0; v < room.height; v += 53)
        for (int u = 0; u < room.width; u += 67) {
          const Vector2<S> at(static_cast<S>(u), static_cast<S>(v));
          const Vector3<S> X = static_cast<S>(depth) * camera.unproject(at);
          Eigen::Matrix<S, 2, 3> J;
          const Vector2<S> pixel = camera.project(X, &J);
          EXPECT_LE((pixel - camera.project(X)).norm(), S(2000) * Eigen::NumTraits<S>::epsilon());
          EXPECT_TRUE(jacobian_matches(
              J, [&](const Vector3<S>& p) { return camera.project(p); }, X, check))
              << "lens " << lens << " pixel " << at.transpose();
        }
    }
  }
}

TYPED_TEST(RadTanOf, LevelsSeeTheSamePoints) {
  using S = TypeParam;
  const S tolerance = std::is_same_v<S, double> ? S(1e-13) : S(2e-6);
  for (const Distortion& lens : lenses) {
    const RadTan camera(room, lens);
    for (int level = 0; level < 5; ++level) {
      const RadTan small = camera.at_level(level);
      EXPECT_EQ(small.width(), room.width >> level);
      EXPECT_EQ(small.height(), room.height >> level);
      EXPECT_EQ(small.distortion(), lens);
      const S scale = S(1) / static_cast<S>(1 << level);
      for (const Vector3<S>& X : {Vector3<S>(0, 0, 3), Vector3<S>(-2, 1, 5), Vector3<S>(1, S(-1.5), 4)}) {
        const Vector2<S> expected = (camera.project(X).array() + S(0.5)) * scale - S(0.5);
        EXPECT_TRUE(matrices_match(small.project(X), expected, tolerance));
      }
    }
  }
}

TYPED_TEST(RadTanOf, ContainsIsThatOfTheImage) {
  using S = TypeParam;
  const RadTan camera(room, lenses.back());
  EXPECT_TRUE(camera.contains(Vector2<S>(0, 0), 0));
  EXPECT_TRUE(camera.contains(Vector2<S>(637, 477), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(638, 477), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(637, 478), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(std::numeric_limits<S>::quiet_NaN(), 5), 0));
}

TYPED_TEST(RadTanOf, UnprojectOutsideTheDomainStaysFinite) {
  using S = TypeParam;
  // r (1 - 0.5 r^2) has its largest value 0.544 at r = 0.816: 0.6 has no ray.
  const RadTan camera(Intrinsics{500, 500, 320, 240, 640, 480, 0}, {-0.5, 0, 0, 0, 0});
  for (const double r : {0.545, 0.6, 0.8164965809277260, 1.0}) {
    const Vector2<S> pixel(static_cast<S>(320 + 500 * r), 240);
    EXPECT_TRUE(camera.unproject(pixel).allFinite()) << r;
  }
  const Vector2<S> inside(static_cast<S>(320 + 500 * 0.54), 240);
  EXPECT_TRUE(matrices_match(camera.project(camera.unproject(inside)), inside, S(1e-5)));
}

TEST(RadTanModel, BarrelPullsInAndPincushionPushesOut) {
  const Vector3<double> X(0.4, 0.3, 1);
  const Vector2<double> centre(room.cx, room.cy);
  const double plain = (Pinhole(room).project(X) - centre).norm();
  EXPECT_LT((RadTan(room, {-0.2, 0, 0, 0, 0}).project(X) - centre).norm(), plain - 1);
  EXPECT_GT((RadTan(room, {0.2, 0, 0, 0, 0}).project(X) - centre).norm(), plain + 1);
}

TEST(RadTanLevels, MayNotBeEmptyOrNegative) {
  const RadTan camera(room, none);
  EXPECT_EQ(camera.at_level(8).height(), 1);
  EXPECT_THROW(camera.at_level(9), std::invalid_argument);
  EXPECT_THROW(camera.at_level(-1), std::invalid_argument);
}

/// The message of the exception that these arguments cause, empty when there is none.
std::string complaint(const Intrinsics& intrinsics, const Distortion& distortion) {
  try {
    const RadTan camera(intrinsics, distortion);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(RadTanArguments, BadOnesAreNamed) {
  for (std::size_t i = 0; i < 5; ++i)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Distortion distortion{};
      distortion[i] = bad;
      EXPECT_EQ(complaint(room, distortion), "distortion must be finite") << i;
    }
  Intrinsics bad = room;
  bad.fy = -1;
  EXPECT_EQ(complaint(bad, none), "intrinsics.fy must be 1 to 1e6 pixels");
}

TEST(RadTanArguments, GoodOnesAreKept) {
  EXPECT_EQ(complaint(room, lenses.back()), "");
  const RadTan camera(room, lenses.back());
  EXPECT_EQ(camera.distortion(), lenses.back());
  EXPECT_EQ(camera.intrinsics().cx, room.cx);
  EXPECT_EQ(camera.width(), 640);
  EXPECT_EQ(camera.height(), 480);
}

TEST(RadTanConcept, IsACamera) { EXPECT_TRUE(dot::is_camera_v<RadTan>); }

}  // namespace
