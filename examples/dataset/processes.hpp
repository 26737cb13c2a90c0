// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include "child_process.hpp"

namespace dataset {

/// Jobs in processes of their own, a few of them at a time.
struct Processes {
  int side_by_side = 1;
  std::function<void(std::size_t job)> work;                  ///< in a process of its own; throws when it fails
  std::function<void(std::size_t job, const Ending&)> ended;  ///< in this process, as the next one
  std::function<void(std::size_t running)> stopping;          ///< those that run are asked to end; may be empty

  /// Returns when all jobs have ended, in whatever order. When `stop` is set no more are begun, and those that run
  /// are asked to end.
  void run(const std::vector<std::size_t>& jobs, const std::atomic<bool>& stop) const;
};

}  // namespace dataset
