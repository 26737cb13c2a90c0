// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/sharper_image.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "dot/camera/pinhole.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::AlignProblem;
using dot::CameraStep;
using dot::DirectAligner;
using dot::Matrix6;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

constexpr double kScale = 4;  ///< CameraSettings::covariance_scale

using Lens = std::function<void(cv::Mat)>;
void sharp(cv::Mat) {}
Lens gaussian(double sigma) {
  return [=](cv::Mat image) { cv::GaussianBlur(image, image, {}, sigma); };
}
/// Of a camera that turns during the exposure.
Lens smeared(int pixels) {
  return [=](cv::Mat image) { cv::blur(image, image, {pixels, 1}); };
}

/// The motion between two frames of a camera, aligned and measured, whose images came through these lenses.
struct Step {
  CameraStep camera;
  PointSet points;
  Pyramid image;
  const Pinhole pinhole{small_camera()};

  Step(const Lens& first, const Lens& second, double noise, const Vector3<double>& velocity) {
    Film<> film;
    film.camera_path = straight(Vector3<double>::Zero(), velocity);
    film.spoil = [&](int frame, Rendering& seen) {
      const cv::Mat image(seen.grey.height(), seen.grey.width(), CV_8U, seen.grey.row(0));
      (frame == 0 ? first : second)(image);
      cv::Mat error(image.size(), CV_16S);
      cv::RNG(static_cast<unsigned>(frame + 1)).fill(error, cv::RNG::NORMAL, 0, noise);
      cv::add(image, error, image, cv::noArray(), CV_8U);
    };
    Pyramid before;
    film.advance();
    before.build(std::as_const(film.seen().grey).view(), 3);
    points = exact_points(film.seen(), pinhole, before, 5, [](int, int) { return true; });
    film.advance();
    image.build(std::as_const(film.seen().grey).view(), 3);
    DirectAligner<> aligner;
    const AlignProblem<Pinhole> problem{points, image, pinhole};
    camera.alignment = aligner.align(problem, {film.T_c()}, 1);
    aligner.reject_outliers_and_refit(problem, camera.alignment);
    dot::CameraMotionEstimator estimator;
    estimator.settings.covariance_scale = kScale;
    estimator.set_motion(problem, SE3d{}, aligner, camera);
  }

  Matrix6<double> of_residuals() const { return kScale * camera.alignment.covariance.topLeftCorner<6, 6>(); }
  /// The factor by the first points alone.
  double factor_of_few() const {
    PointSet few;
    few.take_if(points, [](std::size_t i) { return i < 60; });
    return dot::SharperImage::variance_factor(few, image.levels[0], pinhole, camera.alignment, {});
  }
  /// Variance over what the residuals say.
  double factor() const { return camera.covariance(0, 0) / of_residuals()(0, 0); }
};

const Vector3<double> kAhead(0.1, 0, 0.4);

TEST(SharperImage, SaysLessOfTheMotionThanItsGradients) {
  for (const Lens& before : {gaussian(3), gaussian(4), smeared(15)}) {
    EXPECT_GT(Step(before, sharp, 2, kAhead).factor(), 2);
  }
}

TEST(SharperImage, IsNoneOfTheSameSharpness) {
  for (const double noise : {1.0, 4.0, 12.0})
    for (const Lens& lens : {Lens(sharp), gaussian(2), smeared(15)})
      for (const Vector3<double>& velocity : {kAhead, Vector3<double>(-kAhead), Vector3<double>(0, 0, 20)}) {
        const Step step(lens, lens, noise, velocity);
        EXPECT_DOUBLE_EQ(step.factor(), 1) << noise << ", " << velocity.transpose();
      }
}

TEST(SharperImage, IsNoneThatHasLostItsDetails) {
  for (const Lens& lens : {gaussian(4), smeared(15)}) EXPECT_DOUBLE_EQ(Step(sharp, lens, 2, kAhead).factor(), 1);
}

// An object has few points: its ratio may be chance.
TEST(SharperImage, IsLessSureByFewPoints) {
  const Step step(gaussian(4), sharp, 2, kAhead);
  EXPECT_GT(step.factor_of_few(), 1);
  EXPECT_LT(step.factor_of_few(), 0.8 * step.factor());
  EXPECT_DOUBLE_EQ(Step(sharp, sharp, 2, kAhead).factor_of_few(), 1);
}

TEST(SharperImage, NeedsPoints) {
  const Pinhole camera(small_camera());
  const dot::Image<std::uint8_t> image(camera.width(), camera.height());
  EXPECT_EQ(dot::SharperImage::variance_factor(PointSet{}, image, camera, dot::Alignment{}, dot::AlignSettings{}), 1);
}

}  // namespace
