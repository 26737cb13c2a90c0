// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "camera_thread.hpp"

#include <cstddef>
#include <exception>
#include <memory>
#include <utility>

namespace real_time {

CameraThread::CameraThread(Reader read, std::vector<double> times, Clock& clock, std::atomic<bool>& stop, Inbox& inbox)
    : read_(std::move(read)), times_(std::move(times)), clock_(clock), stop_(stop), inbox_(inbox), thread_([this] {
        work();
      }) {}

CameraThread::~CameraThread() {
  if (!done_) stop_ = true;
  thread_.join();
}

void CameraThread::work() {
  constexpr double tolerance = 0.005;  // seconds
  try {
    double start = 0;
    for (std::size_t i = 0; i < times_.size() && !stop_; ++i) {
      const auto frame = std::make_shared<const runner::SequenceFrame>(read_(static_cast<int>(i)));
      if (i == 0) start = clock_.now();
      const double due = start + times_[i];
      if (clock_.now() > due + tolerance) ++late_;
      if (!clock_.sleep_until(due, stop_)) break;
      inbox_.put(Arrival{frame, clock_.now()});
    }
    done_ = true;
    inbox_.close();
  } catch (...) {
    inbox_.fail(std::current_exception());
  }
}

}  // namespace real_time
