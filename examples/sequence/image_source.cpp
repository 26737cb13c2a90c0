// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "image_source.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>

#include "entries.hpp"
#include "errors.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_image(const fs::path& path) {
  const std::string ending = lower(path.extension().string());
  for (const char* const known : {".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm", ".tif", ".tiff"})
    if (ending == known) return true;
  return false;
}

/// A pattern's parts before and after its number.
struct Pattern {
  std::string before, after;
  std::size_t least_digits = 1;
};

/// @param path for a message
Pattern parse_pattern(const fs::path& source, const fs::path& path) {
  const std::string name = source.filename().string();
  const std::size_t percent = name.find('%');
  std::size_t end = percent == std::string::npos ? percent : percent + 1;
  while (end < name.size() && is_digit(name[end])) ++end;
  const bool good = end < name.size() && name[end] == 'd' && name.find('%', end) == std::string::npos &&
                    end - percent < 4 && source.parent_path().string().find('%') == std::string::npos;
  if (!good) throw FileError(path.string() + ": a pattern must have one %d, or %06d or alike, in its last part");
  Pattern pattern{name.substr(0, percent), name.substr(end + 1)};
  if (end - percent > 1) pattern.least_digits = std::stoul(name.substr(percent + 1, end - percent - 1));
  return pattern;
}

/// The number in a name that the pattern prints.
std::optional<int> number_in(const std::string& name, const Pattern& pattern) {
  constexpr std::size_t most_digits = 9;
  const std::size_t around = pattern.before.size() + pattern.after.size();
  if (name.size() <= around || name.compare(0, pattern.before.size(), pattern.before) != 0 ||
      name.compare(name.size() - pattern.after.size(), std::string::npos, pattern.after) != 0)
    return std::nullopt;
  const std::string digits = name.substr(pattern.before.size(), name.size() - around);
  const bool padded = digits.size() > 1 && digits[0] == '0';
  if (!std::all_of(digits.begin(), digits.end(), is_digit) || digits.size() > most_digits ||
      digits.size() < pattern.least_digits || (padded && digits.size() != pattern.least_digits))
    return std::nullopt;
  return std::stoi(digits);
}

}  // namespace

bool is_pattern(const fs::path& name) { return name.string().find('%') != std::string::npos; }

bool natural_less(const std::string& a, const std::string& b) {
  // A number becomes its length and its digits: then texts compare as numbers do.
  const auto key = [](const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i;
      while (end < text.size() && is_digit(text[end])) ++end;
      if (end == i) {
        result += text[i++];
        continue;
      }
      while (i + 1 < end && text[i] == '0') ++i;
      const std::string digits = text.substr(i, end - i), length = std::to_string(digits.size());
      result += std::string(3 - std::min<std::size_t>(length.size(), 3), '0') + length + digits;
      i = end;
    }
    return result;
  };
  const std::string key_a = key(a), key_b = key(b);
  return key_a != key_b ? key_a < key_b : a < b;
}

ImageSource list_source(const fs::path& folder, const fs::path& name) {
  const fs::path source = (folder / name).lexically_normal();
  ImageSource result;
  if (!is_pattern(name)) {
    for (const fs::path& file : list_files(source))
      if (is_image(file)) result.files.push_back({file, std::nullopt});
    if (result.files.empty()) throw FileError(source.string() + ": holds no images");
    std::sort(result.files.begin(), result.files.end(), [](const auto& a, const auto& b) {
      return natural_less(a.path.filename().string(), b.path.filename().string());
    });
    return result;
  }
  const Pattern pattern = parse_pattern(name, source);
  result.numbered = true;
  for (const fs::path& file : list_files(source.has_parent_path() ? source.parent_path() : "."))
    if (const std::optional<int> number = number_in(file.filename().string(), pattern))
      result.files.push_back({file, number});
  if (result.files.empty()) throw FileError(source.string() + ": there are no such files");
  std::sort(result.files.begin(), result.files.end(),
            [](const auto& a, const auto& b) { return *a.number < *b.number; });
  return result;
}

}  // namespace runner
