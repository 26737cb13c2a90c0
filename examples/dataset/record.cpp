// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "record.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/output_file.hpp"
#include "sequence/text.hpp"

namespace dataset {
namespace fs = std::filesystem;

const char* const record_name = "complete.txt";

namespace {

const std::string figures_key = "figures ";

std::optional<Figures> parse_figures(const std::string& text) {
  const std::vector<std::string> fields = runner::words(text);
  Figures f;
  int* const whole[] = {&f.frames, &f.moving, &f.standing, &f.undecided, &f.camera_lost};
  if (fields.size() != std::size(whole) + 1) return std::nullopt;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::optional<double> number = runner::parse_number(fields[i]);
    if (!number) return std::nullopt;
    if (i == std::size(whole)) {
      f.ms_per_frame = *number;
    } else {
      const std::optional<int> value = runner::to_whole(*number, 0, std::numeric_limits<int>::max());
      if (!value) return std::nullopt;
      *whole[i] = *value;
    }
  }
  return f;
}

}  // namespace

std::optional<Record> read_record(const fs::path& folder) {
  std::ifstream stream(folder / record_name);
  Record record;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(figures_key, 0) != 0) {
      record.asked.push_back(line);
      continue;
    }
    // The last line: what is cut short has none.
    const std::optional<Figures> figures = parse_figures(line.substr(figures_key.size()));
    if (!figures) return std::nullopt;
    record.figures = *figures;
    return record;
  }
  return std::nullopt;
}

void write_record(const fs::path& folder, const Record& record) {
  runner::OutputFile file(folder / record_name);
  for (const std::string& line : record.asked) file.stream() << line << '\n';
  const Figures& f = record.figures;
  file.stream() << figures_key << f.frames << ' ' << f.moving << ' ' << f.standing << ' ' << f.undecided << ' '
                << f.camera_lost << ' ' << runner::format("%.3f", f.ms_per_frame) << '\n';
  file.finish();
}

void remove_record(const fs::path& folder) {
  std::error_code error;
  fs::remove(folder / record_name, error);
  if (error && error != std::errc::not_a_directory)
    throw runner::FileError((folder / record_name).string() + ": cannot be removed: " + error.message());
}

std::string digest(const fs::path& path) {
  std::uint64_t hash = 0xCBF29CE484222325;
  try {
    std::ifstream stream(path, std::ios::binary);
    stream.exceptions(std::ios::badbit);
    if (!stream) throw runner::FileError(path.string() + ": cannot be read");
    for (std::istreambuf_iterator<char> c(stream), end; c != end; ++c)
      hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001B3;
  } catch (const std::ios_base::failure&) {
    throw runner::FileError(path.string() + ": cannot be read");
  }
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace dataset
