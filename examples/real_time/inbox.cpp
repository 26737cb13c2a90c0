// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "inbox.hpp"

#include <utility>

namespace real_time {

void Inbox::put(Arrival arrival) {
  {
    const std::lock_guard lock(mutex_);
    if (frame_) ++dropped_;
    frame_ = std::move(arrival);
  }
  changed_.notify_one();
}

void Inbox::put(LateSegmentation late) {
  {
    const std::lock_guard lock(mutex_);
    masks_.push_back(std::move(late));
  }
  changed_.notify_one();
}

void Inbox::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_one();
}

void Inbox::fail(std::exception_ptr error) {
  {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
  }
  changed_.notify_one();
}

std::optional<Inbox::Item> Inbox::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || closed_ || frame_ || !masks_.empty(); });
  if (error_) std::rethrow_exception(error_);
  if (!masks_.empty()) {
    Item item = std::move(masks_.front());
    masks_.pop_front();
    return item;
  }
  if (!frame_) return std::nullopt;
  Item item = std::move(*frame_);
  frame_.reset();
  return item;
}

void Inbox::check() const {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
}

int Inbox::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace real_time
