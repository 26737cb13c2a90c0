// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include <opencv2/core/utility.hpp>

#include "dot/abi.hpp"
#include "dot/threads/thread_pool.hpp"

DOT_BEGIN_NAMESPACE

/// Runs independent pieces of work on several threads. The results do not depend on the number of threads. For this
/// each piece must write to separate memory, and work that depends on other pieces must be in a later `run`.
struct Threads {
  int count = 1;    ///< at most so many pieces at a time; 1: all in the calling thread, without allocation
  ThreadPool pool;  ///< the host's; empty: OpenCV's, whose number of threads is not touched

  /// Calls work(worker, i) for 0 <= i < pieces. No two calls at the same time have the same `worker`, which is less
  /// than max(1, count), so that each worker may have buffers of its own.
  template <typename Work>
  void run(int pieces, Work&& work) const {
    const int workers = std::min(count, pieces);
    if (workers <= 1) {
      for (int i = 0; i < pieces; ++i) work(0, i);
      return;
    }
    std::atomic<int> next{0};
    const auto take = [&](int worker) {
      for (int i = next++; i < pieces; i = next++) work(worker, i);
    };
    if (pool)
      pool(workers, std::ref(take));
    else
      cv::parallel_for_(
          cv::Range(0, workers),
          [&](const cv::Range& range) {
            for (int worker = range.start; worker < range.end; ++worker) take(worker);
          },
          workers);
  }
};

/// A task, and an earlier one that it depends on, by their numbers.
struct Dependence {
  std::size_t task;     ///< the later one
  std::size_t earlier;  ///< less than `task`
};

/// Assigns rounds to `n` tasks. Each is in the round after the last task that it waits for.
/// @param waits in the order of the later tasks. @return the number of rounds; `rounds[i]` is that of the i-th task.
inline int rounds_of(std::size_t n, const std::vector<Dependence>& waits, std::vector<int>& rounds) {
  rounds.assign(n, 0);
  for (const Dependence& d : waits) rounds[d.task] = std::max(rounds[d.task], rounds[d.earlier] + 1);
  return n > 0 ? *std::max_element(rounds.begin(), rounds.end()) + 1 : 0;
}

DOT_END_NAMESPACE
