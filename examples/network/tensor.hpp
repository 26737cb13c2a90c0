// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace network {

/// Numbers in row-major order; the last index is the fastest.
struct Tensor {
  std::string name;
  std::vector<int> shape;
  std::vector<float> values;
};

/// A network is not what its format says; the message names the tensor.
struct NetworkError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "1x3x640x640"; a negative length is one that is not fixed and reads "?".
std::string to_text(const std::vector<int>& shape);

/// A number for a message, "0.5".
std::string to_text(float value);

/// @throws NetworkError "output 'x' has shape 1x2, expected ...".
[[noreturn]] void bad_shape(const Tensor& tensor, const std::string& expected);

/// How many numbers a shape holds.
std::size_t count_of(const std::vector<int>& shape);

}  // namespace network
