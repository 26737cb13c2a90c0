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

  /// Calls work(worker, begin, end) for bands of rows, which together are 0 to `rows`. See `run`.
  template <typename Work>
  void run_bands(int rows, Work&& work) const {
    constexpr int kBands = 8;  // even out what bands cost, for some threads
    run(kBands, [&](int worker, int band) { work(worker, rows * band / kBands, rows * (band + 1) / kBands); });
  }
};

/// Assigns rounds to `n` tasks. Each is in the round after the last earlier task that it waits for.
/// @param waits waits(earlier, later) -> bool. @return the number of rounds; `rounds[i]` is that of the i-th task.
template <typename Waits>
int rounds_of(std::size_t n, Waits&& waits, std::vector<int>& rounds) {
  rounds.assign(n, 0);
  int count = 0;
  for (std::size_t later = 0; later < n; ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier)
      if (rounds[earlier] >= rounds[later] && waits(earlier, later)) rounds[later] = rounds[earlier] + 1;
    count = std::max(count, rounds[later] + 1);
  }
  return count;
}

DOT_END_NAMESPACE
