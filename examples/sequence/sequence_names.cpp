// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence_names.hpp"

#include <cstddef>
#include <map>

#include "errors.hpp"

namespace runner {

std::vector<std::string> sequence_names(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names(folders.size());
  std::vector<std::filesystem::path> rest;
  for (const std::filesystem::path& folder : folders) {
    rest.push_back(std::filesystem::absolute(folder).lexically_normal());
    if (!rest.back().has_filename()) rest.back() = rest.back().parent_path();
  }
  std::vector<bool> unclear(folders.size(), true);
  for (bool any = !folders.empty(); any;) {
    std::map<std::string, int> count;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (unclear[i]) {
        if (!rest[i].has_filename()) throw UsageError(folders[i].string() + " is given twice");
        names[i] = rest[i].filename().string() + (names[i].empty() ? "" : "-" + names[i]);
        rest[i] = rest[i].parent_path();
      }
      ++count[names[i]];
    }
    any = false;
    for (std::size_t i = 0; i < names.size(); ++i) any = (unclear[i] = count[names[i]] > 1) || any;
  }
  return names;
}

}  // namespace runner
