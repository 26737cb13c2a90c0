// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "fields.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "errors.hpp"
#include "text.hpp"

namespace runner {
namespace {

std::string to_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

void fail(const Place& place, const std::string& what) {
  throw FileError(place.path.string() + ":" + std::to_string(place.line) + ": " + what);
}

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 40;
  std::string shown = text.substr(0, longest);
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}

std::optional<double> parse_number(const std::string& text) {
  // What strtod takes besides: leading white space, hexadecimal numbers, nan(...) and inf.
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double to_number(const Place& place, const std::string& field, const std::string& text) {
  const std::optional<double> value = parse_number(text);
  if (!value) fail(place, field + " " + quoted(text) + " is not a number");
  return *value;
}

double in_range(const Place& place, const std::string& field, double value, Range range) {
  if (!(value >= range.least && value <= range.most))
    fail(place,
         field + " is " + to_text(value) + ", must be from " + to_text(range.least) + " to " + to_text(range.most));
  return value;
}

int to_whole(const Place& place, const std::string& field, double value, int least, int most) {
  const std::optional<int> result = to_whole(value, least, most);
  if (!result)
    fail(place, field + " is " + to_text(value) + ", must be a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most));
  return *result;
}

std::vector<Row> read_table(const std::filesystem::path& path, std::size_t columns) {
  std::vector<Row> rows;
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    const std::vector<std::string> fields = words(line);
    if (fields.empty()) continue;
    Row row{place.line, {}};
    for (const std::string& field : fields) {
      const std::optional<double> value = parse_number(field);
      if (!value) fail(place, quoted(field) + " is not a number");
      row.values.push_back(*value);
    }
    if (fields.size() != columns)
      fail(place, "has " + std::to_string(fields.size()) + " numbers, must have " + std::to_string(columns));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> read_columns(const std::filesystem::path& path, const std::vector<std::string>& names) {
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> header = words(lines.empty() ? "" : lines[0]);
  Place place{path, 1};
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) fail(place, "has no column '" + name + "'");
    columns.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  std::vector<Row> rows;
  for (std::size_t line = 1; line < lines.size(); ++line) {
    ++place.line;
    const std::vector<std::string> fields = words(lines[line]);
    if (fields.empty()) continue;
    Row row{place.line, {}};
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (columns[i] >= fields.size()) fail(place, "has no " + names[i]);
      const std::string& text = fields[columns[i]];
      row.values.push_back(text == "True" ? 1 : text == "False" ? 0 : to_number(place, names[i], text));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace runner
