// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "dot/pipeline/options.hpp"
#include "player/player.hpp"
#include "player/video_file.hpp"
#include "run/run_options.hpp"
#include "run/writer.hpp"
#include "sequence/sequence.hpp"

namespace runner {

/// What a run is to leave behind; an empty path: not that.
struct Outputs {
  OutputOptions results;
  std::filesystem::path video;   ///< of the overlay
  std::filesystem::path player;  ///< page to look at the run
};

/// Writes all outputs of a run, frame by frame.
class RunWriter {
 public:
  /// @throws FileError naming what cannot be written, UsageError when that is the sequence.
  RunWriter(const Outputs& outputs, const SequenceOptions& source, const Sequence& sequence,
            const dot::Options& options);

  /// @param total_ms time of the whole `track`.
  /// @throws FileError when a file cannot be written, std::runtime_error when the result does not fit the formats.
  void write(const SequenceFrame& frame, const dot::Result& result, double total_ms);

  /// After the last frame: the files are complete.
  /// @throws FileError when a file cannot be written.
  void finish();

 private:
  std::optional<ResultWriter> results_;
  std::optional<player::VideoFile> video_;
  std::optional<player::Player> player_;
};

}  // namespace runner
