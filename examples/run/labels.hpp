// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <vector>

namespace runner {

constexpr int label_font = cv::FONT_HERSHEY_DUPLEX;
constexpr double label_scale = 0.42;

/// Finds places for labels that do not cover one another.
class LabelPlacer {
 public:
  enum class Reach {
    Near,  ///< next to the box or not at all
    Far    ///< farther away where there is no room, and over others as a last resort
  };

  explicit LabelPlacer(cv::Size picture) : picture_(cv::Point(), picture) {}

  /// Keeps later labels off a part of the picture.
  void block(const cv::Rect& area) { taken_.push_back(area); }

  /// A place of this size above or below `box`, or in it, or, with Reach::Far, farther away; taken from then on.
  std::optional<cv::Rect> place(const cv::Rect& box, cv::Size size, Reach reach);

 private:
  bool is_free(const cv::Rect& label) const;

  cv::Rect picture_;
  std::vector<cv::Rect> taken_;
};

/// Draws a filled label with text near `box`, and a line between them where it had to go farther away.
void draw_label(cv::Mat& picture, LabelPlacer& placer, LabelPlacer::Reach reach, const cv::Rect& box,
                const std::string& text, const cv::Scalar& background, const cv::Scalar& foreground);

}  // namespace runner
