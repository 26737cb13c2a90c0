// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "detections.hpp"
#include "input.hpp"
#include "tensor.hpp"

namespace network {

/// Who has exported a Mask R-CNN.
enum class MaskRcnnKind { Torchvision, Detectron2 };

/// Torchvision has four outputs (boxes, labels, scores, masks), Detectron2 five (boxes, classes, masks, scores, size).
/// @throws NetworkError for other numbers.
MaskRcnnKind mask_rcnn_kind(std::size_t outputs);

/// Reads the outputs of a Mask R-CNN in the order of its file, which both kinds have in common but for the masks. Of N
/// instances: boxes Nx4 (x1, y1, x2, y2 in pixels of the input); classes N; scores N; and masks, the probability
/// - Torchvision: Nx1xHxW over the whole input; classes count from 1, the first of the list;
/// - Detectron2: Nx1xhxw (28x28) over the box, 0 around it; classes count from 0.
/// A mask is where the interpolated probability is over 0.5.
/// Source: torchvision.models.detection.MaskRCNN; detectron2.layers.mask_ops.paste_masks_in_image.
/// @throws NetworkError naming the output and the shape that was expected, or the class that the list lacks.
std::vector<Detection> decode_mask_rcnn(const std::vector<Tensor>& outputs, MaskRcnnKind kind, int classes,
                                        const Placement& placement, const Threshold& threshold);

}  // namespace network
