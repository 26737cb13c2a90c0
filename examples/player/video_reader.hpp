// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sequence/video_input.hpp"

namespace player {

/// Opens a video by OpenCV's videoio, and goes through it once to know its frames and their times.
/// @throws runner::FileError when it cannot be read, has no frames, or the program was built without videoio.
std::unique_ptr<runner::VideoInput> open_video(const std::filesystem::path& path);

}  // namespace player
