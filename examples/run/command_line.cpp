// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <cstddef>
#include <optional>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"

namespace runner {

void CommandLine::flag(const std::string& name, bool& value) { flags_[name] = &value; }

std::map<std::string, std::string> CommandLine::parse(int count, const char* const* values,
                                                      const std::function<void(const std::string&)>& positional) const {
  std::map<std::string, std::string> given;
  const auto set = [&](const Setter& setter, const std::string& name, const std::string& value) {
    setter(name, value);
    given[name] = value;
  };
  for (int i = 1; i < count; ++i) {
    const std::string argument = values[i];
    const std::size_t equals = argument.rfind("--", 0) == 0 ? argument.find('=') : std::string::npos;
    const std::string name = argument.substr(0, equals);
    if (const auto flag = flags_.find(argument); flag != flags_.end()) {
      *flag->second = true;
      given[argument] = "";
    } else if (const auto option = options_.find(name); option != options_.end()) {
      if (equals == std::string::npos && i + 1 == count) throw UsageError(name + " needs a value");
      set(option->second, name, equals == std::string::npos ? values[++i] : argument.substr(equals + 1));
    } else if (const auto optional = optional_.find(name); optional != optional_.end()) {
      const bool follows = equals == std::string::npos && i + 1 < count && parse_number(values[i + 1]);
      set(optional->second, name,
          equals != std::string::npos ? argument.substr(equals + 1)
          : follows                   ? values[++i]
                                      : "");
    } else if (argument.rfind('-', 0) == 0) {
      throw UsageError("unknown option '" + argument + "'");
    } else {
      positional(argument);
    }
  }
  return given;
}

int whole_number(const std::string& option, const std::string& value, int least, int most) {
  const std::optional<double> number = parse_number(value);
  const std::optional<int> whole = number ? to_whole(*number, least, most) : std::nullopt;
  if (!whole)
    throw UsageError(option + " needs a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                     ", not '" + value + "'");
  return *whole;
}

std::string not_empty(const std::string& option, const std::string& value) {
  if (value.empty()) throw UsageError(option + " needs a name");
  return value;
}

}  // namespace runner
