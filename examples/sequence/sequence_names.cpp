// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence_names.hpp"

#include <cstddef>
#include <map>

#include "errors.hpp"

namespace runner {

std::vector<std::string> sequence_names(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  std::vector<std::filesystem::path> rest;
  std::map<std::filesystem::path, std::filesystem::path> given;
  for (const std::filesystem::path& folder : folders) {
    std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    const auto [first, is_new] = given.try_emplace(path, folder);
    if (!is_new) throw UsageError(first->second.string() + " is given twice");
    names.push_back(path.filename().string());
    rest.push_back(path.parent_path());
  }
  std::map<std::string, int> count;
  for (bool any = true; any;) {
    any = false;
    count.clear();
    for (const std::string& name : names) ++count[name];
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (count.at(names[i]) == 1 || !rest[i].has_filename()) continue;  // the latter has no more to tell
      names[i] = rest[i].filename().string() + "-" + names[i];
      rest[i] = rest[i].parent_path();
      any = true;
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i)  // as /a/b and /a-b, if there is another b
    if (count.at(names[i]) > 1) throw UsageError(folders[i].string() + " has the name of another one, " + names[i]);
  return names;
}

}  // namespace runner
