// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// Images, depth or a second eye, and a camera under whatever names the options give, in a folder or as a video each.
/// docs/recordings.md has the rules by which they belong together.
/// @throws FileError naming the file.
Recording read_named_layout(const SequenceOptions& options);

}  // namespace runner
