// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "dot/image/image.hpp"
#include "dot/lie/se3.hpp"
#include "dot/pipeline/result.hpp"
#include "sequence/output_file.hpp"
#include "sequence/sequence.hpp"

namespace runner {

/// Where results go.
struct OutputOptions {
  std::filesystem::path out;
  std::filesystem::path masks_out;  ///< exclusion masks; empty: none
  bool overlay = false;             ///< pictures too
};

/// Writes the results of a sequence, frame by frame. A picture has its name when it is whole, the tables theirs when
/// all frames are done: a folder without timing.csv is of a run that did not end.
class ResultWriter {
 public:
  /// Makes the folders, removes what an earlier run has left there and starts the tables.
  /// @param sequence folder that is read, which must not be written to.
  /// @throws FileError naming what cannot be written, UsageError when that is the sequence.
  ResultWriter(const OutputOptions& options, const std::filesystem::path& sequence);

  /// @param total_ms time of the whole `track`.
  /// @throws FileError when a file cannot be written, std::runtime_error when the result does not fit the formats.
  void write(const SequenceFrame& frame, const dot::Result& result, double total_ms);

  /// After the last frame: the tables are complete.
  /// @throws FileError when a file cannot be written.
  void finish();

 private:
  void write_images(const SequenceFrame& frame, const dot::Result& result, double total_ms);
  void write_revised(const dot::Result& result);
  void write_masks(const SequenceFrame& frame, const dot::Result& result);

  OutputOptions options_;
  std::optional<OutputFile> camera_;
  std::optional<OutputFile> objects_;
  std::optional<OutputFile> revised_;  ///< made with its first line
  std::optional<OutputFile> timing_;
  dot::SE3d T_world_camera_;
  dot::Image<std::uint8_t> exclusion_;
};

}  // namespace runner
