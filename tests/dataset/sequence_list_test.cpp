// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dataset/sequence_list.hpp"

#include <gtest/gtest.h>

#include "sequence/errors.hpp"
#include "support/recording_folder.hpp"

namespace dataset {
namespace {

std::string complaint(const std::filesystem::path& list) {
  try {
    read_list(list);
  } catch (const runner::FileError& error) {
    return error.what();
  }
  return {};
}

TEST(SequenceList, ALineIsAFolder) {
  const RecordingFolder folder;
  folder.text("list.txt", "# all of them\n/data/Scene01/clone\n\n  /data/with a space/x/  \r\n/data/Scene02/clone\n");
  const std::vector<Item> items = read_list(folder.path() / "list.txt");
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].name, "Scene01-clone");
  EXPECT_EQ(items[1].folder, "/data/with a space/x/");
  EXPECT_EQ(items[1].name, "x");
  EXPECT_EQ(items[2].name, "Scene02-clone");
}

TEST(SequenceList, WhatIsNoListIsRefused) {
  const RecordingFolder folder;
  folder.text("empty.txt", "# nothing\n\n");
  folder.text("twice.txt", "/data/a\n/data/b/../a\n");
  const std::string root = folder.path().string();
  EXPECT_EQ(complaint(root + "/empty.txt"), root + "/empty.txt: lists no sequence");
  EXPECT_EQ(complaint(root + "/twice.txt"), root + "/twice.txt: /data/a is given twice");
  EXPECT_THROW(read_list(folder.path() / "none.txt"), runner::FileError);
  EXPECT_THROW(read_list(folder.path()), runner::FileError);
}

TEST(Shard, EverySequenceIsInOnePart) {
  constexpr std::size_t sequences = 10;
  for (int count = 1; count <= 4; ++count) {
    for (std::size_t i = 0; i < sequences; ++i) {
      int parts = 0;
      for (int index = 1; index <= count; ++index) parts += Shard{index, count}.has(i);
      EXPECT_EQ(parts, 1) << "sequence " << i << " of " << count << " parts";
    }
  }
}

TEST(Shard, IsTwoNumbers) {
  const Shard shard = parse_shard("--shard", "2/8");
  EXPECT_EQ(shard.index, 2);
  EXPECT_EQ(shard.count, 8);
  for (const char* const wrong : {"0/8", "9/8", "1", "1/", "/8", "1/8/2", "a/b", "1.5/2", ""})
    EXPECT_THROW(parse_shard("--shard", wrong), runner::UsageError) << wrong;
}

}  // namespace
}  // namespace dataset
