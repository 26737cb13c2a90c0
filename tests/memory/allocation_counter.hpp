// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Counts the allocations of this process, or has some of them fail. With glibc the program's own malloc, calloc,
/// realloc, aligned_alloc, posix_memalign and memalign stand before the library's, and everything passes through them:
/// operator new, cv::Mat, Eigen. Elsewhere, and under sanitizers, which have their own, operator new alone passes.

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

/// Has allocations fail as if memory were short, in all threads.
class MemoryShortage {
 public:
  enum Duration { Once, Lasting };

  /// @param first how many allocations from now on still succeed; the next one fails, and with `Lasting` all after it
  MemoryShortage(long first, Duration duration);
  ~MemoryShortage() { end(); }
  MemoryShortage(const MemoryShortage&) = delete;
  MemoryShortage& operator=(const MemoryShortage&) = delete;

  /// Whether an allocation has failed.
  bool reached() const;
  void end();
};

}  // namespace dot::test
