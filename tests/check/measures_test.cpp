// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Each fault at a size that is known, in a small made scene; and the scene without it.

#include "check/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "made_samples.hpp"

namespace {

using check::Finding;
using check::Samples;
using check::Verdict;
using check_test::find;
using check_test::made_samples;

void expect_fault(const Finding& finding, double figure, double tolerance) {
  EXPECT_EQ(finding.verdict, Verdict::Fault) << finding.fault << ": " << finding.words;
  EXPECT_NEAR(finding.figure, figure, tolerance) << finding.words;
  EXPECT_FALSE(finding.words.empty());
  EXPECT_FALSE(finding.advice.empty());
}

void expect_fine(const Finding& finding) {
  EXPECT_EQ(finding.verdict, Verdict::Fine) << finding.fault << ": " << finding.words;
  EXPECT_TRUE(finding.advice.empty());
}

TEST(CheckClock, NamesTheUnit) {
  for (const double per_second : {1e3, 1e6, 1e9}) {
    Samples samples = made_samples();
    for (auto& entry : samples.recording.entries) entry.timestamp *= per_second;
    expect_fault(find(check::check_clock(samples), "time-unit"), per_second, 0);
  }
  expect_fine(find(check::check_clock(made_samples()), "time-unit"));
}

TEST(CheckClock, CountsMissingFrames) {
  Samples samples = made_samples();
  auto& entries = samples.recording.entries;
  for (std::size_t i = 5; i < entries.size(); ++i) entries[i].timestamp += 0.2;
  for (std::size_t i = 12; i < entries.size(); ++i) entries[i].timestamp += 0.1;
  expect_fault(find(check::check_clock(samples), "frames-dropped"), 3, 0);
  expect_fine(find(check::check_clock(made_samples()), "frames-dropped"));
}

TEST(CheckClock, CountsFramesOutOfOrder) {
  Samples samples = made_samples();
  std::swap(samples.recording.entries[4].timestamp, samples.recording.entries[5].timestamp);
  expect_fault(find(check::check_clock(samples), "time-order"), 1, 0);
}

TEST(CheckClock, OneFrameHasNoClock) {
  Samples samples = made_samples(1);
  EXPECT_EQ(find(check::check_clock(samples), "time-unit").verdict, Verdict::Unknown);
}

TEST(CheckRepeats, CountsImagesAndDepth) {
  Samples samples = made_samples(20);
  for (const std::size_t i : {4u, 9u}) samples.frames[i].grey = samples.frames[i - 1].grey;
  for (const std::size_t i : {4u, 9u, 13u}) samples.frames[i].depth = samples.frames[i - 1].depth;
  expect_fault(find(check::check_repeats(samples), "images-repeated"), 10, 0.01);
  expect_fault(find(check::check_repeats(samples), "depth-repeated"), 5, 0.01);  // not those that come with the image
  expect_fine(find(check::check_repeats(made_samples()), "images-repeated"));
  expect_fine(find(check::check_repeats(made_samples()), "depth-repeated"));
}

TEST(CheckRegistration, FindsTheLag) {
  for (const int lag : {-2, -1, 1, 2}) {
    Samples samples = made_samples();
    const int count = static_cast<int>(samples.frames.size());
    const Samples clean = made_samples();
    for (int i = 0; i < count; ++i)
      samples.frames[static_cast<std::size_t>(i)].depth =
          clean.frames[static_cast<std::size_t>(std::clamp(i - lag, 0, count - 1))].depth;
    expect_fault(find(check::check_registration(samples), "depth-lag"), lag, 0);
  }
  expect_fine(find(check::check_registration(made_samples()), "depth-lag"));
}

TEST(CheckRegistration, FindsTheOffset) {
  for (const int pixels : {4, 10, -6}) {
    Samples samples = made_samples();
    for (auto& frame : samples.frames) {
      cv::Mat moved;
      const cv::Matx23d by(1, 0, pixels, 0, 1, 0);
      cv::warpAffine(frame.depth, moved, by, frame.depth.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
      frame.depth = moved;
    }
    expect_fault(find(check::check_registration(samples), "depth-offset"), std::abs(pixels), 1.5);
  }
  expect_fine(find(check::check_registration(made_samples()), "depth-offset"));
}

TEST(CheckRegistration, AnotherSizeIsAFaultOfItsOwn) {
  Samples samples = made_samples();
  for (auto& frame : samples.frames) cv::resize(frame.depth, frame.depth, {}, 0.5, 0.5, cv::INTER_NEAREST);
  expect_fault(find(check::check_registration(samples), "depth-size"), 50, 0);
  EXPECT_EQ(find(check::check_registration(samples), "depth-lag").verdict, Verdict::Unknown);
}

/// A slope whose disparities come in `steps` a pixel, stored with `per_metre` units.
Samples with_steps(double per_metre, double stated_focal_length, double stated_per_metre = 256, int steps = 16) {
  Samples samples = made_samples(4);
  const double fx_baseline = 300 * 0.2;
  samples.recording.intrinsics.fx = stated_focal_length;
  samples.recording.intrinsics.baseline = 0.2;
  samples.recording.depth_units_per_metre = stated_per_metre;
  for (auto& frame : samples.frames)
    for (int y = 0; y < frame.depth.rows; ++y)
      for (int x = 0; x < frame.depth.cols; ++x) {
        const double disparity = std::round((3 + (x + 3 * y) % 250 / 16.0) * steps) / steps;
        frame.depth.at<std::uint16_t>(y, x) = cv::saturate_cast<std::uint16_t>(fx_baseline / disparity * per_metre);
      }
  return samples;
}

TEST(CheckDepthScale, NamesTheUnit) {
  for (const double stated : {256.0, 1000.0, 5000.0})
    for (const double per_metre : {256.0, 1000.0, 5000.0}) {
      const Finding unit = find(check::check_depth_scale(with_steps(per_metre, 300, stated)), "depth-unit");
      if (per_metre == stated)
        expect_fine(unit);
      else
        expect_fault(unit, per_metre / stated, 0.02 * per_metre / stated);
    }
}

TEST(CheckDepthScale, CoarserAndFinerStepsAreNoFault) {
  for (const int steps : {1, 2, 4, 8, 32}) {
    const auto findings = check::check_depth_scale(with_steps(1000, 300, 1000, steps));
    EXPECT_NE(find(findings, "depth-unit").verdict, Verdict::Fault) << steps << find(findings, "depth-unit").words;
    EXPECT_NE(find(findings, "focal-baseline").verdict, Verdict::Fault) << steps;
  }
}

/// The scene seen by a second camera, 0.2 m to the right.
Samples made_pair(double depth_factor, int lower) {
  Samples samples = made_samples();
  samples.recording.intrinsics.fx = 300;
  samples.recording.intrinsics.baseline = 0.2;
  for (auto& frame : samples.frames) {
    frame.right = cv::Mat(frame.grey.size(), CV_8U, cv::Scalar(90));
    for (const bool near : {false, true})
      for (int y = 0; y + lower < frame.grey.rows; ++y)
        for (int x = 15; x < frame.grey.cols; ++x)
          if (const int disparity = near ? 15 : 3; (frame.ids.at<std::uint8_t>(y, x) > 0) == near)
            frame.right.at<std::uint8_t>(y + lower, x - disparity) = frame.grey.at<std::uint8_t>(y, x);
    frame.depth.convertTo(frame.depth, CV_16U, depth_factor);
  }
  return samples;
}

/// Ground that ends in the distance, 1.5 m under a camera that goes down a little.
void lay_ground(Samples& samples, double farthest) {
  for (std::size_t i = 0; i < samples.frames.size(); ++i)
    for (int y = 0; y < check_test::height; ++y)
      for (int x = 0; x < check_test::width; ++x) {
        const double z = (450.0 - static_cast<double>(i)) / std::max(1.0, y - 60 + 0.01 * x);
        samples.frames[i].depth.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(256 * std::min(z, farthest));
      }
  samples.recording.depth_units_per_metre = 256;
}

TEST(CheckDepthSaturation, MeasuresItsShare) {
  Samples samples = made_samples();
  lay_ground(samples, 15);  // 30 rows below the horizon, and all above it
  expect_fault(find(check::check_depth_saturation(samples), "depth-saturated"), 100.0 * 90 / check_test::height, 3);
  for (std::size_t i = 0; i < samples.frames.size(); ++i)
    samples.frames[i].depth.setTo(15 * 256 - 5 * static_cast<int>(i), samples.frames[i].depth == 15 * 256);
  expect_fine(find(check::check_depth_saturation(samples), "depth-saturated"));  // a wall that comes nearer
  samples = made_samples();
  lay_ground(samples, 15);
  samples.frames[3].depth(cv::Rect(5, 80, 1, 8)) = 16 * 256;  // depth goes on
  expect_fine(find(check::check_depth_saturation(samples), "depth-saturated"));
}

void flip(Samples& samples) {
  for (auto& frame : samples.frames) cv::flip(frame.depth, frame.depth, 0);
}

void invert(Samples& samples, double product) {
  for (auto& frame : samples.frames)
    for (int y = 0; y < frame.depth.rows; ++y)
      for (int x = 0; x < frame.depth.cols; ++x)
        if (auto& z = frame.depth.at<std::uint16_t>(y, x); z > 0) z = cv::saturate_cast<std::uint16_t>(product / z);
}

// Ground or ceiling, and in any unit.
TEST(CheckDepthInverse, KnowsDisparityFromDepth) {
  for (const bool ceiling : {false, true})
    for (const double product : {60.0 * 256 * 16, 60.0 * 256 * 256}) {
      Samples samples = made_samples();
      lay_ground(samples, 200);
      if (ceiling) flip(samples);
      expect_fine(find(check::check_depth_inverse(samples), "depth-inverse"));
      invert(samples, product);
      expect_fault(find(check::check_depth_inverse(samples), "depth-inverse"), 100, 5);
      samples.recording.depth_source = dot::DepthSource::Lidar;  // depth between whose lines was filled in
      EXPECT_EQ(find(check::check_depth_inverse(samples), "depth-inverse").verdict, Verdict::Hint);
    }
}

TEST(CheckDepthInverse, SaysNothingOfAWallAhead) {
  const Finding finding = find(check::check_depth_inverse(made_samples()), "depth-inverse");
  EXPECT_EQ(finding.fault, "depth-inverse");
  EXPECT_EQ(finding.verdict, Verdict::Unknown);
}

/// Of the made scene, 320x160.
Finding principal_point(double cx, double cy) {
  Samples samples = made_samples(1);
  samples.recording.intrinsics.cx = cx;
  samples.recording.intrinsics.cy = cy;
  return find(check::check_principal_point(samples), "principal-point");
}

TEST(CheckPrincipalPoint, FindsIntrinsicsOfAnotherSize) {
  const auto says = [](const Finding& finding, const char* words) {
    EXPECT_NE(finding.words.find(words), std::string::npos) << finding.words;
  };
  const Finding half = principal_point(79.5, 39.5), twice = principal_point(319.5, 159.5);
  expect_fault(half, 25, 1);
  says(half, "half the size");
  expect_fault(twice, 100, 1);
  says(twice, "twice the size");
  says(principal_point(39.5, 19.5), "a quarter of the size");
}

TEST(CheckPrincipalPoint, FindsOneThatIsMissingOrSwapped) {
  expect_fault(principal_point(0, 79.5), 0, 0);
  expect_fault(principal_point(159.5, 0), 0, 0);
  expect_fault(principal_point(-3, 79.5), -1, 0.1);
  expect_fault(principal_point(0.5, 0.5), 0, 1);  // as a share of the size
  Samples upright = made_samples(1);
  std::swap(upright.recording.intrinsics.width, upright.recording.intrinsics.height);
  expect_fault(find(check::check_principal_point(upright), "principal-point"), 100, 1);
}

TEST(CheckPrincipalPoint, LeavesCropsAndShiftedLensesAlone) {
  expect_fine(principal_point(159.5, 79.5));
  expect_fine(principal_point(0.564 * 320, 0.439 * 160));
  expect_fine(principal_point(0.32 * 320, 0.68 * 160));
  for (const Finding& crop : {principal_point(0.5 * 320, 0.9 * 160), principal_point(0.25 * 320, 0.5 * 160)}) {
    EXPECT_EQ(crop.verdict, Verdict::Hint) << crop.words;
    EXPECT_FALSE(crop.advice.empty());
  }
}

TEST(CheckPair, NamesTheUnit) {
  for (const double factor : {0.4, 2.5})
    expect_fault(find(check::check_pair(made_pair(factor, 0)), "depth-unit"), factor, 0.05 * factor);
  expect_fine(find(check::check_pair(made_pair(1, 0)), "depth-unit"));
  expect_fine(find(check::check_pair(made_pair(1, 0)), "focal-baseline"));
}

TEST(CheckPair, MeasuresRows) {
  expect_fault(find(check::check_pair(made_pair(1, 2)), "pair-rows"), 2, 0.2);
  expect_fine(find(check::check_pair(made_pair(1, 0)), "pair-rows"));
}

void expect_unknown(const check::Findings& findings, const char* fault) {
  const Finding finding = find(findings, fault);
  EXPECT_EQ(finding.fault, fault);  // it is said
  EXPECT_EQ(finding.verdict, Verdict::Unknown) << finding.words;
}

TEST(Check, SaysWhatItCannotTell) {
  Samples one = made_samples(1);
  for (const auto* fault : {"time-unit", "time-order", "frames-dropped"})
    expect_unknown(check::check_clock(one), fault);
  expect_unknown(check::check_registration(one), "depth-lag");
  expect_unknown(check::check_masks(one), "masks-lag");
  expect_unknown(check::check_exposure(one), "brightness-bands");
  for (auto& frame : one.frames) frame.grey = frame.grey(cv::Rect(0, 0, 20, 1)).clone();
  expect_unknown(check::check_blur(one), "motion-blur");
  expect_unknown(check::check_amounts(one), "texture-low");
}

TEST(CheckRepeats, DepthThatWasLeftOutIsNoFault) {
  Samples samples = made_samples();
  for (std::size_t i = 0; i < samples.frames.size(); ++i)
    if (i % 3 > 0) samples.frames[i].depth = cv::Scalar(0);
  expect_fine(find(check::check_repeats(samples), "depth-repeated"));
  expect_fine(find(check::check_amounts(samples), "depth-sparse"));
}

TEST(CheckDepthScale, MeasuresFocalLengthTimesBaseline) {
  for (const double percent : {-5.0, 3.0, 10.0})
    expect_fault(find(check::check_depth_scale(with_steps(256, 300 * (1 + percent / 100))), "focal-baseline"), percent,
                 0.3);
  expect_fine(find(check::check_depth_scale(with_steps(256, 300)), "focal-baseline"));
}

// The steps of a disparity do not tell it from its half.
TEST(CheckDepthScale, SaysWhatItsStepsLeaveOpen) {
  for (const double factor : {0.5, 1.0, 2.0}) {
    const Finding finding = find(check::check_depth_scale(with_steps(256, factor * 300)), "focal-baseline");
    expect_fine(finding);
    EXPECT_NE(finding.words.find("or a half"), std::string::npos) << finding.words;
  }
}

TEST(CheckDepthScale, AUnitThatNothingTellsIsNotFine) {
  expect_unknown(check::check_depth_scale(made_samples()), "depth-unit");
}

TEST(CheckAmounts, MeasuresDepthAndContrast) {
  Samples samples = made_samples();
  for (auto& frame : samples.frames) {
    frame.depth.rowRange(8, frame.depth.rows) = cv::Scalar(0);  // 8 of 160 rows are left
    frame.grey.convertTo(frame.grey, CV_8U, 0.05, 100);
  }
  expect_fault(find(check::check_amounts(samples), "depth-sparse"), 5, 0.01);
  EXPECT_EQ(find(check::check_amounts(samples), "texture-low").verdict, Verdict::Fault);
  samples.recording.depth_source = dot::DepthSource::Lidar;
  expect_fine(find(check::check_amounts(samples), "depth-sparse"));
  expect_fine(find(check::check_amounts(made_samples()), "depth-sparse"));
  Samples rich = made_samples();
  for (auto& frame : rich.frames) frame.grey.convertTo(frame.grey, CV_8U, 2, -100);
  expect_fine(find(check::check_amounts(rich), "texture-low"));
}

TEST(CheckMasks, NoMasksAreNoFault) {
  Samples samples = made_samples();
  for (auto& frame : samples.frames) frame.ids.release();
  EXPECT_EQ(find(check::check_masks(samples), "masks-values").verdict, Verdict::Unknown);
}

TEST(CheckMasks, FindsSizeValuesAndLag) {
  const Samples clean = made_samples();
  for (const char* const name : {"masks-size", "masks-values", "masks-lag"})
    expect_fine(find(check::check_masks(clean), name));

  Samples small = made_samples();
  for (auto& frame : small.frames) cv::resize(frame.ids, frame.ids, {}, 0.5, 0.5, cv::INTER_NEAREST);
  expect_fault(find(check::check_masks(small), "masks-size"), 50, 0);

  Samples classes = made_samples();
  for (auto& frame : classes.frames) cv::min(frame.ids, 1, frame.ids);
  expect_fault(find(check::check_masks(classes), "masks-values"), 3, 0.5);

  Samples bordered = made_samples();  // as data sets with a border that belongs to no instance
  for (auto& frame : bordered.frames) {
    cv::Mat wide, rim;
    cv::dilate(frame.ids, wide, cv::Mat::ones(5, 5, CV_8U));
    rim = (wide > 0) & (frame.ids == 0);
    frame.ids.setTo(255, rim);
  }
  expect_fault(find(check::check_masks(bordered), "masks-values"), 255, 0);

  Samples probabilities = made_samples();
  for (auto& frame : probabilities.frames) {
    frame.ids = (frame.ids > 0);
    cv::GaussianBlur(frame.ids, frame.ids, {}, 4);
  }
  EXPECT_EQ(find(check::check_masks(probabilities), "masks-values").verdict, Verdict::Fault);

  Samples late = made_samples();
  for (std::size_t i = 1; i < late.frames.size(); ++i) late.frames[i].ids = clean.frames[i - 1].ids;
  expect_fault(find(check::check_masks(late), "masks-lag"), 1, 0);
}

TEST(CheckMasks, MeasuresWhatTheyCover) {
  const Finding clean = find(check::check_masks_cover(made_samples()), "masks-cover");
  expect_fine(clean);
  EXPECT_NEAR(clean.figure, 100.0 * 3 * 50 * 40 / (320 * 160), 2);  // three boxes

  Samples samples = made_samples();
  samples.frames[5].ids.setTo(1);
  EXPECT_EQ(find(check::check_masks_cover(samples), "masks-cover").verdict, Verdict::Hint);
  samples.frames[9].ids.setTo(1);
  EXPECT_EQ(find(check::check_masks_cover(samples), "masks-cover").verdict, Verdict::Fault);

  samples = made_samples();
  for (auto& frame : samples.frames) frame.ids.setTo(9, frame.ids == 0);  // the background
  expect_fault(find(check::check_masks_cover(samples), "masks-cover"), 100, 0);

  samples = made_samples();
  for (auto& frame : samples.frames) frame.ids.colRange(0, 210).setTo(9);
  EXPECT_EQ(find(check::check_masks_cover(samples), "masks-cover").verdict, Verdict::Hint);  // a lorry ahead
  for (auto& frame : samples.frames) frame.ids.colRange(0, 290).setTo(9);
  expect_fault(find(check::check_masks_cover(samples), "masks-cover"), 91, 2);
  for (auto& frame : samples.frames) frame.ids.release();
  expect_unknown(check::check_masks_cover(samples), "masks-cover");
}

TEST(CheckMasks, PiecesOfTheWholeImageAreNotCalledFine) {
  Samples samples = made_samples();
  for (auto& frame : samples.frames)
    for (int y = 0; y < check_test::height; ++y)
      for (int x = 0; x < check_test::width; ++x)
        if (auto& id = frame.ids.at<std::uint8_t>(y, x); id == 0)
          id = static_cast<std::uint8_t>(10 + x / 16 + 20 * (y / 16));
  expect_unknown(check::check_masks(samples), "masks-values");
  expect_fault(find(check::check_masks_cover(samples), "masks-cover"), 100, 0);
}

TEST(CheckMasks, CountsThingsThatLoseTheirMask) {
  Samples samples = made_samples();
  expect_fine(find(check::check_missing_masks(samples), "masks-missing"));
  // The second box in every third frame.
  for (std::size_t i = 2; i < samples.frames.size(); i += 3) samples.frames[i].ids.setTo(0, samples.frames[i].ids == 2);
  const double figure = 100.0 / 8;  // of three pairs of frames the first ones show eight things
  expect_fault(find(check::check_missing_masks(samples), "masks-missing"), figure, 4);
  // A segmentation that was not made is none that misses things.
  for (check::Sample& frame : samples.frames)
    if (frame.index % 3 == 2) frame.ids = cv::Mat();
  expect_fine(find(check::check_missing_masks(samples), "masks-missing"));
  for (check::Sample& frame : samples.frames)
    if (frame.index % 3 == 1) frame.ids = cv::Mat();
  EXPECT_EQ(find(check::check_missing_masks(samples), "masks-missing").verdict, Verdict::Unknown);
}

// Those that only the frame after shows.
TEST(CheckMasks, CountsThingsThatHaveNoMaskYet) {
  Samples samples = made_samples();
  samples.frames[0].ids.setTo(0);
  EXPECT_GT(find(check::check_missing_masks(samples), "masks-missing").figure, 0);
}

TEST(CheckExposure, MeasuresJumpsAndBands) {
  Samples jumps = made_samples();
  for (std::size_t i = 0; i < jumps.frames.size(); ++i)
    jumps.frames[i].grey.convertTo(jumps.frames[i].grey, CV_8U, i % 6 < 3 ? 0.7 : 0.7 * 1.3);
  expect_fault(find(check::check_exposure(jumps), "exposure-jumps"), 30, 3);

  Samples bands = made_samples();
  for (std::size_t i = 0; i < bands.frames.size(); ++i)
    for (int y = 0; y < check_test::height; ++y) {
      const double phase = 2 * 3.14159265358979 * (3.0 * y / check_test::height + 0.3 * static_cast<double>(i));
      bands.frames[i].grey.row(y).convertTo(bands.frames[i].grey.row(y), CV_8U, 0.8 * (1 + 0.1 * std::sin(phase)));
    }
  expect_fault(find(check::check_exposure(bands), "brightness-bands"), 10, 1.5);

  expect_fine(find(check::check_exposure(made_samples()), "exposure-jumps"));
  expect_fine(find(check::check_exposure(made_samples()), "brightness-bands"));
}

TEST(CheckBlur, MeasuresItsLength) {
  // In the made scene the edges of the boxes are much stronger than their texture.
  cv::Mat wall(check_test::height, check_test::width, CV_8U);
  cv::RNG(7).fill(wall, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(wall, wall, {}, 1);
  for (const int length : {7, 13}) {
    Samples samples = made_samples();
    for (auto& frame : samples.frames) cv::blur(wall, frame.grey, {length, 1});
    expect_fault(find(check::check_blur(samples), "motion-blur"), length, 1);
  }
  expect_fine(find(check::check_blur(made_samples()), "motion-blur"));
}

}  // namespace
