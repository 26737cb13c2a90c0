// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// Motion blur, by the differences of neighbouring pixels. Of a sharp image they know little of each other. Blur over n
/// pixels makes them the difference of the sharp image n pixels apart: like their neighbours, and unlike those n away.

namespace check {
namespace {

constexpr int lags = 48;

/// Correlation of the differences along the rows at 0, 1, 2, ... pixels.
std::vector<double> correlations(const cv::Mat& grey) {
  cv::Mat wide, difference, padded, spectrum;
  grey.convertTo(wide, CV_32F);
  difference = wide.colRange(1, wide.cols) - wide.colRange(0, wide.cols - 1);
  // The few strong edges would hide what the many weak ones say.
  const double most = 2 * cv::mean(cv::abs(difference))[0];
  cv::min(cv::max(difference, -most), most, difference);
  const int length = cv::getOptimalDFTSize(difference.cols + lags);
  cv::copyMakeBorder(difference, padded, 0, 0, 0, length - difference.cols, cv::BORDER_CONSTANT);
  cv::dft(padded, spectrum, cv::DFT_ROWS);
  cv::mulSpectrums(spectrum, spectrum, spectrum, cv::DFT_ROWS, true);
  cv::Mat sum, correlation;
  cv::reduce(spectrum, sum, 0, cv::REDUCE_SUM);
  cv::dft(sum, correlation, cv::DFT_INVERSE | cv::DFT_REAL_OUTPUT | cv::DFT_SCALE);
  std::vector<double> values(lags, 0);
  if (const auto all = static_cast<double>(correlation.at<float>(0)); all > 0)
    for (int i = 0; i < lags; ++i)
      values[static_cast<std::size_t>(i)] = static_cast<double>(correlation.at<float>(i)) / all;
  return values;
}

struct Blur {
  double alike = 0;     ///< correlation of neighbours
  double opposite = 0;  ///< of differences `length` pixels apart, negative
  int length = 0;       ///< pixels
};

Blur blur_of(const std::vector<double>& c) {
  const auto lowest = std::min_element(c.begin() + 2, c.begin() + 40);
  return {c[1], *lowest, static_cast<int>(lowest - c.begin())};
}

}  // namespace

Findings check_blur(const Samples& samples) {
  constexpr double alike = 0.62, opposite = -0.09;  // sharp images: less, and that far down at 2 or 3 pixels only
  constexpr int least = 4;                          // pixels
  if (const cv::Mat& grey = samples.frames[0].grey; std::min(grey.cols, grey.rows) < lags)
    return {unknown("motion-blur", "The images are smaller than " + text(lags) + " pixels.")};
  std::vector<double> across(lags, 0), along(lags, 0);
  int count = 0;
  for (std::size_t i = 0; i < samples.frames.size(); i += 3, ++count) {
    const std::vector<double> x = correlations(samples.frames[i].grey), y = correlations(samples.frames[i].grey.t());
    for (std::size_t k = 0; k < x.size(); ++k) across[k] += x[k], along[k] += y[k];
  }
  for (std::size_t k = 0; k < across.size(); ++k) across[k] /= count, along[k] /= count;
  const Blur rows = blur_of(across), columns = blur_of(along);
  const Blur& worse = rows.alike >= columns.alike ? rows : columns;
  const std::string direction = &worse == &rows ? "rows" : "columns";
  if (worse.alike < alike || worse.length < least || worse.opposite > opposite)
    return {fine("motion-blur", 0, "px",
                 "The images are sharp: neighbouring differences correlate by " + number(worse.alike, 2) +
                     " along the " + direction + ".")};
  return {
      faulty("motion-blur", worse.length, "px",
             "The images are blurred over about " + text(worse.length) + " pixels along the " + direction + ".",
             "Expose for a shorter time, with more light or gain. Points are then found less precisely, and small or "
             "slow objects stay undecided.")};
}

}  // namespace check
