// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "layouts.hpp"

#include "errors.hpp"
#include "own_layout.hpp"

namespace runner {

Recording open_recording(const SequenceOptions& options) {
  if (!std::filesystem::is_directory(options.folder)) throw FileError(options.folder.string() + ": no such folder");
  // Last, and without a question: its messages say what a folder that is nothing else lacks.
  return read_own_layout(options);
}

}  // namespace runner
