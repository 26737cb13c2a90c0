// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace dataset {

/// How a process ended.
struct Ending {
  bool good = false;
  std::string reason;  ///< in one line, where it is not good
};

/// A function that runs in a copy of this process. Whatever becomes of it, this process goes on; when this process
/// ends, so does the copy (on Linux, however it ends). To be started while there is one thread alone.
class ChildProcess {
 public:
  /// @param work what it throws is the reason of a bad ending.
  /// @throws std::runtime_error when the system gives no process.
  explicit ChildProcess(const std::function<void()>& work);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  /// Kills it and waits, if it still runs.
  ~ChildProcess();

  /// Nothing while it runs; to be asked until it tells the ending.
  std::optional<Ending> ended();

  /// Sends SIGTERM.
  void ask_to_stop() const;

 private:
  pid_t pid_ = 0;       ///< 0: has ended
  int reason_in_ = -1;  ///< what the copy says of its ending
};

/// Output of this process, standard and of errors, goes to a file to which no other process writes.
/// @param patience for one that is about to end.
/// @throws runner::FileError when the file cannot be written, or another process keeps it.
void write_output_to(const std::string& path, std::chrono::milliseconds patience = std::chrono::seconds(5));

/// Keeps a file of write_output_to, if there is one, from other processes until this one ends.
/// @throws runner::FileError when another process keeps it.
void keep_output_file(const std::string& path, std::chrono::milliseconds patience = std::chrono::seconds(5));

}  // namespace dataset
