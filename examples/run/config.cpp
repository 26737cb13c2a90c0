// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "config.hpp"

#include <limits>
#include <type_traits>

#include "sequence/depth_source.hpp"
#include "sequence/errors.hpp"
#include "sequence/text.hpp"

namespace runner {
namespace {

enum class Outcome { Done, UnknownName, BadValue };

template <typename T>
Outcome assign(const std::string& text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (text == "true") return value = true, Outcome::Done;
    if (text == "false") return value = false, Outcome::Done;
  }
  const std::optional<double> number = parse_number(text);
  if (!number) return Outcome::BadValue;
  if constexpr (std::is_integral_v<T>) {
    if (*number < std::numeric_limits<T>::min() || *number > std::numeric_limits<T>::max() ||
        *number != static_cast<double>(static_cast<T>(*number)))
      return Outcome::BadValue;
  }
  value = static_cast<T>(*number);
  return Outcome::Done;
}

template <typename T>
Outcome assign(const std::optional<T>& named, T& value) {
  if (!named) return Outcome::BadValue;
  value = *named;
  return Outcome::Done;
}

Outcome set_option(dot::Options& options, const std::string& name, const std::string& value) {
  if (name == "classifier") return assign(classifier_by_name(value), options.classifier);
  if (name == "depth_noise.source") return assign(depth_source_by_name(value), options.depth_noise.source);
  Outcome outcome = Outcome::UnknownName;
  dot::for_each_option(options, [&](const char* known, auto& field) {
    if (name == known) outcome = assign(value, field);
  });
  return outcome;
}

}  // namespace

std::optional<dot::ClassifierKind> classifier_by_name(const std::string& name) {
  if (name == "velocity") return dot::ClassifierKind::Velocity;
  if (name == "entropy") return dot::ClassifierKind::Entropy;
  if (name == "entropy-literal") return dot::ClassifierKind::EntropyLiteral;
  return std::nullopt;
}

void read_config(const std::filesystem::path& path, dot::Options& options) {
  int line_number = 0;
  for (const std::string& line : read_lines(path)) {
    ++line_number;
    const std::string text = trim(line.substr(0, line.find('#')));
    if (text.empty()) continue;
    const std::string where = path.string() + ": line " + std::to_string(line_number) + ": ";
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw FileError(where + "'" + text + "' is not of the form name = value");
    const std::string name = trim(text.substr(0, equals));
    const std::string value = trim(text.substr(equals + 1));
    const Outcome outcome = set_option(options, name, value);
    if (outcome == Outcome::UnknownName) throw FileError(where + "unknown option '" + name + "'");
    if (outcome == Outcome::BadValue) throw FileError(where + name + " cannot be '" + value + "'");
  }
}

}  // namespace runner
