// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "rule.hpp"

namespace peers {

/// DynaSLAM without its geometry: whatever the network segments as a thing that can move is masked (section III-B of
/// arXiv:1806.05620).
class EverythingMovesRule : public Rule {
 public:
  Answers next(const View& view) override {
    Answers answers;
    for (int y = 0; y < view.ids.rows; ++y)
      for (int x = 0; x < view.ids.cols; ++x)
        if (const int id = view.ids.at<int>(y, x); id != 0)
          answers[static_cast<std::uint32_t>(id)] = dot::State::Moving;
    return answers;
  }
};

}  // namespace peers
