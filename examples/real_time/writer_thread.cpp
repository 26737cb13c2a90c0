// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "writer_thread.hpp"

#include <cstddef>
#include <utility>

namespace real_time {
namespace {

/// Copies the pixels and makes `view` one of the copy.
template <typename T>
std::vector<T> own(dot::ImageView<const T>& view) {
  std::vector<T> pixels;
  pixels.reserve(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y) pixels.insert(pixels.end(), view.row(y), view.row(y) + view.width);
  view = {pixels.data(), view.width, view.height, static_cast<std::ptrdiff_t>(sizeof(T)) * view.width};
  return pixels;
}

}  // namespace

WriterThread::WriterThread(ResultConsumer consume) : consume_(std::move(consume)), thread_([this] { work(); }) {}

WriterThread::~WriterThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void WriterThread::put(const FramePtr& frame, const dot::Result& result, double total_ms) {
  constexpr std::size_t most = 64;
  Item item{frame, result, total_ms, {}, {}, {result.objects.begin(), result.objects.end()}};
  item.labels = own(item.result.labels);
  item.ids = own(item.result.ids);
  item.result.objects = {item.objects.data(), item.objects.size()};
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return error_ || queue_.size() < most; });
  if (error_) std::rethrow_exception(error_);
  queue_.push_back(std::move(item));  // the vectors' contents stay in place
  changed_.notify_all();
}

void WriterThread::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  thread_.join();
  if (error_) std::rethrow_exception(error_);
}

void WriterThread::work() {
  try {
    for (;;) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || finished_ || !queue_.empty(); });
      if (stop_ || queue_.empty()) return;
      const Item item = std::move(queue_.front());
      queue_.pop_front();
      lock.unlock();
      changed_.notify_all();
      consume_(*item.frame, item.result, item.total_ms);
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    error_ = std::current_exception();
    changed_.notify_all();
  }
}

}  // namespace real_time
