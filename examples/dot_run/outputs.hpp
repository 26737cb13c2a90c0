// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "player/overlay_video.hpp"
#include "player/player.hpp"
#include "progress.hpp"
#include "run/writer.hpp"
#include "sequence/sequence.hpp"

namespace runner {

/// All that is made of the results of a run, frame by frame: files, and what is said on standard output.
class Outputs {
 public:
  /// @param class_names of the network, by Instance::class_id; may be empty.
  /// @throws FileError naming what cannot be written, UsageError when that is the sequence.
  Outputs(const Arguments& arguments, const Sequence& sequence, const dot::Options& options,
          const std::vector<std::string>& class_names);

  /// The next frame; frames may be left out.
  /// @param total_ms time of the whole `track`.
  /// @throws FileError when a file cannot be written, std::runtime_error when the result does not fit the formats.
  void add(const SequenceFrame& frame, const dot::Result& result, double total_ms);

  /// After the last frame.
  /// @param complete whether all frames are done: otherwise the tables keep their names of incomplete ones, and there
  /// is neither page nor video.
  /// @param remarks further lines for the summary.
  /// @throws FileError when a file cannot be written.
  dataset::Figures finish(bool complete, const std::string& remarks);

 private:
  OutputPaths paths_;
  std::optional<ResultWriter> results_;
  std::optional<player::OverlayVideo> video_;
  std::optional<player::Player> player_;
  Summary summary_;
  std::optional<Progress> progress_;  ///< the last line but the summary
  int done_ = 0;                      ///< frames
};

}  // namespace runner
