// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Numbers in text files: the one conversion from text, the one from a number with a fraction to a whole one, and
/// errors that name the file and the line.

namespace runner {

/// Where something stands.
struct Place {
  const std::filesystem::path& path;
  int line = 0;  ///< from 1
};

/// @throws FileError "path:line: what".
[[noreturn]] void fail(const Place& place, const std::string& what);

/// Text for a message: in quotes, cut where it is long, with a ? for each character that does not print.
std::string quoted(const std::string& text);

/// A finite decimal number that takes up all of `text`.
std::optional<double> parse_number(const std::string& text);

/// `value` as a whole number from `least` to `most`.
template <typename T>
std::optional<T> to_whole(double value, T least, T most) {
  const bool fits = value >= static_cast<double>(least) && value <= static_cast<double>(most);
  if (!fits || value != std::floor(value)) return std::nullopt;
  return static_cast<T>(value);
}

/// What a number may be, the ends included.
struct Range {
  double least;
  double most;
};

/// @throws FileError naming place and field when `text` is not a number.
double to_number(const Place& place, const std::string& field, const std::string& text);

/// @return value.
/// @throws FileError naming place and field when it is out of range.
double in_range(const Place& place, const std::string& field, double value, Range range);

/// @throws FileError naming place and field when `value` is not a whole number in the range.
int to_whole(const Place& place, const std::string& field, double value, int least, int most);

/// A line of numbers.
struct Row {
  int line = 0;  ///< of the file, from 1
  std::vector<double> values;
};

/// A file of numbers, `columns` in each line that is not empty.
/// @throws FileError naming the line that is different.
std::vector<Row> read_table(const std::filesystem::path& path, std::size_t columns);

/// A table whose first line names its columns, separated by white space: the columns asked for, of all other lines.
/// True and False count as 1 and 0.
/// @throws FileError naming the column that is missing or the line that is wrong.
std::vector<Row> read_columns(const std::filesystem::path& path, const std::vector<std::string>& names);

}  // namespace runner
