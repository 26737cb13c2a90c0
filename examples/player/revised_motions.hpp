// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "dot/pipeline/result.hpp"

namespace player {

/// An earlier motion of the camera that a later frame proved to be wrong.
struct RevisedMotion {
  std::uint64_t frame_id = 0;  ///< of the frame that it led to
  double metres = 0;           ///< by which its translation was wrong
};

/// Compares the revisions of each result with what the earlier results said.
class RevisedMotions {
 public:
  /// @param result of the next frame. @return its revisions, the oldest first, of frames that were handed in.
  std::vector<RevisedMotion> next(const dot::Result& result);

 private:
  static constexpr std::size_t kept = 64;  ///< frames; revisions go back by a few

  struct Motion {
    std::uint64_t frame_id = 0;
    std::array<double, 12> T_cur_prev{};
  };

  std::deque<Motion> motions_;
};

}  // namespace player
