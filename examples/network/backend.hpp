// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "onnx_file.hpp"
#include "tensor.hpp"

namespace network {

/// What runs a network. One thread at a time may use it.
class Backend {
 public:
  virtual ~Backend() = default;

  /// @return the outputs in the order of the file.
  /// @throws NetworkError when the network cannot be run on this input.
  virtual std::vector<Tensor> run(const Tensor& input) = 0;
};

/// Whether the program was built with ONNX Runtime.
bool has_onnx_runtime();

/// @param file what read_onnx says of `path`.
/// @throws NetworkError when the network cannot be loaded, with the name of a layer that is not supported.
std::unique_ptr<Backend> open_opencv(const std::filesystem::path& path, const OnnxFile& file);
std::unique_ptr<Backend> open_onnx_runtime(const std::filesystem::path& path, const OnnxFile& file);

}  // namespace network
