// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <complex>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// Brightness from frame to frame: of the whole image, and of bands across it.

namespace check {
namespace {

constexpr double pi = 3.14159265358979323846;

/// ln of how much brighter parts of the image have become, CV_32FC1.
cv::Mat change(const cv::Mat& before, const cv::Mat& now, cv::Size parts) {
  constexpr double dark = 4;  // grey values: of black parts no ratio can be told
  cv::Mat a, b, ratio;
  cv::resize(before, a, parts, 0, 0, cv::INTER_AREA);
  cv::resize(now, b, parts, 0, 0, cv::INTER_AREA);
  a.convertTo(a, CV_32F, 1, dark);
  b.convertTo(b, CV_32F, 1, dark);
  cv::log(b / a, ratio);
  return ratio;
}

double median_of(const cv::Mat& row) {
  std::vector<double> values;
  for (int y = 0; y < row.rows; ++y)
    for (int x = 0; x < row.cols; ++x) values.push_back(static_cast<double>(row.at<float>(y, x)));
  return median(std::move(values));
}

Finding jump_finding(const std::vector<double>& jumps) {
  constexpr double most = 0.12;  // ln; sun and shadow make up to 0.09
  std::vector<double> large;
  for (const double jump : jumps)
    if (std::abs(jump) > most) large.push_back(std::abs(jump));
  if (large.empty()) {
    double largest = 0;
    for (const double jump : jumps) largest = std::max(largest, std::abs(jump));
    const double percent = 100 * (std::exp(largest) - 1);
    return fine("exposure-jumps", percent, "%",
                "From frame to frame the brightness changes by up to " + number(percent, 1) + " %.");
  }
  const double percent = 100 * (std::exp(median(large)) - 1);
  return faulty(
      "exposure-jumps", percent, "%",
      "The brightness jumps " + count_text(static_cast<int>(large.size()), "time") + ", by " + number(percent, 0) +
          " % typically.",
      "Fix exposure and gain, or let them change slowly. The tracker follows a change of the whole image, but "
      "not what is lost in white and black.");
}

/// Brightness bands: a wave down the image that moves by the same share of its length from frame to frame.
Finding band_finding(const std::vector<std::vector<std::complex<double>>>& waves) {
  constexpr double least = 0.02, outstanding = 4;
  if (waves.size() < 3) return unknown("brightness-bands", "There are too few frames in a row.");
  const std::size_t count = waves[0].size();
  std::vector<double> sizes(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> of_wave;
    of_wave.reserve(waves.size());
    for (const auto& wave : waves) of_wave.push_back(std::abs(wave[k]));
    sizes[k] = median(std::move(of_wave));
  }
  const auto strongest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const double usual = median(sizes);
  // The difference of two waves that are turned against each other by an angle is 2 sin(angle / 2) times as high.
  std::complex<double> turn = 0;
  double all = 0;
  for (std::size_t i = 1; i < waves.size(); ++i) {
    const std::complex<double> step = waves[i][strongest] * std::conj(waves[i - 1][strongest]);
    turn += step, all += std::abs(step);
  }
  constexpr double alike = 0.5;  // of the turns; those of noise agree to 1 / sqrt(frames)
  const double difference = std::max(0.2, 2 * std::abs(std::sin(0.5 * std::arg(turn))));
  const double percent = 100 * sizes[strongest] / difference;
  const std::string said = "Bands across the image, " + count_text(static_cast<int>(strongest) + 1, "wave") +
                           " over its height, change its brightness by " + number(percent, 1) + " %";
  if (sizes[strongest] < least || sizes[strongest] < outstanding * usual || std::abs(turn) < alike * all)
    return fine("brightness-bands", percent, "%", said + ": no more than things that pass.");
  return faulty("brightness-bands", percent, "%", said + ".",
                "Lamps flicker with the mains. Expose for a multiple of 1/100 s (1/120 s at 60 Hz), or use a global "
                "shutter or other lamps.");
}

}  // namespace

Findings check_exposure(const Samples& samples) {
  constexpr int columns = 32, most_waves = 15;
  std::vector<double> jumps;
  std::vector<std::vector<std::complex<double>>> waves;
  for (std::size_t i = 1; i < samples.frames.size(); ++i) {
    const Sample &before = samples.frames[i - 1], &now = samples.frames[i];
    if (!now.follows) continue;
    jumps.push_back(median_of(change(before.grey, now.grey, {24, 16})));
    const cv::Mat rows = change(before.grey, now.grey, {columns, now.grey.rows});
    std::vector<double> profile;
    double mean = 0;
    for (int y = 0; y < rows.rows; ++y) profile.push_back(median_of(rows.row(y))), mean += profile.back() / rows.rows;
    std::vector<std::complex<double>> wave(most_waves);
    for (int k = 0; k < most_waves; ++k)
      for (int y = 0; y < rows.rows; ++y) {
        const double share = (y + 0.5) / rows.rows;
        const double window = 0.5 - 0.5 * std::cos(2 * pi * share);
        wave[static_cast<std::size_t>(k)] += 4.0 / rows.rows * window * (profile[static_cast<std::size_t>(y)] - mean) *
                                             std::polar(1.0, -2 * pi * (k + 1) * share);
      }
    waves.push_back(std::move(wave));
  }
  if (jumps.empty()) {
    const char* const why = "There are no two frames in a row.";
    return {unknown("exposure-jumps", why), unknown("brightness-bands", why)};
  }
  return {jump_finding(jumps), band_finding(waves)};
}

}  // namespace check
