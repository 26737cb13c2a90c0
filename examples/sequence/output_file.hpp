// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>

namespace runner {

/// A file that gets its name when it is complete. Until then it stands beside, under partial_name: whatever has the
/// name is whole, also after the program was killed.
class OutputFile {
 public:
  /// Makes an empty file.
  /// @throws FileError when it cannot be written, or is not to be replaced because it is a folder.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(OutputFile&&) = default;

  std::ostream& stream() { return stream_; }

  /// Hands over to the system what was written so far.
  /// @throws FileError when that fails.
  void flush();

  /// Gives the file its name, in the place of an older one.
  /// @throws FileError when that fails.
  void finish();

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

/// Where a file stands while it is not complete: "objects.csv.partial".
std::filesystem::path partial_name(const std::filesystem::path& path);

/// To be called at the end of a program.
/// @throws FileError when something of what it has printed on standard output was lost.
void finish_standard_output();

}  // namespace runner
