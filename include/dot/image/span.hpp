// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace dot {

/// A read-only view of `size` consecutive elements. The owner of the elements defines how long it is valid.
template <typename T>
struct Span {
  const T* data = nullptr;  ///< first element; may be null if there is none
  std::size_t size = 0;     ///< number of elements

  /// The first element.
  const T* begin() const { return data; }
  /// The place after the last element.
  const T* end() const { return data + size; }
  /// The i-th element, i < size.
  const T& operator[](std::size_t i) const { return data[i]; }
  /// Whether there are no elements.
  bool empty() const { return size == 0; }
};

}  // namespace dot
