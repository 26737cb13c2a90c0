// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "processes.hpp"

#include <chrono>
#include <csignal>
#include <exception>
#include <map>
#include <optional>
#include <thread>

namespace dataset {

void Processes::run(const std::vector<std::size_t>& jobs, const std::atomic<bool>& stop) const {
  constexpr std::chrono::milliseconds pause(10);
  std::signal(SIGCHLD, SIG_DFL);  // where the one who has started this program ignores it, no ending would be known
  std::map<std::size_t, ChildProcess> running;
  bool told = false;
  for (auto next = jobs.begin(); (next != jobs.end() && !stop) || !running.empty();) {
    while (!stop && next != jobs.end() && running.size() < static_cast<std::size_t>(side_by_side)) {
      const std::size_t job = *next++;
      try {
        running.emplace(job, ChildProcess([&] { work(job); }));
      } catch (const std::exception& error) {
        ended(job, {false, error.what()});
      }
    }
    if (stop && !told) {
      told = true;
      for (const auto& [job, process] : running) process.ask_to_stop();
      if (stopping) stopping(running.size());
    }
    bool any = false;
    for (auto entry = running.begin(); entry != running.end();) {
      const std::optional<Ending> ending = entry->second.ended();
      if (ending) ended(entry->first, *ending);
      any = any || ending;
      entry = ending ? running.erase(entry) : std::next(entry);
    }
    // Waiting for a process would not end with the signal that sets `stop`.
    if (!any && !running.empty()) std::this_thread::sleep_for(pause);
  }
}

}  // namespace dataset
