// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "yolo_seg.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/dnn.hpp>
#include <string>

namespace network {
namespace {

/// The candidates, whichever way round they are stored.
struct Candidates {
  const float* values = nullptr;
  int count = 0;
  int classes = 0;
  int first_class = 0;             ///< place of the first class score; 5 where there is an objectness
  std::ptrdiff_t step = 0;         ///< from one candidate to the next
  std::ptrdiff_t column_step = 0;  ///< from one of its numbers to the next

  float at(int candidate, int column) const { return values[candidate * step + column * column_step]; }
  float objectness(int candidate) const { return first_class == 5 ? at(candidate, 4) : 1; }
};

const Tensor& of_rank(const std::vector<Tensor>& outputs, std::size_t rank, const char* what) {
  for (const Tensor& output : outputs)
    if (output.shape.size() == rank) return output;
  std::string shapes;
  for (const Tensor& output : outputs)
    shapes += (shapes.empty() ? "'" : ", '") + output.name + "' " + to_text(output.shape);
  throw NetworkError(std::string("has no output of shape ") + what + ", only " + shapes);
}

Candidates read_candidates(const Tensor& output, int classes, int coefficients) {
  Candidates c;
  c.values = output.values.data();
  c.classes = classes;
  const int rows = output.shape[1], columns = output.shape[2], v8 = 4 + classes + coefficients, v5 = v8 + 1;
  if (output.shape[0] == 1 && rows == v8) {
    c.count = columns, c.first_class = 4, c.step = 1, c.column_step = columns;
  } else if (output.shape[0] == 1 && columns == v5) {
    c.count = rows, c.first_class = 5, c.step = columns, c.column_step = 1;
  } else {
    bad_shape(output, "1x" + std::to_string(v8) + "xN (YOLOv8, YOLO11) or 1xNx" + std::to_string(v5) +
                          " (YOLOv5), with " + std::to_string(classes) + " classes and " +
                          std::to_string(coefficients) + " mask coefficients");
  }
  return c;
}

/// The sum of the prototypes over the cells that the pixels of `region` are interpolated from.
Grid weighted(const Tensor& prototypes, const Candidates& candidates, int candidate, const Placement& p,
              const cv::Rect& region) {
  const int height = prototypes.shape[2], width = prototypes.shape[3];
  const double x_cells = 1.0 * width / p.input.width, y_cells = 1.0 * height / p.input.height;
  Grid grid{{}, x_cells * p.offset_x, x_cells * p.scale_x, y_cells * p.offset_y, y_cells * p.scale_y};
  const auto cells = [](double origin, double step, int begin, int end, int most) {
    const int first = std::clamp(static_cast<int>(std::floor(origin + step * begin)) - 1, 0, most);
    return cv::Range(first, std::clamp(static_cast<int>(std::ceil(origin + step * end)) + 1, first, most));
  };
  const cv::Range xs = cells(grid.x0, grid.x_step, region.x, region.x + region.width, width);
  const cv::Range ys = cells(grid.y0, grid.y_step, region.y, region.y + region.height, height);
  grid.values = cv::Mat(ys.size(), xs.size(), CV_32F, cv::Scalar(0));
  for (int k = 0; k < prototypes.shape[1]; ++k) {
    const float weight = candidates.at(candidate, candidates.first_class + candidates.classes + k);
    const float* plane = prototypes.values.data() + static_cast<std::ptrdiff_t>(k) * height * width;
    for (int y = ys.start; y < ys.end; ++y)
      for (int x = xs.start; x < xs.end; ++x)
        grid.values.at<float>(y - ys.start, x - xs.start) += weight * plane[y * width + x];
  }
  grid.x0 -= xs.start;
  grid.y0 -= ys.start;
  return grid;
}

}  // namespace

std::vector<Detection> decode_yolo_seg(const std::vector<Tensor>& outputs, int classes, const Placement& placement,
                                       const Threshold& threshold) {
  const Tensor& prototypes = of_rank(outputs, 4, "1xKxHxW (the masks' prototypes)");
  if (prototypes.shape[0] != 1) bad_shape(prototypes, "1xKxHxW (the masks' prototypes)");
  const Candidates candidates =
      read_candidates(of_rank(outputs, 3, "1xMxN (boxes, scores and coefficients)"), classes, prototypes.shape[1]);

  std::vector<cv::Rect2d> boxes, apart;
  std::vector<float> scores;
  std::vector<int> best, index;
  for (int i = 0; i < candidates.count; ++i) {
    int c = 0;
    for (int other = 1; other < classes; ++other)
      if (candidates.at(i, candidates.first_class + other) > candidates.at(i, candidates.first_class + c)) c = other;
    const float score = candidates.objectness(i) * candidates.at(i, candidates.first_class + c);
    const double x = candidates.at(i, 0), y = candidates.at(i, 1), w = candidates.at(i, 2), h = candidates.at(i, 3);
    if (!(score > threshold.score) || !std::isfinite(x + y + w + h)) continue;
    boxes.push_back(placement.to_image(x - w / 2, y - h / 2, x + w / 2, y + h / 2));
    // Boxes of different classes are moved apart, so that they do not suppress each other.
    apart.push_back(boxes.back() + cv::Point2d(2.0 * c * placement.image.width, 0));
    scores.push_back(score);
    best.push_back(c);
    index.push_back(i);
  }

  std::vector<int> kept;  // the surest first
  cv::dnn::NMSBoxes(apart, scores, threshold.score, threshold.overlap, kept);
  kept.resize(std::min(kept.size(), static_cast<std::size_t>(threshold.most)));
  std::vector<Detection> detections;
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    const cv::Rect region = pixels_in(boxes[i]);
    if (region.empty()) continue;
    detections.push_back(
        {best[i], scores[i], region, sample(weighted(prototypes, candidates, index[i], placement, region), region, 0)});
  }
  return detections;
}

}  // namespace network
