// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "output_file.hpp"

#include <cstdio>
#include <system_error>
#include <utility>

#include "errors.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const fs::path& path) { throw FileError(path.string() + ": cannot be written"); }

}  // namespace

fs::path partial_name(const fs::path& path) { return fs::path(path) += ".partial"; }

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  if (!fs::is_directory(path_, error)) stream_.open(partial_name(path_), std::ios::binary);
  if (!stream_.is_open()) cannot_write(path_);
}

void OutputFile::flush() {
  if (!stream_.flush()) cannot_write(path_);
}

void OutputFile::finish() {
  stream_.close();
  std::error_code error;
  if (stream_) fs::rename(partial_name(path_), path_, error);
  if (!stream_ || error) cannot_write(path_);
}

void finish_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) cannot_write("standard output");
}

}  // namespace runner
