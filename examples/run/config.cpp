// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "config.hpp"

#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>

#include "dot/pipeline/validate_options.hpp"
#include "sequence/depth_source.hpp"
#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/text.hpp"

namespace runner {
namespace {

enum class Outcome { Done, UnknownName, BadValue };

template <typename T>
Outcome assign(const std::string& text, T& value) {
  std::optional<T> parsed;
  const std::optional<double> number = parse_number(text);
  if constexpr (std::is_same_v<T, double>)
    parsed = number;
  else if (number)
    parsed = to_whole(*number, std::numeric_limits<T>::min(), std::numeric_limits<T>::max());
  if (std::is_same_v<T, bool> && (text == "true" || text == "false")) parsed = text == "true";
  if (!parsed) return Outcome::BadValue;
  value = *parsed;
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

/// Ranges are the library's business; to which line of the file its complaint belongs is ours.
void check_ranges(const std::filesystem::path& path, const std::map<std::string, int>& lines,
                  const dot::Options& options) {
  const std::string prefix = "options.";
  try {
    dot::validate(options);
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    if (message.rfind(prefix, 0) != 0) throw;
    const std::string complaint = message.substr(prefix.size());
    const auto found = lines.find(complaint.substr(0, complaint.find(':')));
    if (found == lines.end()) throw FileError(path.string() + ": " + complaint);
    fail({path, found->second}, complaint);
  }
}

}  // namespace

std::optional<dot::ClassifierKind> classifier_by_name(const std::string& name) {
  if (name == "velocity") return dot::ClassifierKind::Velocity;
  if (name == "entropy") return dot::ClassifierKind::Entropy;
  if (name == "entropy-literal") return dot::ClassifierKind::EntropyLiteral;
  return std::nullopt;
}

void read_config(const std::filesystem::path& path, dot::Options& options) {
  std::map<std::string, int> lines;  // of the settings
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    const std::string text = trim(line.substr(0, line.find('#')));
    if (text.empty()) continue;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) fail(place, quoted(text) + " is not of the form name = value");
    const std::string name = trim(text.substr(0, equals));
    const std::string value = trim(text.substr(equals + 1));
    const Outcome outcome = set_option(options, name, value);
    if (outcome == Outcome::UnknownName) fail(place, "unknown option " + quoted(name));
    if (outcome == Outcome::BadValue) fail(place, name + " cannot be " + quoted(value));
    const auto [before, is_new] = lines.emplace(name, place.line);
    if (!is_new) fail(place, name + " stands in line " + std::to_string(before->second) + " already");
  }
  check_ranges(path, lines, options);
}

}  // namespace runner
