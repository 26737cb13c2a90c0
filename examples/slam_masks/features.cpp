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

Grid::Grid(cv::Size image)
    : columns((image.width + cell_pixels - 1) / cell_pixels), rows((image.height + cell_pixels - 1) / cell_pixels) {}

cv::Point Grid::cell(const cv::Point2d& place) const {
  const auto along = [](double x, int count) {
    return static_cast<int>(std::clamp(std::floor(x / cell_pixels), 0.0, count - 1.0));
  };
  return {along(place.x, columns), along(place.y, rows)};
}

std::vector<std::size_t> Features::near(const cv::Point2d& place, double radius) const {
  std::vector<std::size_t> found;
  const cv::Point first = grid.cell({place.x - radius, place.y - radius});
  const cv::Point last = grid.cell({place.x + radius, place.y + radius});
  for (int row = first.y; row <= last.y; ++row) {
    for (int column = first.x; column <= last.x; ++column) {
      for (const std::size_t i : cells[grid.index(column, row)])
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
    cv::cvtColor(image, grey_, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  depth_ = depth;
  orb_->detect(grey_, corners_);
  std::sort(corners_.begin(), corners_.end(), stronger);
}

Features FeatureExtractor::outside(const cv::Mat& exclude) {
  Features features;
  features.grid = Grid(grey_.size());
  const auto cell_of = [&](const cv::KeyPoint& corner) {
    const cv::Point cell = features.grid.cell(corner.pt);
    return features.grid.index(cell.x, cell.y);
  };
  std::vector<std::vector<cv::KeyPoint>> cells(features.grid.size());
  for (const cv::KeyPoint& corner : corners_)
    if (exclude.at<std::uint8_t>(cv::Point(corner.pt)) == 0) cells[cell_of(corner)].push_back(corner);

  std::vector<cv::KeyPoint> chosen;
  for (std::size_t rank = 0, before = 1; chosen.size() != before; ++rank) {
    before = chosen.size();
    for (const std::vector<cv::KeyPoint>& cell : cells)
      if (rank < cell.size() && static_cast<int>(chosen.size()) < budget_) chosen.push_back(cell[rank]);
  }
  orb_->compute(grey_, chosen, features.descriptors);
  features.cells.resize(features.grid.size());
  for (const cv::KeyPoint& corner : chosen) {
    const float z = depth_.at<float>(cv::Point(corner.pt));
    features.cells[cell_of(corner)].push_back(features.size());
    features.pixels.push_back(corner.pt);
    features.sigmas.push_back(std::pow(level_scale, static_cast<float>(corner.octave)));
    features.depths.push_back(std::isfinite(z) && z > 0 ? z : 0);
  }
  return features;
}

}  // namespace slam
