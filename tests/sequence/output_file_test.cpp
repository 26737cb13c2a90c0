// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/output_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sequence/images.hpp"
#include "support/recording_folder.hpp"

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(OutputFile, HasItsNameWhenItIsComplete) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "table.csv";
  folder.text("table.csv", "old");
  runner::OutputFile file(path);
  file.stream() << "new";
  file.flush();
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(content(runner::partial_name(path)), "new");
  file.finish();
  EXPECT_EQ(content(path), "new");
  EXPECT_FALSE(fs::exists(runner::partial_name(path)));
}

TEST(OutputFile, OfARunThatEndsEarlyHasNone) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "table.csv";
  { runner::OutputFile(path).stream() << "half"; }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(content(runner::partial_name(path)), "half");
}

TEST(OutputFile, SaysWhatCannotBeWritten) {
  const RecordingFolder folder;
  EXPECT_THROW(runner::OutputFile(folder.path() / "none" / "table.csv"), runner::FileError);
  fs::create_directory(folder.path() / "folder");
  EXPECT_THROW(runner::OutputFile(folder.path() / "folder"), runner::FileError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing is left";
}

TEST(OutputFile, OnAFullDiskKeepsTheOldOne) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no device that is always full";
  const RecordingFolder folder;
  const fs::path path = folder.path() / "table.csv";
  folder.text("table.csv", "old");
  fs::create_symlink("/dev/full", runner::partial_name(path));
  runner::OutputFile file(path);
  file.stream() << "new";
  EXPECT_THROW(file.flush(), runner::FileError);
  EXPECT_THROW(file.finish(), runner::FileError);
  EXPECT_EQ(content(path), "old");
}

/// A second name of the old picture still shows it: its file was not opened again.
TEST(WriteImage, DoesNotWriteInPlace) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "000000.png", second_name = folder.path() / "second";
  runner::write_image(path, cv::Mat(4, 6, CV_8UC1, cv::Scalar(1)));
  const std::string old = content(path);
  fs::create_hard_link(path, second_name);
  runner::write_image(path, cv::Mat(8, 9, CV_8UC1, cv::Scalar(2)));
  EXPECT_EQ(content(second_name), old);
  EXPECT_EQ(runner::read_image(path).size(), cv::Size(9, 8));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2) << "nothing else is left";
}

}  // namespace
