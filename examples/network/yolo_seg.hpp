// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "detections.hpp"
#include "input.hpp"
#include "tensor.hpp"

namespace network {

/// Reads the outputs of a YOLO segmentation network as Ultralytics exports it. With C classes, K coefficients and N
/// candidates, boxes being centre x, y, width, height in pixels of the input:
/// - YOLOv8, YOLO11: 1 x (4 + C + K) x N of box, class scores, coefficients;
/// - YOLOv5: 1 x N x (5 + C + K) of box, objectness, class scores, coefficients; the score of a class is their product;
/// - both: prototypes 1 x K x h x w over the whole input. A mask is where the prototypes, weighted by the coefficients,
///   are positive, inside the box.
/// Overlapping boxes of one class are reduced by OpenCV's non-maximum suppression. Other outputs are not looked at.
/// @throws NetworkError naming the output and the shape that was expected.
std::vector<Detection> decode_yolo_seg(const std::vector<Tensor>& outputs, int classes, const Placement& placement,
                                       const Threshold& threshold);

}  // namespace network
