// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "tensor.hpp"

#include <sstream>

namespace network {

std::string to_text(const std::vector<int>& shape) {
  std::string text;
  for (const int length : shape) text += (text.empty() ? "" : "x") + (length < 0 ? "?" : std::to_string(length));
  return text.empty() ? "scalar" : text;
}

std::string to_text(float value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void bad_shape(const Tensor& tensor, const std::string& expected) {
  throw NetworkError("output '" + tensor.name + "' has shape " + to_text(tensor.shape) + ", expected " + expected);
}

std::size_t count_of(const std::vector<int>& shape) {
  std::size_t count = 1;
  for (const int length : shape) count *= static_cast<std::size_t>(length);
  return count;
}

}  // namespace network
