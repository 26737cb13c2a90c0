// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace dot {

/// A read-only view of `size` consecutive elements. The owner of the elements defines how long it is valid.
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
