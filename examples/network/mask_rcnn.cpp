// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "mask_rcnn.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace network {
namespace {

/// A number for each instance. OpenCV's dnn module gives Nx1 for N.
bool is_list(const Tensor& t, int instances) {
  return (t.shape.size() == 1 || (t.shape.size() == 2 && t.shape[1] == 1)) && t.shape[0] == instances;
}

const Tensor& list_at(const std::vector<Tensor>& outputs, std::size_t place, int instances, const char* what) {
  const Tensor& output = outputs[place];
  if (!is_list(output, instances)) bad_shape(output, std::to_string(instances) + " (" + what + ")");
  return output;
}

int class_of(const Tensor& labels, std::size_t i, int first, int classes) {
  const float value = labels.values[i];
  const float last = static_cast<float>(classes - 1 + first);
  if (value != std::floor(value) || value < static_cast<float>(first) || value > last)
    throw NetworkError("output '" + labels.name + "' has the class " + to_text(value) +
                       ", expected whole numbers from " + std::to_string(first) + " to " +
                       std::to_string(classes - 1 + first));
  return static_cast<int>(value) - first;
}

/// Where the mask of an instance lies: over the whole input, or over its box.
Grid grid_of(const Tensor& masks, std::size_t i, MaskRcnnKind kind, const cv::Rect2d& box, const Placement& p) {
  const int height = masks.shape[2], width = masks.shape[3];
  const std::size_t cells = static_cast<std::size_t>(height) * static_cast<std::size_t>(width);
  const cv::Mat values(height, width, CV_32F, const_cast<float*>(masks.values.data() + i * cells));
  if (kind == MaskRcnnKind::Torchvision) return {values, p.offset_x, p.scale_x, p.offset_y, p.scale_y};
  const double x_cells = width / box.width, y_cells = height / box.height;
  return {values, -x_cells * box.x, x_cells, -y_cells * box.y, y_cells};
}

}  // namespace

MaskRcnnKind mask_rcnn_kind(std::size_t outputs) {
  if (outputs == 4) return MaskRcnnKind::Torchvision;
  if (outputs == 5) return MaskRcnnKind::Detectron2;
  throw NetworkError("has " + std::to_string(outputs) +
                     " outputs, expected 4 (torchvision: boxes, labels, scores, masks) or 5 (Detectron2: pred_boxes, "
                     "pred_classes, pred_masks, scores, image_size)");
}

std::vector<Detection> decode_mask_rcnn(const std::vector<Tensor>& outputs, MaskRcnnKind kind, int classes,
                                        const Placement& placement, const Threshold& threshold) {
  const bool torchvision = kind == MaskRcnnKind::Torchvision;
  const Tensor& boxes = outputs[0];
  if (boxes.shape.size() != 2 || boxes.shape[1] != 4) bad_shape(boxes, "Nx4 (boxes)");
  const int count = boxes.shape[0];
  const Tensor& labels = list_at(outputs, 1, count, "classes");
  const Tensor& scores = list_at(outputs, torchvision ? 2 : 3, count, "scores");
  const Tensor& masks = outputs[torchvision ? 3 : 2];
  if (masks.shape.size() != 4 || masks.shape[0] != count || masks.shape[1] != 1 ||
      (torchvision && (masks.shape[2] != placement.input.height || masks.shape[3] != placement.input.width)))
    bad_shape(masks, std::to_string(count) + "x1x" +
                         (torchvision ? to_text({placement.input.height, placement.input.width}) +
                                            " (torchvision's masks, of the input's size)"
                                      : "hxw (Detectron2's masks of the boxes)"));

  const cv::Rect whole({}, placement.image);
  std::vector<Detection> detections;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const float* b = &boxes.values[4 * i];
    const bool is_finite = std::all_of(b, b + 4, [](float edge) { return std::isfinite(edge); });
    if (!(scores.values[i] > threshold.score) || !is_finite || b[2] <= b[0] || b[3] <= b[1]) continue;
    const cv::Rect2d box((b[0] - placement.offset_x) / placement.scale_x,
                         (b[1] - placement.offset_y) / placement.scale_y, (b[2] - b[0]) / placement.scale_x,
                         (b[3] - b[1]) / placement.scale_y);
    const cv::Rect region = pixels_in(placement.to_image(b[0], b[1], b[2], b[3])) & whole;
    const int index = class_of(labels, i, torchvision ? 1 : 0, classes);
    if (region.empty()) continue;
    detections.push_back(
        {index, scores.values[i], region, sample(grid_of(masks, i, kind, box, placement), region, 0.5F)});
  }
  return detections;
}

}  // namespace network
