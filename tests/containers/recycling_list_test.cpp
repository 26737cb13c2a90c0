// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/containers/recycling_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <utility>
#include <vector>

namespace {

using dot::RecyclingList;

struct Item {
  int value = 0;
  std::vector<char> buffer;
};

std::vector<int> values(const RecyclingList<Item>& list) {
  std::vector<int> out;
  for (const Item& item : list) out.push_back(item.value);
  return out;
}

TEST(RecyclingList, IsAListLikeAnyOther) {
  std::mt19937 random(1);
  RecyclingList<Item> list;
  std::deque<int> expected;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t place = random() % (expected.size() + 1);
    switch (random() % 8) {
      case 0:
      case 1:
        list.push_front().value = i;
        expected.push_front(i);
        break;
      case 2:
      case 3:
        list.push_back().value = i;
        expected.push_back(i);
        break;
      case 4:
        list.insert(place).value = i;
        expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(place), i);
        break;
      case 5:
        if (expected.empty()) break;
        list.pop_front();
        expected.pop_front();
        break;
      case 6:
        if (expected.empty()) break;
        list.pop_back();
        expected.pop_back();
        break;
      default:
        if (random() % 20 == 0) {
          list.clear();
          expected.clear();
        } else {
          const auto odd = [](int value) { return value % 7 == 1; };
          list.drop_if([&](const Item& item) { return odd(item.value); });
          expected.erase(std::remove_if(expected.begin(), expected.end(), odd), expected.end());
        }
    }
    ASSERT_EQ(values(list), std::vector<int>(expected.begin(), expected.end()));
    ASSERT_EQ(list.size(), expected.size());
    ASSERT_EQ(list.empty(), expected.empty());
    if (expected.empty()) continue;
    ASSERT_EQ(list.front().value, expected.front());
    ASSERT_EQ(list.back().value, expected.back());
    ASSERT_EQ(std::as_const(list)[expected.size() / 2].value, expected[expected.size() / 2]);
  }
}

TEST(RecyclingList, GivesTheMemoryOfDroppedElementsToNewOnes) {
  RecyclingList<Item> list;
  int taken = 0;
  for (int i = 0; i < 40; ++i) {
    Item& item = i % 2 ? list.push_front() : list.push_back();
    taken += item.buffer.capacity() < 1000;
    item.buffer.resize(1000);
    if (list.size() < 4) continue;
    switch (i % 3) {
      case 0: list.pop_front(); break;
      case 1: list.pop_back(); break;
      default: list.drop_if([&](const Item& other) { return &other == &list[2]; });
    }
  }
  EXPECT_EQ(taken, 4);
}

TEST(RecyclingList, LeavesElementsWhereTheyAre) {
  RecyclingList<Item> list;
  Item& first = list.push_back();
  first.value = -1;
  for (int i = 0; i < 100; ++i) (i % 2 ? list.push_front() : list.insert(list.size() / 2)).value = i;
  list.drop_if([](const Item& item) { return item.value % 3 == 0; });
  EXPECT_EQ(first.value, -1);
  EXPECT_EQ(&list.back(), &first);
}

TEST(RecyclingList, ThinsFramesThatComeFasterThanTheSpanNeeds) {
  struct Timed {
    double timestamp = 0;
  };
  for (const double interval : {1e-6, 1e-3, 1 / 240.0}) {
    dot::RecyclingList<Timed> list;
    const int frames = static_cast<int>(0.4 / interval) > 5000 ? 5000 : static_cast<int>(2 / interval);
    for (int i = 0; i < frames; ++i) {
      dot::thin_newest(list, 0.4);
      list.push_front().timestamp = i * interval;
      while (i * interval - list.back().timestamp > 0.4) list.pop_back();
      ASSERT_LE(list.size(), 35u) << interval;
      ASSERT_EQ(list[0].timestamp, i * interval);
      if (i > 0) {
        ASSERT_LE(list[0].timestamp - list[1].timestamp, 0.4 / 32 + 2 * interval);
      }
    }
  }
}

TEST(RecyclingList, ThinsNothingAtUsualFrameRates) {
  struct Timed {
    double timestamp = 0;
  };
  for (const double interval : {0.2, 0.1, 1 / 30.0, 1 / 60.0}) {
    dot::RecyclingList<Timed> list;
    for (int i = 0; i < 20; ++i) {
      dot::thin_newest(list, 0.4);
      list.push_front().timestamp = i * interval;
    }
    EXPECT_EQ(list.size(), 20u) << interval;
  }
}

}  // namespace
