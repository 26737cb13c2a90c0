// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace runner {

/// Images in their order: those of a folder, sorted by their names, in which numbers count as such; or the files of a
/// pattern of printf's, as `left/%04d.png`, sorted by the number.
struct ImageSource {
  struct File {
    std::filesystem::path path;
    std::optional<int> number;  ///< of the pattern
  };
  std::vector<File> files;
  bool numbered = false;
};

/// @param name of a folder or a pattern in `folder`, whose own name may have a % that means nothing.
/// @throws FileError when there are none, two have one number, or the pattern is none.
ImageSource list_source(const std::filesystem::path& folder, const std::filesystem::path& name);

/// Whether a name is a pattern: it has a %.
bool is_pattern(const std::filesystem::path& name);

/// Whether a comes before b, numbers in them taken as such: "2.png" before "10.png".
bool natural_less(const std::string& a, const std::string& b);

}  // namespace runner
