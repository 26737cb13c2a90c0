// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace network::test {

/// Small ids drawn with characters: '.' for 0, digits for themselves.
using Picture = std::vector<std::string>;

inline Picture picture(const cv::Mat& ids) {
  Picture rows;
  for (int y = 0; y < ids.rows; ++y) {
    rows.emplace_back();
    for (int x = 0; x < ids.cols; ++x) {
      const int id = ids.at<std::uint16_t>(y, x);
      rows.back() += id == 0 ? '.' : static_cast<char>('0' + id);
    }
  }
  return rows;
}

}  // namespace network::test
