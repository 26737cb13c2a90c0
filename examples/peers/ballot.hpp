// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include "rule.hpp"

namespace peers {

/// Points of objects vote on whether these move.
class Ballot {
 public:
  void add(int id, bool moves) {
    Count& count = counts_[static_cast<std::uint32_t>(id)];
    ++count.all;
    count.moving += moves;
  }

  /// Objects of which more than `share` of the points move, and at least one; those with fewer than `least` points are
  /// not observable.
  Answers result(double share, int least) const {
    Answers answers;
    for (const auto& [id, count] : counts_)
      if (count.all >= least) answers[id] = count.moving > share * count.all ? dot::State::Moving : dot::State::Static;
    return answers;
  }

 private:
  struct Count {
    int all = 0;
    int moving = 0;
  };
  std::map<std::uint32_t, Count> counts_;
};

}  // namespace peers
