// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Counts the allocations of this process. With glibc the program's own malloc, calloc, realloc, aligned_alloc,
/// posix_memalign and memalign stand before the library's, and everything passes through them: operator new, cv::Mat,
/// Eigen. Elsewhere, and under sanitizers, which have their own, operator new alone is counted.

namespace dot::test {

/// Counts from construction on.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;

  long count() const;
  /// Whether more than operator new is counted.
  static bool sees_malloc();
};

}  // namespace dot::test
