// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "input.hpp"
#include "run/segmentation.hpp"
#include "tensor.hpp"

namespace network {

/// Reads an image of instance ids, the one output of a network: HxW, with 1x or 1x1x before it, whole numbers from 0
/// (background) to 65535. It covers the whole input, in any resolution; each pixel of the image gets the id of the cell
/// that its centre is in.
/// @throws NetworkError naming the output and the shape, or the value that is no id.
runner::Segmentation decode_id_image(const std::vector<Tensor>& outputs, const Placement& placement);

}  // namespace network
