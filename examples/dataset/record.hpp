// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dataset {

/// What the run of one sequence comes to.
struct Figures {
  int frames = 0;
  int moving = 0;       ///< objects, as last decided
  int standing = 0;     ///< likewise
  int undecided = 0;    ///< objects that were never decided
  int camera_lost = 0;  ///< frames
  double ms_per_frame = 0;
};

/// What stands in a folder of results once they are complete: its being there marks them as such.
struct Record {
  std::vector<std::string> asked;  ///< the sequence, the settings and the program: equal ones give equal results
  Figures figures;
};

/// Name of the file in a folder of results.
extern const char* const record_name;

/// @return nothing where there is no record or it is damaged: the results do not count as complete.
std::optional<Record> read_record(const std::filesystem::path& folder);

/// @throws runner::FileError when it cannot be written.
void write_record(const std::filesystem::path& folder, const Record& record);

/// @throws runner::FileError when it is there and cannot be removed.
void remove_record(const std::filesystem::path& folder);

/// A number for the content of a file, so that another content is noticed (FNV-1a, 64 bits).
/// @throws runner::FileError when it cannot be read.
std::string digest(const std::filesystem::path& path);

}  // namespace dataset
