// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>

#include <opencv2/core/utility.hpp>

namespace dot {

/// Does independent pieces of work on several threads, of OpenCV's pool or the host's. How many there are must not show
/// in any result: a piece writes to places of its own, and whoever adds pieces up does so in their order, afterwards.
struct Workers {
  /// Calls job(0) ... job(count - 1), each once, in any order or at the same time, and returns when all have ended.
  using Pool = std::function<void(int count, const std::function<void(int)>& job)>;

  int threads = 1;  ///< at most so many pieces at a time; 1: all in the calling thread
  Pool pool;        ///< the host's; empty: OpenCV's, whose number of threads is not touched

  /// Calls work(worker, i) for 0 <= i < count. No two calls at the same time have the same `worker`, which is less than
  /// max(1, threads), so that each worker may have its own buffers.
  template <typename Work>
  void run(int count, Work&& work) const {
    const int workers = std::min(threads, count);
    if (workers <= 1) {
      for (int i = 0; i < count; ++i) work(0, i);
      return;
    }
    std::atomic<int> next{0};
    const auto take = [&](int worker) {
      for (int i = next++; i < count; i = next++) work(worker, i);
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

}  // namespace dot
