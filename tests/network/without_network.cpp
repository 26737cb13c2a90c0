// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "network/network.hpp"
#include "sequence/errors.hpp"

// A program of its own, with unavailable.cpp in the place of the networks.

TEST(WithoutNetwork, SaysWhatIsMissing) {
  try {
    network::open_network({}, {8, 4});
    FAIL() << "nothing thrown";
  } catch (const runner::UsageError& error) {
    EXPECT_EQ(std::string(error.what()),
              "--network: this program was built without OpenCV's dnn module (Debian and Ubuntu: libopencv-dnn-dev)");
  }
}
