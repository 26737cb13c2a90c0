// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "errors.hpp"

namespace runner {

std::string trim(const std::string& text) {
  const char* const white = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(white);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);) pieces.push_back(trim(piece));
  return pieces;
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; stream >> piece;) pieces.push_back(piece);
  return pieces;
}

std::optional<double> parse_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string> read_lines(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  // A folder opens, but reading it fails.
  if (!stream.eof()) throw FileError(path.string() + ": cannot be read");
  return lines;
}

std::vector<std::vector<double>> read_table(const std::filesystem::path& path, std::size_t columns) {
  std::vector<std::vector<double>> rows;
  int line_number = 0;
  for (const std::string& line : read_lines(path)) {
    ++line_number;
    std::vector<double> row;
    for (const std::string& word : words(line)) {
      const std::optional<double> number = parse_number(word);
      if (!number)
        throw FileError(path.string() + ": line " + std::to_string(line_number) + ": '" + word + "' is not a number");
      row.push_back(*number);
    }
    if (row.empty()) continue;
    if (row.size() != columns)
      throw FileError(path.string() + ": line " + std::to_string(line_number) + " has " + std::to_string(row.size()) +
                      " numbers, must have " + std::to_string(columns));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names) {
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> header = words(lines.empty() ? "" : lines[0]);
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) throw FileError(path.string() + ": line 1 has no column '" + name + "'");
    columns.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  std::vector<std::vector<double>> rows;
  for (std::size_t line = 1; line < lines.size(); ++line) {
    const std::vector<std::string> fields = words(lines[line]);
    if (fields.empty()) continue;
    std::vector<double> row;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string text = columns[i] < fields.size() ? fields[columns[i]] : "";
      const std::optional<double> number = text == "True" ? 1 : text == "False" ? 0 : parse_number(text);
      if (!number)
        throw FileError(path.string() + ": line " + std::to_string(line + 1) + ": " + names[i] + " '" + text +
                        "' is not a number");
      row.push_back(*number);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string frame_name(int number, const char* extension) {
  char text[32];
  std::snprintf(text, sizeof text, "%06d%s", number, extension);
  return text;
}

}  // namespace runner
