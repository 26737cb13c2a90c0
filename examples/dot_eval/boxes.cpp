// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "dot/opencv.hpp"

namespace eval {

void make_boxes(double margin, runner::SequenceFrame& frame) {
  if (frame.ids.empty()) return;
  cv::Mat ids;
  frame.ids.convertTo(ids, CV_32S);
  std::map<std::uint32_t, cv::Rect> boxes;
  for (int y = 0; y < ids.rows; ++y)
    for (int x = 0; x < ids.cols; ++x)
      if (const int id = ids.at<int>(y, x); id != 0) boxes[static_cast<std::uint32_t>(id)] |= cv::Rect(x, y, 1, 1);

  frame.filled = cv::Mat(ids.rows, ids.cols, CV_8U, cv::Scalar(255));
  std::vector<dot::Instance> instances;
  for (const auto& [id, box] : boxes) {
    const auto known = std::find_if(frame.instances.begin(), frame.instances.end(),
                                    [id = id](const dot::Instance& i) { return i.id == id; });
    dot::Instance instance = known != frame.instances.end() ? *known : dot::Instance{};
    const int dx = static_cast<int>(margin * box.width), dy = static_cast<int>(margin * box.height);
    const cv::Rect wide(box.x - dx, box.y - dy, box.width + 2 * dx, box.height + 2 * dy);
    const cv::Rect inside = wide & cv::Rect(0, 0, ids.cols, ids.rows);
    instance.id = id;
    instance.x = inside.x, instance.y = inside.y;
    instance.mask = dot::view(frame.filled(cv::Rect(0, 0, inside.width, inside.height)));
    instances.push_back(instance);
  }
  frame.instances = std::move(instances);
  frame.ids.release();
}

}  // namespace eval
