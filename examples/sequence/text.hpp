// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runner {

/// Without white space at either end.
std::string trim(const std::string& text);

/// The trimmed pieces between separators. Nothing after the last separator is no piece.
std::vector<std::string> split(const std::string& text, char separator);

/// The pieces between runs of white space.
std::vector<std::string> words(const std::string& text);

/// The lines of a text file.
/// @throws FileError when it cannot be read, or is UTF-16.
std::vector<std::string> read_lines(const std::filesystem::path& path);

/// Drops the mark that editors on Windows put before a text in UTF-8. @param path of the text, for the message.
/// @throws FileError when the mark is that of UTF-16.
void drop_byte_order_mark(const std::filesystem::path& path, std::string& text);

/// A number by a pattern of printf.
std::string format(const char* pattern, double value);

/// Name of a frame's file, "000012.png".
std::string frame_name(int number, const char* extension = ".png");

}  // namespace runner
