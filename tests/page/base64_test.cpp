// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "page/base64.hpp"

#include <gtest/gtest.h>

namespace page {
namespace {

TEST(Base64, AsInTheStandard) {
  EXPECT_EQ(base64({'f'}), "Zg==");
  EXPECT_EQ(base64({'f', 'o'}), "Zm8=");
  EXPECT_EQ(base64({'f', 'o', 'o'}), "Zm9v");
  EXPECT_EQ(base64({0xFF, 0xEE, 0xDD, 0xCC}), "/+7dzA==");
}

}  // namespace
}  // namespace page
