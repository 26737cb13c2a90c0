// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dataset/record.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sequence/errors.hpp"
#include "support/recording_folder.hpp"

namespace dataset {
namespace {

const Record example{{"dot 0.1.0", "--mask-every 4", "sequence /data/a"}, {24, 2, 3, 1, 0, 5.25}};

TEST(Record, IsReadAsItWasWritten) {
  const RecordingFolder folder;
  EXPECT_FALSE(read_record(folder.path()));
  write_record(folder.path(), example);
  const std::optional<Record> read = read_record(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->asked, example.asked);
  EXPECT_EQ(read->figures.frames, 24);
  EXPECT_EQ(read->figures.moving, 2);
  EXPECT_EQ(read->figures.standing, 3);
  EXPECT_EQ(read->figures.undecided, 1);
  EXPECT_EQ(read->figures.camera_lost, 0);
  EXPECT_DOUBLE_EQ(read->figures.ms_per_frame, 5.25);
  remove_record(folder.path());
  EXPECT_FALSE(read_record(folder.path()));
  remove_record(folder.path());  // none is nothing to complain of
  remove_record(folder.path() / "no" / "such" / "folder");
}

TEST(Record, CutShortMarksNothingAsComplete) {
  const RecordingFolder folder;
  write_record(folder.path(), example);
  std::ifstream stream(folder.path() / record_name);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t figures = whole.rfind("figures");
  // The last field's digits apart: 5.2 is a number as well.
  for (std::size_t size = 0; size < whole.rfind(' ') + 1; ++size) {
    folder.text(record_name, whole.substr(0, size));
    EXPECT_FALSE(read_record(folder.path())) << whole.substr(0, size);
  }
  folder.text(record_name, whole.substr(0, figures) + "figures 24 2 3 1 0 5.25 7\n");
  EXPECT_FALSE(read_record(folder.path()));
  folder.text(record_name, whole.substr(0, figures) + "figures 24 -2 3 1 0 5.25\n");
  EXPECT_FALSE(read_record(folder.path()));
}

TEST(Record, DigestTellsContentsApart) {
  const RecordingFolder folder;
  folder.text("empty", "");
  folder.text("a", "a");
  folder.text("other", "foobar");
  // Published test vectors of FNV-1a.
  EXPECT_EQ(digest(folder.path() / "empty"), "cbf29ce484222325");
  EXPECT_EQ(digest(folder.path() / "a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digest(folder.path() / "other"), "85944171f73967e8");
  EXPECT_THROW(digest(folder.path() / "none"), runner::FileError);
  EXPECT_THROW(digest(folder.path()), runner::FileError);
}

}  // namespace
}  // namespace dataset
