// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dot/camera/intrinsics.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "moved_outlines.hpp"
#include "point_finder.hpp"
#include "revised_motions.hpp"
#include "sequence/output_file.hpp"
#include "sequence/sequence.hpp"

namespace player {

/// What the page says of the whole run.
struct RunInfo {
  std::string sequence;  ///< name to show
  dot::Intrinsics camera;
  dot::Options options;
  std::vector<std::string> class_names = {};  ///< by ObjectResult::class_id; may be empty
};

/// One self-contained page to look at a run: its frames, what was found in them, and why. It loads nothing from
/// elsewhere. A frame is written when it is added, so that memory does not grow with the run; the page has its name
/// when it is finished, and else leaves nothing.
class Player {
 public:
  /// @throws FileError when the page cannot be written.
  Player(std::filesystem::path path, const RunInfo& info);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// The next frame. Pictures wider than 1280 px are made smaller.
  /// @param total_ms time of `track`.
  /// @throws FileError when the page cannot be written.
  void add(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms);

  /// @throws FileError when the page cannot be written.
  void finish();

 private:
  void copy_template_to(std::string_view marker);

  std::filesystem::path path_;
  dot::Options options_;
  runner::OutputFile file_;
  MovedOutlines moved_outlines_;
  PointFinder point_finder_;
  RevisedMotions revised_motions_;
  std::string_view rest_;  ///< of player.html
  bool finished_ = false;
};

}  // namespace player
