// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>

namespace runner {

/// A command line: flags, options with a value (`--name value` or `--name=value`) and other arguments.
class CommandLine {
 public:
  using Setter = std::function<void(const std::string& option, const std::string& value)>;

  void flag(const std::string& name, bool& value);
  void option(const std::string& name, Setter setter) { options_[name] = std::move(setter); }

  /// An option whose value, a number, may be left out: `--name`, `--name 10` or `--name=10`; the setter then gets "".
  void optional_number(const std::string& name, Setter setter) { optional_[name] = std::move(setter); }

  /// @param positional called with each argument that is no option.
  /// @return the options that were given, with their last value; flags with none.
  /// @throws UsageError naming the option that is unknown or lacks its value; what the setters throw.
  std::map<std::string, std::string> parse(int count, const char* const* values,
                                           const std::function<void(const std::string&)>& positional) const;

 private:
  std::map<std::string, bool*> flags_;
  std::map<std::string, Setter> options_;
  std::map<std::string, Setter> optional_;
};

/// A whole number from `least` to `most`.
/// @throws UsageError naming the option.
int whole_number(const std::string& option, const std::string& value, int least = 1, int most = 1000000);

/// @throws UsageError naming the option when there is no value.
std::string not_empty(const std::string& option, const std::string& value);

}  // namespace runner
