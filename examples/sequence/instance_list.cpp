// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "instance_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "errors.hpp"
#include "text.hpp"

namespace runner {

std::vector<dot::Instance> read_instances(const std::filesystem::path& path,
                                          const std::vector<std::string>& always_dynamic) {
  std::vector<dot::Instance> instances;
  int line_number = 0;
  for (const std::string& line : read_lines(path)) {
    ++line_number;
    const std::vector<std::string> fields = split(line, ',');
    if (trim(line).empty() || (line_number == 1 && fields[0] == "id")) continue;
    const std::string where = path.string() + ": line " + std::to_string(line_number);
    if (fields.size() < 2) throw FileError(where + " must be id,class,score");
    dot::Instance instance;
    const std::optional<double> id = parse_number(fields[0]);
    if (!id || *id < 1 || *id > 65535 || *id != static_cast<std::uint32_t>(*id))
      throw FileError(where + ": id '" + fields[0] + "' is not a whole number from 1 to 65535");
    instance.id = static_cast<std::uint32_t>(*id);
    // A class may be a number or a name; the library takes numbers and does not interpret them.
    if (const std::optional<double> number = parse_number(fields[1]); number && std::abs(*number) < 1e9)
      instance.class_id = static_cast<std::int32_t>(*number);
    if (fields.size() > 2) {
      const std::optional<double> score = parse_number(fields[2]);
      if (!score) throw FileError(where + ": score '" + fields[2] + "' is not a number");
      instance.score = static_cast<float>(*score);
    }
    instance.always_dynamic =
        std::find(always_dynamic.begin(), always_dynamic.end(), fields[1]) != always_dynamic.end();
    instances.push_back(instance);
  }
  return instances;
}

}  // namespace runner
