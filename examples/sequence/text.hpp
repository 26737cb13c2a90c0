// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace runner {

/// Without white space at either end.
std::string trim(const std::string& text);

/// The trimmed pieces between separators.
std::vector<std::string> split(const std::string& text, char separator);

/// The pieces between runs of white space.
std::vector<std::string> words(const std::string& text);

/// A finite number that takes up all of `text`.
std::optional<double> parse_number(const std::string& text);

/// The lines of a text file.
/// @throws FileError when it cannot be read.
std::vector<std::string> read_lines(const std::filesystem::path& path);

/// A file of numbers, `columns` in each line that is not empty.
/// @throws FileError naming the line that is different.
std::vector<std::vector<double>> read_table(const std::filesystem::path& path, std::size_t columns);

/// A table whose first line names its columns, separated by white space: the columns asked for, of all other lines.
/// True and False count as 1 and 0.
/// @throws FileError naming the column that is missing or the line that is wrong.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& path, const std::vector<std::string>& names);

/// Name of a frame's file, "000012.png".
std::string frame_name(int number, const char* extension = ".png");

}  // namespace runner
