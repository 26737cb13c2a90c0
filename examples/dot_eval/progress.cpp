// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <numeric>

namespace eval {

Progress::Progress(int runs) : shares_(static_cast<std::size_t>(runs)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (line_open_) std::fprintf(stderr, "\r\033[K");
}

void Progress::frame(int run, const std::string& name, int done, int total) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_[static_cast<std::size_t>(run)] = static_cast<double>(done) / total;
  if (terminal_) draw(name + ", frame " + std::to_string(done) + " of " + std::to_string(total));
}

void Progress::finished(int run, const std::string& name, const std::string& remark) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_[static_cast<std::size_t>(run)] = 1;
  ++finished_;
  if (terminal_)
    draw(name);
  else
    std::fprintf(stderr, "[%d/%zu] %s: %s\n", finished_, shares_.size(), name.c_str(), remark.c_str());
}

void Progress::draw(const std::string& name) {
  constexpr int width = 28;
  const double share = std::accumulate(shares_.begin(), shares_.end(), 0.0) / static_cast<double>(shares_.size());
  const auto filled = static_cast<std::size_t>(width * share);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r[%s] %3.0f %%  %d of %zu runs  %s\033[K", bar.c_str(), 100 * share, finished_, shares_.size(),
               name.c_str());
  std::fflush(stderr);
  line_open_ = true;
}

}  // namespace eval
