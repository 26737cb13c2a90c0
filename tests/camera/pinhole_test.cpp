// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera/pinhole.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/numeric_jacobian.hpp"

namespace {

using dot::Intrinsics;
using dot::Pinhole;
using dot::Vector2;
using dot::Vector3;
using dot::test::jacobian_matches;
using dot::test::JacobianCheck;
using dot::test::matrices_match;

const Intrinsics street{718.856, 707.1, 607.1928, 185.2157, 1241, 376, 0.54};

template <typename S>
class PinholeOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PinholeOf, Scalars);

TYPED_TEST(PinholeOf, ProjectsKnownPoints) {
  using S = TypeParam;
  const Pinhole camera(Intrinsics{500, 400, 320, 240, 640, 480, 0});
  EXPECT_EQ(camera.project(Vector3<S>(0, 0, 7)), Vector2<S>(320, 240));
  EXPECT_EQ(camera.project(Vector3<S>(1, -1, 2)), Vector2<S>(570, 40));
  EXPECT_EQ(camera.unproject(Vector2<S>(570, 40)), Vector3<S>(S(0.5), S(-0.5), 1));
}

TYPED_TEST(PinholeOf, RoundTripOverTheImage) {
  using S = TypeParam;
  // In pixels: rounding is that of the image's size, also where the pixel is near zero.
  const S tolerance = std::is_same_v<S, double> ? S(5e-13) : S(2e-4);
  const Pinhole camera(street);
  for (int v = 0; v < street.height; v += 25)
    for (int u = 0; u < street.width; u += 40)
      for (const double depth : {0.3, 4.0, 120.0}) {
        const Vector2<S> pixel(static_cast<S>(u + 0.25), static_cast<S>(v - 0.125));
        const Vector3<S> ray = camera.unproject(pixel);
        EXPECT_EQ(ray.z(), S(1));
        const Vector3<S> X = static_cast<S>(depth) * ray;
        const Vector2<S> back = camera.project(X);
        EXPECT_LE((back - pixel).norm(), tolerance) << pixel.transpose();
        EXPECT_TRUE(matrices_match(camera.unproject(back), ray, tolerance / S(100)));
      }
}

TYPED_TEST(PinholeOf, JacobianIsTheDerivative) {
  using S = TypeParam;
  const Pinhole camera(street);
  JacobianCheck<S> check;
  for (const double depth : {1.0, 5.0, 40.0}) {
    check.step = static_cast<S>(depth * (std::is_same_v<S, double> ? 1e-5 : 1e-2));
    for (int v = 0; v < street.height; v += 47)
      for (int u = 0; u < street.width; u += 83) {
        const Vector3<S> X = static_cast<S>(depth) * camera.unproject(Vector2<S>(static_cast<S>(u), static_cast<S>(v)));
        Eigen::Matrix<S, 2, 3> J;
        const Vector2<S> pixel = camera.project(X, &J);
        EXPECT_LE((pixel - camera.project(X)).norm(), S(4000) * Eigen::NumTraits<S>::epsilon());
        EXPECT_TRUE(jacobian_matches(
            J, [&](const Vector3<S>& p) { return camera.project(p); }, X, check));
      }
  }
}

TYPED_TEST(PinholeOf, LevelsSeeTheSamePoints) {
  using S = TypeParam;
  const S tolerance = std::is_same_v<S, double> ? S(1e-13) : S(2e-6);
  const Pinhole camera(street);
  for (int level = 0; level < 6; ++level) {
    const Pinhole small = camera.at_level(level);
    EXPECT_EQ(small.width(), street.width >> level);
    EXPECT_EQ(small.height(), street.height >> level);
    EXPECT_EQ(small.intrinsics().baseline, street.baseline);
    const S scale = S(1) / static_cast<S>(1 << level);
    for (const Vector3<S>& X : {Vector3<S>(0, 0, 3), Vector3<S>(-2, 1, 9), Vector3<S>(6, S(-1.5), 20)}) {
      const Vector2<S> expected = (camera.project(X).array() + S(0.5)) * scale - S(0.5);
      EXPECT_TRUE(matrices_match(small.project(X), expected, tolerance));
    }
  }
}

TYPED_TEST(PinholeOf, ContainsCountsFromTheOutermostPixelCentres) {
  using S = TypeParam;
  const Pinhole camera(Intrinsics{500, 500, 320, 240, 640, 480, 0});
  EXPECT_TRUE(camera.contains(Vector2<S>(0, 0), 0));
  EXPECT_TRUE(camera.contains(Vector2<S>(639, 479), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(S(-0.01), 5), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(5, S(-0.01)), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(S(639.01), 5), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(5, S(479.01)), 0));
  EXPECT_TRUE(camera.contains(Vector2<S>(2, 2), 2));
  EXPECT_TRUE(camera.contains(Vector2<S>(637, 477), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(S(1.9), 100), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(S(637.1), 100), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(100, S(1.9)), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(100, S(477.1)), 2));
  EXPECT_FALSE(camera.contains(Vector2<S>(std::numeric_limits<S>::quiet_NaN(), 100), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(100, std::numeric_limits<S>::quiet_NaN()), 0));
  EXPECT_FALSE(camera.contains(Vector2<S>(std::numeric_limits<S>::infinity(), 100), 0));
}

TEST(PinholeLevels, HalfSizeMatchesTheMeanOfFourPixels) {
  const Pinhole half = Pinhole(Intrinsics{500, 400, 320, 240, 641, 480, 0}).at_level(1);
  EXPECT_EQ(half.intrinsics().fx, 250);
  EXPECT_EQ(half.intrinsics().fy, 200);
  EXPECT_EQ(half.intrinsics().cx, 159.75);
  EXPECT_EQ(half.intrinsics().cy, 119.75);
  EXPECT_EQ(half.width(), 320);
  // The centre of the four pixels (10..11, 20..21) is the pixel (5, 10) of the half image.
  const Vector3<double> ray = half.unproject(Vector2<double>(5, 10));
  const Pinhole full(Intrinsics{500, 400, 320, 240, 641, 480, 0});
  EXPECT_TRUE(matrices_match(full.project(ray), Vector2<double>(10.5, 20.5), 1e-13));
}

TEST(PinholeLevels, AddUp) {
  const Pinhole camera(street);
  const Intrinsics at_once = camera.at_level(3).intrinsics();
  const Intrinsics by_steps = camera.at_level(1).at_level(2).intrinsics();
  EXPECT_DOUBLE_EQ(at_once.fx, by_steps.fx);
  EXPECT_DOUBLE_EQ(at_once.fy, by_steps.fy);
  EXPECT_DOUBLE_EQ(at_once.cx, by_steps.cx);
  EXPECT_DOUBLE_EQ(at_once.cy, by_steps.cy);
  EXPECT_EQ(at_once.width, by_steps.width);
  EXPECT_EQ(at_once.height, by_steps.height);
}

TEST(PinholeLevels, MayBeSmallButNotEmptyOrNegative) {
  const Pinhole camera(Intrinsics{20, 20, 8, 8, 20, 16, 0});
  EXPECT_EQ(camera.at_level(4).height(), 1);
  for (const int level : {-1, 5, 31, 32, 100}) EXPECT_THROW(camera.at_level(level), std::invalid_argument) << level;
}

/// The message of the exception that these intrinsics cause, empty when there is none.
std::string complaint(const Intrinsics& intrinsics) {
  try {
    const Pinhole camera(intrinsics);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(PinholeArguments, BadOnesAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto with = [](double Intrinsics::*field, double value) {
    Intrinsics changed = street;
    changed.*field = value;
    return complaint(changed);
  };
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity, 1e-300, 1e300}) {
    EXPECT_EQ(with(&Intrinsics::fx, bad), "intrinsics.fx must be 1 to 1e6 pixels");
    EXPECT_EQ(with(&Intrinsics::fy, bad), "intrinsics.fy must be 1 to 1e6 pixels");
  }
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    EXPECT_EQ(with(&Intrinsics::cx, bad), "intrinsics.cx must be finite, at most 1e6 pixels");
    EXPECT_EQ(with(&Intrinsics::cy, bad), "intrinsics.cy must be finite, at most 1e6 pixels");
  }
  for (const double bad : {-0.1, nan, infinity, 1e-300, 1e5})
    EXPECT_EQ(with(&Intrinsics::baseline, bad), "intrinsics.baseline must be 0 or 1e-4 to 10 metres");
  for (const int bad : {15, 0, -640, 1 << 30}) {
    Intrinsics changed = street;
    changed.width = bad;
    EXPECT_EQ(complaint(changed), "intrinsics.width must be 16 to 32768");
    changed = street;
    changed.height = bad;
    EXPECT_EQ(complaint(changed), "intrinsics.height must be 16 to 32768");
  }
  {
    Intrinsics changed = street;
    changed.width = 32768, changed.height = 8192;
    EXPECT_EQ(complaint(changed), "");
    changed.height = 8193;
    EXPECT_EQ(complaint(changed), "intrinsics.width times height must be at most 2^28 pixels");
  }
}

TEST(PinholeArguments, GoodOnesAreKept) {
  EXPECT_EQ(complaint(street), "");
  EXPECT_EQ(complaint({1, 1, -50, 900, 16, 16, 0}), "");
  const Pinhole camera(street);
  EXPECT_EQ(camera.width(), 1241);
  EXPECT_EQ(camera.height(), 376);
  EXPECT_EQ(camera.intrinsics().fx, street.fx);
  EXPECT_EQ(camera.intrinsics().baseline, street.baseline);
}

/// Has everything of a camera but for double alone.
struct DoubleOnly {
  Vector2<double> project(const Vector3<double>& X, Eigen::Matrix<double, 2, 3>* = nullptr) const {
    return X.head<2>();
  }
  Vector3<double> unproject(const Vector2<double>& p) const { return p.homogeneous(); }
  bool contains(const Vector2<double>&, double) const { return true; }
  DoubleOnly at_level(int) const { return *this; }
  int width() const { return 1; }
  int height() const { return 1; }
  const Intrinsics& intrinsics() const { return street; }
};

struct WithoutLevels : Pinhole {
  using Pinhole::Pinhole;
  void at_level(int) const = delete;
};

struct NoDerivative : Pinhole {
  using Pinhole::Pinhole;
  NoDerivative at_level(int) const { return *this; }
  template <typename S>
  Vector2<S> project(const Vector3<S>& X) const {
    return Pinhole::project(X);
  }
};

struct LevelsOfAnotherType : Pinhole {
  using Pinhole::Pinhole;
};

TEST(CameraConcept, AcceptsCamerasAndNothingElse) {
  EXPECT_TRUE(dot::is_camera_v<Pinhole>);
  EXPECT_FALSE(dot::is_camera_v<int>);
  EXPECT_FALSE(dot::is_camera_v<Intrinsics>);
  EXPECT_FALSE(dot::is_camera_v<DoubleOnly>);
  EXPECT_FALSE(dot::is_camera_v<WithoutLevels>);
  EXPECT_FALSE(dot::is_camera_v<NoDerivative>);
  EXPECT_FALSE(dot::is_camera_v<LevelsOfAnotherType>);
}

TEST(CameraConcept, MessageNamesTheHeader) {
  EXPECT_NE(std::string(DOT_CAMERA_MESSAGE).find("dot/camera/concept.hpp"), std::string::npos);
}

}  // namespace
