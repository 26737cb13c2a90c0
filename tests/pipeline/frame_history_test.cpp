// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/pipeline/frame_history.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <vector>

namespace {

struct Past {
  double time = 0;
  std::vector<char> buffer;
  double timestamp() const { return time; }
};
using History = dot::FrameHistory<Past>;

std::vector<double> times(History& history) {
  std::vector<double> out;
  for (const Past& p : history) out.push_back(p.time);
  return out;
}

TEST(FrameHistory, DropsTheOldest) {
  History history;
  for (int i = 0; i < 4; ++i) history.add().time = i;
  EXPECT_EQ(times(history), (std::vector<double>{0, 1, 2, 3}));
  history.drop_before(2, 10);
  EXPECT_EQ(times(history), (std::vector<double>{2, 3}));
  history.clear();
  EXPECT_EQ(times(history), std::vector<double>{});
}

TEST(FrameHistory, KeepsNoMoreThanItMay) {
  History history;
  for (int i = 0; i < 6; ++i) history.add().time = i;
  history.drop_before(0, 4);
  EXPECT_EQ(times(history), (std::vector<double>{2, 3, 4, 5}));
}

TEST(FrameHistory, DropsUpToAFrameWhateverTheClockResolves) {
  // Of a Unix clock a double tells 0.24 us: a sum with 1 ns is the number itself.
  const double unix_time = 1.7e9;
  ASSERT_EQ(unix_time + 1e-9, unix_time);
  History history;
  for (int i = 0; i < 4; ++i) history.add().time = unix_time + i;
  const Past& second = *std::next(history.begin());
  history.drop_through(second);
  EXPECT_EQ(times(history), (std::vector<double>{unix_time + 2, unix_time + 3}));
  history.drop_through(*std::next(history.begin()));
  EXPECT_TRUE(history.empty());
}

TEST(FrameHistory, UsesItsMemoryAgain) {
  History history;
  std::set<const char*> seen;
  for (int i = 0; i < 20; ++i) {
    history.drop_before(i - 2, 10);
    Past& p = history.add();
    p.time = i;
    p.buffer.resize(1000);
    seen.insert(p.buffer.data());
  }
  EXPECT_EQ(seen.size(), 3u);
}

}  // namespace
