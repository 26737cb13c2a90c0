// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/sequence_names.hpp"

#include <gtest/gtest.h>

#include "sequence/errors.hpp"

namespace {

using Names = std::vector<std::string>;

TEST(SequenceNames, AreThoseOfTheFolders) {
  EXPECT_EQ(runner::sequence_names({"/data/a", "/data/b/", "/data/c/."}), (Names{"a", "b", "c"}));
}

TEST(SequenceNames, FoldersOfOneNameAreToldApartByThoseAbove) {
  EXPECT_EQ(runner::sequence_names({"/data/Scene01/clone", "/data/Scene02/clone", "/data/Scene02/rain"}),
            (Names{"Scene01-clone", "Scene02-clone", "rain"}));
  EXPECT_EQ(runner::sequence_names({"/one/x/clone", "/two/x/clone"}), (Names{"one-x-clone", "two-x-clone"}));
}

TEST(SequenceNames, OneWithoutFoldersAboveKeepsItsName) {
  EXPECT_EQ(runner::sequence_names({"/data", "/mnt/data"}), (Names{"data", "mnt-data"}));
  EXPECT_EQ(runner::sequence_names({"/mnt/data", "/data/", "/old/mnt/data"}),
            (Names{"mnt-data", "data", "old-mnt-data"}));
  EXPECT_THROW(runner::sequence_names({"/a/b", "/c/b", "/a-b"}), runner::UsageError) << "two would be a-b";
}

TEST(SequenceNames, TheSameFolderTwiceIsAnError) {
  EXPECT_THROW(runner::sequence_names({"/data/a", "/data/b/../a"}), runner::UsageError);
}

}  // namespace
