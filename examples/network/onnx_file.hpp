// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace network {

/// The name and shape of a network's input or output as its file states them; a length of -1 is not fixed.
struct Port {
  std::string name;
  std::vector<int> shape;
};

/// What a network takes and gives, in the order of the file. OpenCV's dnn module tells neither the size of the input
/// nor the order of the outputs.
struct OnnxFile {
  std::vector<Port> inputs;  ///< without the weights
  std::vector<Port> outputs;
  std::vector<std::string> rows;  ///< constants of shape 1xN, N > 1, that are added, subtracted, multiplied or divided
};

/// Reads these alone.
/// Source: onnx.proto3 (ModelProto.graph = 7; GraphProto.node = 1, initializer = 5, input = 11, output = 12) and the
/// encoding of Protocol Buffers.
/// @throws runner::FileError when the file cannot be read or is no ONNX model.
OnnxFile read_onnx(const std::filesystem::path& path);

}  // namespace network
