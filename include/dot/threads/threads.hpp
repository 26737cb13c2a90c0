// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <stdexcept>
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
  /// than max(1, count), so that each worker may have buffers of its own. If a piece throws, no further ones begin, and
  /// its exception is thrown.
  /// @throws std::runtime_error if the host's pool has not run its jobs.
  template <typename Work>
  void run(int pieces, Work&& work) const {
    const int workers = std::min(count, pieces);
    if (workers <= 1) {
      for (int i = 0; i < pieces; ++i) work(0, i);
      return;
    }
    std::atomic<int> next{0};
    std::atomic_flag failed = ATOMIC_FLAG_INIT;
    std::exception_ptr failure;  // of the first piece that failed; not every pool hands exceptions on
    const auto take = [&](int worker) {
      try {
        for (int i = next++; i < pieces; i = next++) work(worker, i);
      } catch (...) {
        next = pieces;
        if (!failed.test_and_set()) failure = std::current_exception();
      }
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
    if (failure) std::rethrow_exception(failure);
    if (next < pieces) throw std::runtime_error("the host's thread pool has not run its jobs");
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
