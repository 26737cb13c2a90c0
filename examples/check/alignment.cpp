// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "alignment.hpp"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "median.hpp"

namespace check {

Alignment::Alignment(cv::Size size)
    : size_(size),
      padded_(cv::getOptimalDFTSize(size.width + kMaxOffset), cv::getOptimalDFTSize(size.height + kMaxOffset)) {}

cv::Mat Alignment::transform(const cv::Mat& edges) const {
  cv::Mat padded, spectrum;
  cv::copyMakeBorder(edges, padded, 0, padded_.height - size_.height, 0, padded_.width - size_.width,
                     cv::BORDER_CONSTANT);
  cv::dft(padded, spectrum);
  return spectrum;
}

void Alignment::Sum::add(const Sum& other) {
  for (int side = 0; side < 2; ++side) {
    if (other.spectra[side].empty()) continue;
    if (spectra[side].empty())
      spectra[side] = other.spectra[side].clone();
    else
      spectra[side] += other.spectra[side];
    pixels[side] += other.pixels[side];
  }
}

void Alignment::accumulate(const Transforms& sides, const Transforms& image, int lag, int part) {
  if (sides.sides[0].empty()) return;
  Sum sum;
  for (int side = 0; side < 2; ++side) {
    cv::mulSpectrums(sides.sides[side], image.image, sum.spectra[side], 0, true);
    sum.pixels[side] = sides.pixels[side];
  }
  sums_[part][lag + kMaxLag].add(sum);
}

void Alignment::add(const Sides& sides, const cv::Mat& image_edges, bool follows, int part) {
  if (!follows) last_.clear();
  Transforms now;
  now.image = transform(image_edges);
  if (!sides.left.empty()) {
    const cv::Mat* const both[] = {&sides.left, &sides.right};
    for (int side = 0; side < 2; ++side) {
      now.pixels[side] = cv::sum(*both[side])[0];
      now.sides[side] = transform(*both[side]);
    }
  }
  last_.push_back(std::move(now));
  const auto newest = last_.size() - 1;
  accumulate(last_[newest], last_[newest], 0, part);
  for (std::size_t lag = 1; lag <= static_cast<std::size_t>(kMaxLag) && lag <= newest; ++lag) {
    accumulate(last_[newest], last_[newest - lag], static_cast<int>(lag), part);
    accumulate(last_[newest - lag], last_[newest], -static_cast<int>(lag), part);
  }
  if (last_.size() > static_cast<std::size_t>(kMaxLag)) last_.erase(last_.begin());
}

namespace {

/// Highest place of a window whose middle is offset 0, over the mean of what is not near it.
struct Peak {
  double height = 0;
  cv::Point2d offset;
};

Peak peak_of(const cv::Mat& window) {
  Peak peak;
  cv::Point at;
  cv::minMaxLoc(window, nullptr, &peak.height, nullptr, &at);
  const cv::Point middle(window.cols / 2, window.rows / 2);
  peak.offset = at - middle;
  // The top of a parabola through the neighbours.
  const auto top = [](double before, double here, double after) {
    const double curvature = before - 2 * here + after;
    return curvature < 0 ? 0.5 * (before - after) / curvature : 0;
  };
  const auto value = [&](int dx, int dy) { return static_cast<double>(window.at<float>(at.y + dy, at.x + dx)); };
  if (at.x > 0 && at.x + 1 < window.cols) peak.offset.x += top(value(-1, 0), peak.height, value(1, 0));
  if (at.y > 0 && at.y + 1 < window.rows) peak.offset.y += top(value(0, -1), peak.height, value(0, 1));
  cv::Mat away(window.size(), CV_8U, cv::Scalar(255));
  constexpr int radius = 8;
  cv::circle(away, at, radius, cv::Scalar(0), cv::FILLED);
  peak.height -= cv::mean(window, away)[0];
  return peak;
}

}  // namespace

Match Alignment::match_of(const Sum& sum) const {
  Match match;
  for (int side = 0; side < 2; ++side) {
    if (sum.spectra[side].empty() || sum.pixels[side] <= 0) return {};
    cv::Mat correlation;
    cv::dft(sum.spectra[side], correlation, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    constexpr int width = 2 * kMaxOffset + 1;
    cv::Mat window(width, width, CV_32F);
    for (int y = 0; y < width; ++y)
      for (int x = 0; x < width; ++x)
        window.at<float>(y, x) = correlation.at<float>((y - kMaxOffset + padded_.height) % padded_.height,
                                                       (x - kMaxOffset + padded_.width) % padded_.width);
    cv::GaussianBlur(window, window, {}, 1);
    const Peak peak = peak_of(window);
    match.height += peak.height / sum.pixels[side];
    match.offset += 0.5 * peak.offset;
  }
  return match;
}

Match Alignment::match(int lag, int part) const { return match_of(sums_[part][lag + kMaxLag]); }

Match Alignment::match(int lag) const {
  Sum all;
  for (const auto& part : sums_) all.add(part[lag + kMaxLag]);
  return match_of(all);
}

namespace {

template <typename Height>
int best_lag(Height height) {
  int best = 0;
  for (int lag = -Alignment::kMaxLag; lag <= Alignment::kMaxLag; ++lag)
    if (height(lag) > height(best)) best = lag;
  return best;
}

}  // namespace

Lag find_lag(const Alignment& alignment) {
  constexpr double clearly = 1.25;  // heights of a true lag over the next best on all sequences tried: 1.3 and more
  constexpr double least = 0.1;     // height: below, nothing of the one is seen in the other
  double heights[2 * Alignment::kMaxLag + 1];
  const auto height = [&](int lag) -> double& { return heights[lag + Alignment::kMaxLag]; };
  for (int lag = -Alignment::kMaxLag; lag <= Alignment::kMaxLag; ++lag) height(lag) = alignment.match(lag).height;
  Lag lag;
  const int best = best_lag(height);
  int agreeing = 0, parts = 0;
  for (int part = 0; part < Alignment::kParts; ++part) {
    double of_part[2 * Alignment::kMaxLag + 1];
    for (int l = -Alignment::kMaxLag; l <= Alignment::kMaxLag; ++l)
      of_part[l + Alignment::kMaxLag] = alignment.match(l, part).height;
    const int said = best_lag([&](int l) { return of_part[l + Alignment::kMaxLag]; });
    if (of_part[said + Alignment::kMaxLag] <= 0) continue;
    ++parts;
    if (said == best) ++agreeing;
  }
  double next = 0;
  int others = 0;  // a recording of one frame has none
  for (int l = -Alignment::kMaxLag; l <= Alignment::kMaxLag; ++l)
    if (l != best && height(l) > 0) next = std::max(next, height(l)), ++others;
  lag.frames = best;
  lag.known = others > 1 && height(best) > least && height(best) > clearly * next;
  lag.clear = best != 0 && height(best) > least && height(best) > clearly * height(0) && 4 * agreeing >= 3 * parts;
  lag.match = alignment.match(lag.clear ? best : 0);
  std::vector<double> differences;
  for (int part = 0; part < Alignment::kParts; ++part)
    if (const Match match = alignment.match(lag.clear ? best : 0, part); match.height > 0)
      differences.push_back(cv::norm(match.offset - lag.match.offset));
  lag.spread = differences.empty() ? 0 : quantile(std::move(differences), 0.75);
  return lag;
}

}  // namespace check
