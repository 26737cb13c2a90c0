// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace dot {

/// A read-only run of `size` elements owned by somebody else; valid as long as its owner says.
template <typename T>
struct Span {
  const T* data = nullptr;
  std::size_t size = 0;

  const T* begin() const { return data; }
  const T* end() const { return data + size; }
  const T& operator[](std::size_t i) const { return data[i]; }
  bool empty() const { return size == 0; }
};

}  // namespace dot
