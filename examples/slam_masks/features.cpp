// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "features.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace slam {

namespace {

constexpr int candidates_per_feature = 4;
constexpr float level_scale = 1.2F;
constexpr int levels = 8;
constexpr int border = 31;  // of the descriptor's patch
constexpr int fast_threshold = 7;
constexpr int cell_pixels = 48;

bool stronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  // Equal responses are common; a sequence must not depend on how a library sorts them.
  if (a.response != b.response) return a.response > b.response;
  if (a.pt.y != b.pt.y) return a.pt.y < b.pt.y;
  if (a.pt.x != b.pt.x) return a.pt.x < b.pt.x;
  return a.octave < b.octave;
}

}  // namespace

std::vector<std::size_t> Features::near(const cv::Point2d& place, double radius) const {
  std::vector<std::size_t> found;
  if (cells.empty()) return found;
  const int cell_rows = static_cast<int>(cells.size()) / cell_columns;
  const auto cell = [](double x, int count) {
    return static_cast<int>(std::clamp(std::floor(x / cell_pixels), 0.0, count - 1.0));
  };
  for (int row = cell(place.y - radius, cell_rows); row <= cell(place.y + radius, cell_rows); ++row) {
    for (int column = cell(place.x - radius, cell_columns); column <= cell(place.x + radius, cell_columns); ++column) {
      for (const std::size_t i : cells[static_cast<std::size_t>(row * cell_columns + column)])
        if (cv::norm(cv::Point2d(pixels[i]) - place) <= radius) found.push_back(i);
    }
  }
  return found;
}

FeatureExtractor::FeatureExtractor(int budget)
    : budget_(budget),
      orb_(cv::ORB::create(candidates_per_feature * budget, level_scale, levels, border, 0, 2, cv::ORB::HARRIS_SCORE,
                           border, fast_threshold)) {}

void FeatureExtractor::set_frame(const cv::Mat& image, const cv::Mat& depth) {
  if (image.channels() == 1)
    grey_ = image;
  else
    cv::cvtColor(image, grey_, cv::COLOR_BGR2GRAY);
  depth_ = depth;
  orb_->detect(grey_, corners_);
  std::sort(corners_.begin(), corners_.end(), stronger);
}

Features FeatureExtractor::outside(const cv::Mat& exclude) {
  const int columns = (grey_.cols + cell_pixels - 1) / cell_pixels;
  const int rows = (grey_.rows + cell_pixels - 1) / cell_pixels;
  std::vector<std::vector<cv::KeyPoint>> cells(static_cast<std::size_t>(columns * rows));
  for (const cv::KeyPoint& corner : corners_) {
    const cv::Point pixel(corner.pt);
    if (exclude.at<std::uint8_t>(pixel) == 0)
      cells[static_cast<std::size_t>(pixel.y / cell_pixels * columns + pixel.x / cell_pixels)].push_back(corner);
  }
  std::vector<cv::KeyPoint> chosen;
  for (std::size_t rank = 0; static_cast<int>(chosen.size()) < budget_; ++rank) {
    const std::size_t before = chosen.size();
    for (const std::vector<cv::KeyPoint>& cell : cells)
      if (rank < cell.size() && static_cast<int>(chosen.size()) < budget_) chosen.push_back(cell[rank]);
    if (chosen.size() == before) break;
  }

  Features features;
  orb_->compute(grey_, chosen, features.descriptors);
  features.cell_columns = columns;
  features.cells.resize(cells.size());
  for (const cv::KeyPoint& corner : chosen) {
    const cv::Point pixel(corner.pt);
    features.cells[static_cast<std::size_t>(pixel.y / cell_pixels * columns + pixel.x / cell_pixels)].push_back(
        features.size());
    const float z = depth_.at<float>(pixel);
    features.pixels.push_back(corner.pt);
    features.sigmas.push_back(std::pow(level_scale, static_cast<float>(corner.octave)));
    features.depths.push_back(std::isfinite(z) && z > 0 ? z : 0);
  }
  return features;
}

}  // namespace slam
