// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "depth_units.hpp"
#include "measures.hpp"
#include "words.hpp"

/// @file
/// The scale of the depth, from the steps in which a stereo matcher or a structured-light camera measures disparity:
/// 1/16 or 1/8 of a pixel, seldom more. Inverse depth then takes values at equal distances, and their distance times
/// the focal length, the baseline and the depth's unit is that step. Nothing in the pictures is needed for it.

namespace check {
namespace {

constexpr std::size_t bins = std::size_t{1} << 17;
constexpr double least_samples = 3000;
constexpr std::array<double, 2> steps_per_pixel{16, 8};
constexpr std::array<double, 4> other_steps{1, 2, 4, 32};  ///< only where they fit exactly: others may be another unit

/// Where the spectrum of the disparities has a line.
struct Comb {
  double per_pixel = 0;  ///< disparities a pixel, by the stated focal length, baseline and unit
  double coherence = 0;  ///< 1: all of them lie on it
  double by_chance = 0;  ///< the highest coherence that as many different disparities without steps may have
};

/// The strongest line near `per_pixel`.
/// @param usable disparities that are stored finely enough to show it.
std::optional<Comb> line_near(const Samples& samples, double per_pixel, double fx_baseline) {
  constexpr double width = 1.22;   // the lines that are looked for, over and under
  constexpr double finely = 0.25;  // of a step: the rounding of the file
  std::vector<float> disparities;
  double largest = 0;
  for (const Sample& frame : samples.frames) {
    for (int y = 0; y < frame.depth.rows; y += 2) {
      const auto* raw = frame.depth.ptr<std::uint16_t>(y);
      for (int x = 0; x < frame.depth.cols; ++x) {
        if (raw[x] == 0) continue;
        const double disparity = fx_baseline * samples.recording.depth_units_per_metre / raw[x];
        if (disparity / raw[x] * per_pixel * width > finely) continue;
        disparities.push_back(static_cast<float>(disparity));
        largest = std::max(largest, disparity);
      }
    }
  }
  if (static_cast<double>(disparities.size()) < least_samples) return std::nullopt;
  cv::Mat histogram = cv::Mat::zeros(1, static_cast<int>(bins), CV_32F);
  const double span = 1.01 * largest;
  for (const float d : disparities)
    histogram.at<float>(static_cast<int>(static_cast<double>(d) / span * static_cast<double>(bins))) += 1;
  cv::Mat spectrum;
  cv::dft(histogram, spectrum, cv::DFT_COMPLEX_OUTPUT);
  int lines = 0;
  Comb best;
  const auto last = std::min<double>(per_pixel * width * span, static_cast<double>(bins) / 2 - 1);
  for (int k = static_cast<int>(per_pixel / width * span); k <= static_cast<int>(last); ++k) {
    const auto c = spectrum.at<cv::Vec2f>(k);
    const double coherence = std::hypot(c[0], c[1]) / static_cast<double>(disparities.size());
    if (coherence > best.coherence) best = {k / span, coherence, 0};
    ++lines;
  }
  // The mean of n vectors of any direction is 1 / sqrt(n) long, the longest of k such means sqrt(ln k) times as much.
  const int different = std::max(1, cv::countNonZero(histogram));
  best.by_chance = 2 * std::sqrt(std::log(std::max(2, lines)) / different);
  return best;
}

Finding unit_fault(double ratio, double stated) {
  const DepthUnit& unit = nearest_unit(ratio, stated);
  return faulty("depth-unit", ratio, "times too far",
                "All depths are " + number(ratio, 3) + " times too far: they look like " + unit.name + ".",
                "Divide by the unit that the depth has: " + std::string(unit.name) +
                    ". Speeds and v0 are in metres, so that a wrong unit makes wrong decisions.");
}

/// @param stated values of the depth images that make a metre. @return nothing if the steps are of no known kind.
std::optional<Findings> judge(const Comb& comb, double stated) {
  constexpr double most = 0.012;          // of the product: up to 0.005 on recordings without the fault
  constexpr double of_calibration = 0.2;  // more is no error of a calibration
  constexpr double of_unit = 0.06;
  double error = 10;  // ln of the true product over the stated one
  double a_pixel = 0;
  const auto take = [&](double steps) {
    if (const double e = std::log(comb.per_pixel / steps); std::abs(e) < std::abs(error)) error = e, a_pixel = steps;
  };
  for (const double steps : steps_per_pixel) take(steps);
  if (std::abs(error) > of_calibration)
    for (const double steps : other_steps)
      if (std::abs(std::log(comb.per_pixel / steps)) <= most) take(steps);
  if (std::abs(error) > of_calibration) {
    for (const double steps : steps_per_pixel) {
      const double ratio = comb.per_pixel / steps;
      if (std::abs(std::log(ratio / too_far(nearest_unit(ratio, stated), stated))) < of_unit)
        return Findings{unit_fault(ratio, stated), unknown("focal-baseline", "The unit of the depth is wrong.")};
    }
    return std::nullopt;
  }
  const Finding unit = fine("depth-unit", 1, "times too far", "The depth's steps are those of its unit.");
  const double percent = 100 * (std::exp(-error) - 1);
  const std::string steps = a_pixel > 1 ? "1/" + number(a_pixel, 0) + " pixel" : "a pixel";
  if (std::abs(error) <= most)
    return Findings{unit, fine("focal-baseline", percent, "%",
                               "Focal length times baseline fits steps of " + steps + " in the depth within " +
                                   number(std::abs(percent), 1) +
                                   " %. Two or four times as much, or a half, would fit other steps as well.")};
  return Findings{unit,
                  faulty("focal-baseline", percent, "%",
                         "Focal length times baseline is " + number(std::abs(percent), 1) + " % " +
                             (percent > 0 ? "more" : "less") + " than that with which the depth was computed.",
                         "Use the calibration of the rectified images from which the depth was made; look whether the "
                         "images were scaled or cropped since.")};
}

/// Without such steps only what no camera measures can be told.
Findings judge_plausibility(const Samples& samples) {
  constexpr double farthest = 150, nearest = 0.1;  // metres, of the median
  std::vector<float> depths;
  for (const Sample& frame : samples.frames) {
    const cv::Mat z = metres(samples, frame);
    for (int y = 0; y < z.rows; y += 8)
      for (int x = 0; x < z.cols; x += 8)
        if (z.at<float>(y, x) > 0) depths.push_back(z.at<float>(y, x));
  }
  const Finding no_product = unknown("focal-baseline", "The depth shows no steps, and there is no pair of images.");
  if (depths.empty()) return {unknown("depth-unit", "There is no depth."), no_product};
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  const auto median = static_cast<double>(*middle);
  const std::string said = "Half of the depths are under " + number(median, 2) + " m.";
  if (median > farthest || median < nearest)
    return {faulty("depth-unit", median, "m", said + " That is no distance of a scene.",
                   "State the unit of the depth: how many of its values make a metre."),
            no_product};
  return {unknown("depth-unit", said + " The depth shows no steps that would tell its unit."), no_product};
}

}  // namespace

Findings check_depth_scale(const Samples& samples) {
  const dot::Intrinsics& camera = samples.recording.intrinsics;
  const double fx_baseline = camera.fx * camera.baseline;
  if (samples.depth_from_pair)
    return {fine("depth-unit", 1, "times too far", "The depth is computed from the pair of images, in metres."),
            unknown("focal-baseline", "The depth is computed with them, and fits whatever they are.")};
  if (!(fx_baseline > 0)) return judge_plausibility(samples);
  const double stated = samples.recording.depth_units_per_metre;
  std::vector<double> places(other_steps.begin(), other_steps.end());
  for (const double steps : steps_per_pixel) {
    places.push_back(steps);
    for (const DepthUnit& unit : depth_units) places.push_back(steps * too_far(unit, stated));
  }
  std::sort(places.begin(), places.end());
  constexpr double clear = 0.3, of_best = 0.7;
  std::vector<Comb> combs;
  double best = 0;
  for (const double place : places)
    if (const auto comb = line_near(samples, place, fx_baseline);
        comb && comb->coherence > std::max(clear, comb->by_chance)) {
      combs.push_back(*comb);
      best = std::max(best, comb->coherence);
    }
  // From the widest steps on: multiples of a line are lines, too. The rounding of the file makes lines, but weaker
  // ones.
  for (const Comb& comb : combs)
    if (comb.coherence > of_best * best)
      if (auto findings = judge(comb, stated)) return *std::move(findings);
  return judge_plausibility(samples);
}

}  // namespace check
