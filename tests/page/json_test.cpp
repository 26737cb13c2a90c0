// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "page/json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

namespace page {
namespace {

std::string text(const Json& json, int indent = 0) {
  std::ostringstream stream;
  json.write(stream, indent);
  return stream.str();
}

TEST(Json, ValuesAndEscapes) {
  EXPECT_EQ(text(Json("a\"b\\c\n")), "\"a\\\"b\\\\c\\u000a\"");
  EXPECT_EQ(text(Json("</script>")), "\"\\u003c/script>\"");
  EXPECT_EQ(text(Json(0.1)), "0.1");
  EXPECT_EQ(text(Json(std::numeric_limits<double>::quiet_NaN())), "null");
  EXPECT_EQ(text(Json::array({1, true, Json()})), "[1, true, null]");
  EXPECT_EQ(text(Json::object({{"a", 1}, {"b", Json::array()}})), "{\n \"a\": 1,\n \"b\": []}");
}

TEST(Json, OnOneLine) {
  const Json inner = Json::object({{"b", Json::array({Json::array({1, 2}), Json::array()})}, {"c", "d e"}});
  EXPECT_EQ(text(Json::object({{"a", inner}}), Json::one_line), "{\"a\":{\"b\":[[1,2],[]],\"c\":\"d e\"}}");
}

}  // namespace
}  // namespace page
