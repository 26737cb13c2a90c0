// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <thread>
#include <vector>

namespace dot::test {

/// A dot::ThreadPool with threads of its own, which begin in the reverse order.
inline void host_pool(int count, const std::function<void(int)>& job) {
  std::vector<std::thread> threads;
  for (int i = count - 1; i >= 0; --i) threads.emplace_back([&job, i] { job(i); });
  for (std::thread& t : threads) t.join();
}

}  // namespace dot::test
