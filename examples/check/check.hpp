// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "finding.hpp"
#include "sequence/recording.hpp"

namespace check {

/// What a look at a recording has found.
struct Report {
  std::string folder;
  std::size_t frames = 0;  ///< of the recording
  std::size_t looked_at = 0;
  Findings findings;  ///< one of each kind, faults first
  std::size_t count(Verdict verdict) const;
  std::size_t faults() const { return count(Verdict::Fault); }
};

/// Looks at a recording: whether its images, depth, masks and times are such that the tracker can work with them.
/// @throws FileError naming a file that cannot be read.
Report check_recording(const runner::SequenceOptions& options);

}  // namespace check
