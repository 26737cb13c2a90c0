// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "video_input.hpp"

namespace runner {

bool is_video(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  for (const char* const known : {".mp4", ".mkv", ".avi", ".mov", ".m4v", ".webm", ".mpg"})
    if (ending == known) return true;
  return false;
}

}  // namespace runner
