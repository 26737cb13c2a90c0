// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "dot/pipeline/result.hpp"
#include "late_segmentation.hpp"

namespace real_time {

/// What is done with a result.
using ResultConsumer = std::function<void(const runner::SequenceFrame&, const dot::Result&, double total_ms)>;

/// Calls a consumer of results in a thread of its own, in the order of the frames, so that files are written while the
/// tracker goes on. Results are copied.
class WriterThread {
 public:
  explicit WriterThread(ResultConsumer consume);
  /// What is still queued is not consumed unless `finish` was called.
  ~WriterThread();
  WriterThread(const WriterThread&) = delete;
  WriterThread& operator=(const WriterThread&) = delete;

  /// Waits while many results are queued: the memory is bounded.
  /// @throws what the consumer has thrown.
  void put(const FramePtr& frame, const dot::Result& result, double total_ms);

  /// Waits until all is consumed.
  /// @throws what the consumer has thrown.
  void finish();

 private:
  struct Item {
    FramePtr frame;
    dot::Result result;
    double total_ms;
    std::vector<std::uint8_t> labels;  // the result's views are of these
    std::vector<std::uint32_t> ids;
    std::vector<dot::ObjectResult> objects;
  };

  void work();

  ResultConsumer consume_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> queue_;
  std::exception_ptr error_;
  bool finished_ = false;
  bool stop_ = false;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace real_time
