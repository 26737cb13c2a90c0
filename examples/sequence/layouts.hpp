// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// The recording in a folder, whatever its layout: the one place that tells the layouts apart.
/// @throws FileError naming the folder or file that is missing or wrong.
Recording open_recording(const SequenceOptions& options);

}  // namespace runner
