// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence_list.hpp"

#include <optional>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/sequence_names.hpp"
#include "sequence/text.hpp"

namespace dataset {

Shard parse_shard(const std::string& option, const std::string& value) {
  constexpr int most = 1000000;
  const std::size_t slash = value.find('/');
  const auto whole = [](const std::string& text) {
    const std::optional<double> number = runner::parse_number(text);
    return number ? runner::to_whole(*number, 1, most) : std::nullopt;
  };
  std::optional<int> index, count;
  if (slash != std::string::npos) index = whole(value.substr(0, slash)), count = whole(value.substr(slash + 1));
  if (!index || !count || *index > *count)
    throw runner::UsageError(option + " needs I/N, as 1/8, with I from 1 to N, not '" + value + "'");
  return {*index, *count};
}

std::vector<Item> read_list(const std::filesystem::path& path) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& line : runner::read_lines(path)) {
    const std::string folder = runner::trim(line);
    if (!folder.empty() && folder[0] != '#') folders.emplace_back(folder);
  }
  if (folders.empty()) throw runner::FileError(path.string() + ": lists no sequence");
  std::vector<std::string> names;
  try {
    names = runner::sequence_names(folders);
  } catch (const runner::UsageError& error) {
    throw runner::FileError(path.string() + ": " + error.what());
  }
  std::vector<Item> items;
  for (std::size_t i = 0; i < folders.size(); ++i) items.push_back({folders[i], names[i]});
  return items;
}

}  // namespace dataset
