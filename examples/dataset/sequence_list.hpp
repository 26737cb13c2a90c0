// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dataset {

/// One sequence of a data set.
struct Item {
  std::filesystem::path folder;  ///< as the list has it
  std::string name;              ///< of its folder of results; each different
};

/// The part of a data set that one of several machines does: every `count`-th sequence, from the `index`-th on.
struct Shard {
  int index = 1;  ///< from 1
  int count = 1;
  bool has(std::size_t sequence) const {
    return static_cast<int>(sequence % static_cast<std::size_t>(count)) == index - 1;
  }
};

/// "2/8".
/// @throws runner::UsageError naming the option.
Shard parse_shard(const std::string& option, const std::string& value);

/// The sequences that a file lists, a folder a line; empty lines and those that begin with # do not count. Paths are
/// relative to the current folder, as on a command line.
/// @throws runner::FileError when the file cannot be read, lists nothing, or lists a folder twice.
std::vector<Item> read_list(const std::filesystem::path& path);

}  // namespace dataset
