// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace eval {

/// Says on standard error how far the runs are: one line that is rewritten on a terminal, else a line a finished run.
/// Any thread may call.
class Progress {
 public:
  explicit Progress(int runs);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param run 0 <= run < runs
  void frame(int run, const std::string& name, int done, int total);
  /// @param remark what came of it.
  void finished(int run, const std::string& name, const std::string& remark);

 private:
  void draw(const std::string& name);

  std::mutex mutex_;
  std::vector<double> shares_;
  int finished_ = 0;
  bool terminal_ = false;
  bool line_open_ = false;
};

}  // namespace eval
