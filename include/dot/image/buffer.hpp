// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace dot {

/// Leaves new elements of a container uninitialised. To clear them would take as long as the write that follows.
template <typename T>
struct UninitializedAllocator : std::allocator<T> {
  /// The same for elements of another type.
  template <typename U>
  struct rebind {
    using other = UninitializedAllocator<U>;  ///< the allocator for U
  };

  UninitializedAllocator() = default;
  /// Of another type; it has no state.
  template <typename U>
  UninitializedAllocator(const UninitializedAllocator<U>&) noexcept {}

  /// Leaves a number uninitialised.
  template <typename U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
  /// Constructs an element from arguments.
  template <typename U, typename... Args>
  void construct(U* at, Args&&... args) {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
};

/// A vector of numbers, or of structures of numbers, whose `resize` leaves the new elements unspecified.
template <typename T>
using Buffer = std::vector<T, UninitializedAllocator<T>>;

}  // namespace dot
