// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "errors.hpp"

namespace runner {
namespace {

const char* const white = " \t\r\n\v\f";

}  // namespace

std::string trim(const std::string& text) {
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
  for (std::size_t end = 0, begin = 0; (begin = text.find_first_not_of(white, end)) != std::string::npos;) {
    end = std::min(text.find_first_of(white, begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
  }
  return pieces;
}

std::vector<std::string> read_lines(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  // A folder opens, but reading it fails.
  if (!stream.eof()) throw FileError(path.string() + ": cannot be read");
  if (!lines.empty()) drop_byte_order_mark(path, lines.front());
  return lines;
}

void drop_byte_order_mark(const std::filesystem::path& path, std::string& text) {
  const auto begins_with = [&](const char* bytes) { return text.rfind(bytes, 0) == 0; };
  if (begins_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (begins_with("\xFF\xFE") || begins_with("\xFE\xFF"))
    throw FileError(path.string() + ": is UTF-16, must be ASCII or UTF-8");
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string frame_name(int number, const char* extension) {
  char text[32];
  std::snprintf(text, sizeof text, "%06d%s", number, extension);
  return text;
}

}  // namespace runner
