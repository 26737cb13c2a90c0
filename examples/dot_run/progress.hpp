// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "dataset/record.hpp"
#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"

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
  explicit Summary(const SequenceOptions& source) : source_(source) {}

  void add(const SequenceFrame& frame, const dot::Result& result, double total_ms);

  dataset::Figures figures() const;

  /// Prints frames, how many of them had masks, objects by state, what was wrong with the depth, times and where the
  /// outputs lie.
  /// @param remarks further lines, after those of the masks.
  void print(const OutputPaths& output, const std::string& remarks) const;

 private:
  void print_masks() const;
  std::vector<double> steady_ms() const;
  void print_suspicions() const;

  SequenceOptions source_;
  int segmented_ = 0;                                 ///< frames
  std::map<std::uint32_t, dot::State> last_decided_;  ///< of each object that was ever shown
  std::vector<double> total_ms_;
  int camera_lost_ = 0;
  int revised_ = 0;                           ///< motions of the camera
  std::map<dot::Suspicion, int> suspicions_;  ///< frames with each
  std::map<dot::Suspicion, double> figures_;  ///< the last one of each
  double disparity_bias_px_ = 0;              ///< in the last frame
};

}  // namespace runner
