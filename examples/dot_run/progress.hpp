// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "dot/pipeline/result.hpp"
#include "run/writer.hpp"

namespace runner {

/// Says on standard output how far the run is: one line that is rewritten on a terminal, else a line now and then.
class Progress {
 public:
  explicit Progress(int frames);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// After each frame.
  void show(int done, const dot::Result& result, double total_ms);

 private:
  int frames_ = 0;
  bool terminal_ = false;
  bool line_open_ = false;
};

/// What a run comes to.
class Summary {
 public:
  void add(const dot::Result& result, double total_ms);

  /// Prints frames, objects by state, what was wrong with the depth, times and where the outputs lie.
  void print(const OutputOptions& output) const;

 private:
  std::map<std::uint32_t, dot::State> last_decided_;  ///< of each object that was ever shown
  std::vector<double> total_ms_;
  int camera_lost_ = 0;
  double disparity_bias_px_ = 0;  ///< in the last frame
};

}  // namespace runner
