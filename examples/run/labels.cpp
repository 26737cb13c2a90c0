// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "labels.hpp"

#include <algorithm>

namespace runner {
namespace {

constexpr int distance = 5;  // pixels between a box and its label
constexpr int spacing = 2;   // pixels between labels

void fill_rounded(cv::Mat& picture, const cv::Rect& r, const cv::Scalar& colour) {
  constexpr int radius = 4;
  cv::rectangle(picture, {r.x + radius, r.y}, {r.br().x - 1 - radius, r.br().y - 1}, colour, cv::FILLED);
  cv::rectangle(picture, {r.x, r.y + radius}, {r.br().x - 1, r.br().y - 1 - radius}, colour, cv::FILLED);
  for (const int x : {r.x + radius, r.br().x - 1 - radius})
    for (const int y : {r.y + radius, r.br().y - 1 - radius})
      cv::circle(picture, {x, y}, radius, colour, cv::FILLED, cv::LINE_AA);
}

}  // namespace

bool LabelPlacer::is_free(const cv::Rect& label) const {
  const cv::Rect wide(label.x - spacing, label.y - spacing, label.width + 2 * spacing, label.height + 2 * spacing);
  return (label & picture_) == label &&
         std::none_of(taken_.begin(), taken_.end(), [&](const cv::Rect& other) { return !(wide & other).empty(); });
}

std::optional<cv::Rect> LabelPlacer::place(const cv::Rect& box, cv::Size size, Reach reach) {
  const int above = box.y - distance - size.height;
  const int below = box.br().y + distance;
  const int row = size.height + 2 * spacing;
  std::vector<int> rows{above, below};
  if (size.width < box.width && 2 * size.height < box.height) rows.push_back(box.y + distance);
  if (reach == Reach::Far)
    for (int i = 1; i <= 6; ++i) rows.insert(rows.end(), {above - i * row, below + i * row});

  const int right_most = std::max(spacing, picture_.width - size.width - spacing);
  const auto column = [&](int x) { return std::clamp(x, spacing, right_most); };
  const int centre = column(box.x + box.width / 2 - size.width / 2);
  for (const int y : rows) {
    for (const int x : {centre, column(box.x), column(box.br().x - size.width)}) {
      const cv::Rect label({x, y}, size);
      if (!is_free(label)) continue;
      taken_.push_back(label);
      return label;
    }
  }
  if (reach == Reach::Near) return std::nullopt;
  taken_.push_back(cv::Rect({centre, std::clamp(above, 0, std::max(0, picture_.height - size.height))}, size));
  return taken_.back();
}

void draw_label(cv::Mat& picture, LabelPlacer& placer, LabelPlacer::Reach reach, const cv::Rect& box,
                const std::string& text, const cv::Scalar& background, const cv::Scalar& foreground) {
  constexpr int padding = 5;
  int baseline = 0;
  const cv::Size glyphs = cv::getTextSize(text, label_font, label_scale, 1, &baseline);
  const std::optional<cv::Rect> found =
      placer.place(box, {glyphs.width + 2 * padding, glyphs.height + 2 * padding}, reach);
  if (!found) return;
  const cv::Rect label = *found;

  const int middle = std::clamp(box.x + box.width / 2, label.x + padding, label.br().x - padding);
  if (label.br().y + 2 * distance < box.y)
    cv::line(picture, {middle, label.br().y}, {middle, box.y - 1}, background, 1, cv::LINE_AA);
  if (label.y - 2 * distance > box.br().y)
    cv::line(picture, {middle, box.br().y}, {middle, label.y - 1}, background, 1, cv::LINE_AA);
  fill_rounded(picture, label, background);
  cv::putText(picture, text, {label.x + padding, label.br().y - padding}, label_font, label_scale, foreground, 1,
              cv::LINE_AA);
}

}  // namespace runner
