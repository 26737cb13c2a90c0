// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "old_results.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "dataset/record.hpp"
#include "sequence/entries.hpp"
#include "sequence/errors.hpp"
#include "sequence/output_file.hpp"
#include "sequence/text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

/// Whether a file is named 000012.png, or so while it is being written.
bool is_picture(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const fs::path ending = name.substr(digits);
  return digits >= 6 && (ending == ".png" || ending == partial_name(".png")) &&
         !fs::is_directory(fs::symlink_status(path));
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder)) files = list_files(folder);
  files.erase(std::remove_if(files.begin(), files.end(), [](const fs::path& file) { return !is_picture(file); }),
              files.end());
  return files;
}

[[noreturn]] void cannot_remove(const fs::path& path, const std::error_code& error) {
  throw FileError(path.string() + ": is of an earlier run and cannot be removed: " + error.message());
}

void remove_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(path, error))) fs::remove(path, error);
  if (error) cannot_remove(path, error);
}

void remove_pictures(const fs::path& folder) {
  const std::vector<fs::path> pictures = pictures_in(folder);
  for (const fs::path& picture : pictures) remove_file(picture);
  std::error_code not_empty;
  if (!pictures.empty()) fs::remove(folder, not_empty);
}

/// A complete table of times. While it grows it has a name that nobody else gives.
bool is_times(const fs::path& path) {
  std::ifstream stream(path);
  std::string header;
  const std::string begin = "frame,", end = ",total_ms";
  return std::getline(stream, header) && header.size() > begin.size() + end.size() && header.rfind(begin, 0) == 0 &&
         header.compare(header.size() - end.size(), end.size(), end) == 0;
}

/// @throws FileError naming the first file that an earlier run would have left, if there is one.
void refuse_others(const fs::path& out) {
  std::vector<fs::path> files;
  for (const char* const table : ResultNames::tables) files.push_back(out / table);
  for (const char* const folder : ResultNames::pictures)
    for (const fs::path& picture : pictures_in(out / folder)) files.push_back(picture);
  for (const fs::path& file : files)
    if (is_there(file))
      throw FileError(file.string() + ": is in the way, and is not of an earlier run; choose another folder");
}

}  // namespace

void remove_old_results(const fs::path& out) {
  const fs::path timing = out / ResultNames::timing;
  const bool is_earlier_run = is_times(timing) || is_there(partial_name(timing));
  if (!is_earlier_run) refuse_others(out);
  // First of all the old results stop being complete; when the program ends below, the next run goes on from here.
  if (dataset::read_record(out)) dataset::remove_record(out);
  if (!is_earlier_run) return;
  if (is_there(timing)) {
    std::error_code error;
    fs::rename(timing, partial_name(timing), error);
    if (error) cannot_remove(timing, error);
  }
  for (const char* const name : ResultNames::tables) {
    remove_file(out / name);
    if (name != ResultNames::timing) remove_file(partial_name(out / name));
  }
  for (const char* const folder : ResultNames::pictures) remove_pictures(out / folder);
  remove_old_masks(out);
}

void remove_old_masks(const fs::path& masks_out) {
  for (const char* const folder : ResultNames::masks) remove_pictures(masks_out / folder);
}

}  // namespace runner
