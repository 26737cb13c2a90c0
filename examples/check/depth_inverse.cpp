// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// Whether the depth images hold disparities or inverse depths. On a plane the inverse depth is a linear function of
/// the pixel, whichever way the camera looks: X = z x, n . X = d, so that 1 / z = n . x / d. If the values themselves
/// are linear where the scene is flat, they are no depths.

namespace check {
namespace {

constexpr int points = 9;
using Profile = std::array<double, points>;

/// Rms deviation from a line, of the mean.
double bend(const Profile& values) {
  constexpr double middle = (points - 1) / 2.0;
  double mean = 0, slope = 0, spread = 0, squares = 0;
  for (const double v : values) mean += v / points;
  for (int i = 0; i < points; ++i) {
    const double t = i - middle;
    slope += t * (values[static_cast<std::size_t>(i)] - mean), spread += t * t;
  }
  for (int i = 0; i < points; ++i) {
    const double e = values[static_cast<std::size_t>(i)] - mean - slope / spread * (i - middle);
    squares += e * e / points;
  }
  return std::sqrt(squares) / mean;
}

/// Stretches of rows and columns whose depth, or whose value itself, bends as on a plane.
struct Count {
  int depth = 0, inverse = 0;

  void add(const Profile& values) {
    constexpr double range = 1.5;     // of the depth, at least: else both are nearly linear
    constexpr double clearly = 0.35;  // of the other's bend
    constexpr double flat = 0.03;     // the bend that noise may give a plane
    const bool falls = values.front() > values.back();
    const double ratio = falls ? values.front() / values.back() : values.back() / values.front();
    if (ratio < range) return;
    Profile inverses;
    for (std::size_t i = 0; i < points; ++i) {
      // A step between things is no plane.
      if (i > 0 && values[i] != values[i - 1] && (values[i] < values[i - 1]) != falls) return;
      inverses[i] = 1 / values[i];
    }
    const double of_values = bend(values), of_inverses = bend(inverses);
    if (std::min(of_values, of_inverses) > std::min(flat, clearly * std::max(of_values, of_inverses))) return;
    ++(of_values < of_inverses ? inverse : depth);
  }

  void add(const cv::Mat& metres) {
    constexpr int parts = 4, every = 4;  // of the height; pixels
    const int step = std::max(2, metres.rows / parts / (points - 1)), length = step * (points - 1);
    for (int x = 0; x < metres.cols; x += every)
      for (int y = 0; y + length < metres.rows; y += length / 2) take(metres, {x, y}, {0, step});
    for (int y = 0; y < metres.rows; y += every)
      for (int x = 0; x + length < metres.cols; x += length / 2) take(metres, {x, y}, {step, 0});
  }

 private:
  void take(const cv::Mat& metres, cv::Point at, const cv::Point& step) {
    Profile values;
    for (double& value : values) {
      value = static_cast<double>(metres.at<float>(at));
      if (!(value > 0)) return;
      at += step;
    }
    add(values);
  }
};

}  // namespace

Findings check_depth_inverse(const Samples& samples) {
  constexpr std::size_t frames = 24;
  constexpr int least = 200;  // stretches
  // Per cent; up to 1 on the sequences tried, over 99 on their disparities. Up to 85 were seen where depth was filled
  // in linearly between nine rows.
  constexpr double few = 20, most = 95;
  const char* const name = "depth-inverse";
  Count count;
  const std::size_t every = std::max<std::size_t>(1, samples.frames.size() / frames);
  for (std::size_t i = 0; i < samples.frames.size(); i += every) count.add(metres(samples, samples.frames[i]));
  const int planes = count.depth + count.inverse;
  if (planes < least) return {unknown(name, "Too little of the scene is flat and seen aslant.")};
  const double percent = 100.0 * count.inverse / planes;
  const std::string said = "Where the scene is flat and seen aslant, " + number(percent, 0) +
                           " % of the depth changes along the image as disparity does.";
  if (percent < few) return {fine(name, percent, "%", said)};
  if (percent < most) return {unknown(name, said + " That is neither depth nor disparity; was it interpolated?")};
  const std::string looks = said + " It looks like disparity or inverse depth.";
  if (samples.recording.depth_source == dot::DepthSource::Lidar)
    return {hint(name, percent, "%", looks,
                 "A lidar gives depth. If it was filled in between its lines, fill in its inverse: on a plane that is "
                 "linear.")};
  return {faulty(name, percent, "%", looks,
                 "Give distances along the optical axis: focal length times baseline over the disparity. A network's "
                 "relative inverse depth has no unit, and cannot be used.")};
}

}  // namespace check
