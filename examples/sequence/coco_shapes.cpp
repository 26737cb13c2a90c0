// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "coco_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace runner {

std::vector<std::int64_t> decode_run_lengths(const std::string& text) {
  constexpr int first = 48, more = 32, sign = 16, bits = 5, most_bits = 35;
  std::vector<std::int64_t> lengths;
  for (std::size_t at = 0; at < text.size();) {
    std::int64_t value = 0;
    int group = more;
    for (int shift = 0; (group & more) != 0; shift += bits) {
      if (at == text.size()) throw std::invalid_argument("the run lengths are cut short");
      group = static_cast<unsigned char>(text[at++]) - first;
      if (group < 0 || group >= 2 * more) throw std::invalid_argument("the run lengths have a wrong character");
      if (shift >= most_bits) throw std::invalid_argument("a run length is too large");
      value |= static_cast<std::int64_t>(group & (more - 1)) << shift;
      if ((group & more) == 0 && (group & sign) != 0) value -= std::int64_t{1} << (shift + bits);
    }
    if (lengths.size() > 2) value += lengths[lengths.size() - 2];
    lengths.push_back(value);
  }
  return lengths;
}

void paint_runs(const std::vector<std::int64_t>& lengths, std::uint16_t id, cv::Mat& ids) {
  const auto pixels = static_cast<std::int64_t>(ids.total());
  std::int64_t sum = 0;
  for (const std::int64_t length : lengths) {
    if (length < 0 || length > pixels - sum) throw std::invalid_argument("the run lengths do not fit the image");
    sum += length;
  }
  if (sum != pixels) throw std::invalid_argument("the run lengths do not fill the image");
  std::int64_t at = 0;
  bool in_mask = false;
  for (const std::int64_t length : lengths) {
    for (const std::int64_t end = at + length; at < end; ++at)
      if (in_mask) ids.at<std::uint16_t>(static_cast<int>(at % ids.rows), static_cast<int>(at / ids.rows)) = id;
    in_mask = !in_mask;
  }
}

void paint_polygon(const std::vector<double>& xy, std::uint16_t id, cv::Mat& ids) {
  const std::size_t corners = xy.size() / 2;
  if (xy.size() % 2 != 0 || corners < 3)
    throw std::invalid_argument("a polygon needs x and y of three corners or more");
  std::vector<double> crossings;
  for (int row = 0; row < ids.rows; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0, before = corners - 1; i < corners; before = i++) {
      const double x0 = xy[2 * before], y0 = xy[2 * before + 1], x1 = xy[2 * i], y1 = xy[2 * i + 1];
      if ((y0 <= y) != (y1 <= y)) crossings.push_back(x0 + (x1 - x0) * (y - y0) / (y1 - y0));
    }
    std::sort(crossings.begin(), crossings.end());
    const auto first_after = [&](double x) {
      return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(ids.cols)));
    };
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      for (int x = first_after(crossings[i]); x < first_after(crossings[i + 1]); ++x)
        ids.at<std::uint16_t>(row, x) = id;
  }
}

}  // namespace runner
