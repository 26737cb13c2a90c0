// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "instance_list.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "plausible.hpp"
#include "text.hpp"

namespace runner {

std::vector<dot::Instance> read_instances(const std::filesystem::path& path,
                                          const std::vector<std::string>& always_dynamic) {
  constexpr Range scores{-1e6, 1e6};
  std::vector<dot::Instance> instances;
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    const std::vector<std::string> fields = split(line, ',');
    if (trim(line).empty() || (place.line == 1 && fields[0] == "id")) continue;
    if (fields.size() < 2) fail(place, "must be id,class,score");
    dot::Instance instance;
    instance.id = static_cast<std::uint32_t>(to_whole(place, "id", to_number(place, "id", fields[0]), 1, largest_id));
    // A class may be a number or a name; the library takes numbers and does not interpret them.
    const std::int32_t largest_class = std::numeric_limits<std::int32_t>::max();
    if (const std::optional<double> number = parse_number(fields[1]))
      instance.class_id = to_whole(place, "class", *number, -largest_class, largest_class);
    if (fields.size() > 2)
      instance.score = static_cast<float>(in_range(place, "score", to_number(place, "score", fields[2]), scores));
    instance.always_dynamic =
        std::find(always_dynamic.begin(), always_dynamic.end(), fields[1]) != always_dynamic.end();
    instances.push_back(instance);
  }
  return instances;
}

}  // namespace runner
