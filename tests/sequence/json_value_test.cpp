// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/json_value.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/recording_folder.hpp"

namespace {

using runner::JsonValue;
using Type = JsonValue::Type;

JsonValue parse(const RecordingFolder& folder, const std::string& text) {
  folder.text("x.json", text);
  return runner::read_json(folder.path() / "x.json");
}

TEST(JsonValue, EachType) {
  const RecordingFolder folder;
  const JsonValue v = parse(folder, " {\"a\": [1, -2.5e3, true, false, null, \"x\", []], \"b\": {}}\r\n");
  ASSERT_TRUE(v.is(Type::Object));
  ASSERT_EQ(v.object().size(), 2U);
  const JsonValue* a = v.find("a");
  ASSERT_NE(a, nullptr);
  ASSERT_EQ(a->array().size(), 7U);
  EXPECT_EQ(a->array()[0].number(), 1);
  EXPECT_EQ(a->array()[1].number(), -2500);
  EXPECT_TRUE(a->array()[2].is(Type::Boolean) && a->array()[2].number() == 1);
  EXPECT_TRUE(a->array()[3].is(Type::Boolean) && a->array()[3].number() == 0);
  EXPECT_TRUE(a->array()[4].is(Type::Null));
  EXPECT_EQ(a->array()[5].string(), "x");
  EXPECT_TRUE(a->array()[6].is(Type::Array) && a->array()[6].array().empty());
  EXPECT_TRUE(v.find("b")->is(Type::Object));
  EXPECT_EQ(v.find("c"), nullptr);
}

TEST(JsonValue, AfterAByteOrderMark) { EXPECT_TRUE(parse(RecordingFolder(), "\xEF\xBB\xBF{}").is(Type::Object)); }

TEST(JsonValue, Escapes) {
  const RecordingFolder folder;
  EXPECT_EQ(parse(folder, R"("\"\\\/\b\f\n\r\t")").string(), "\"\\/\b\f\n\r\t");
  EXPECT_EQ(parse(folder, R"("\u0041\u00e9\u20AC\ud83d\ude00")").string(), "A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(JsonValue, DamagedDocumentsAreToldWithTheirLine) {
  const RecordingFolder folder;
  const auto complaint = [&](const std::string& text) {
    try {
      parse(folder, text);
    } catch (const runner::FileError& error) {
      const std::string said = error.what();
      return said.substr((folder.path() / "x.json").string().size());
    }
    return std::string("none");
  };
  EXPECT_EQ(complaint(""), ":1: the file is cut short");
  EXPECT_EQ(complaint("{\n\"a\": 1,\n"), ":3: the file is cut short");
  EXPECT_EQ(complaint("{\"a\" 1}"), ":1: ':' is missing");
  EXPECT_EQ(complaint("{a: 1}"), ":1: a name is missing");
  EXPECT_EQ(complaint("[1,\n 2 3]"), ":2: ']' is missing");
  EXPECT_EQ(complaint("[1,]"), ":1: a value is missing, or is not a number");
  EXPECT_EQ(complaint("[NaN]"), ":1: a value is missing, or is not a number");
  EXPECT_EQ(complaint("[1e999]"), ":1: a value is missing, or is not a number");
  EXPECT_EQ(complaint("{} {}"), ":1: something follows the document");
  EXPECT_EQ(complaint("\"abc"), ":1: the file is cut short");
  EXPECT_EQ(complaint("\"\\"), ":1: the file is cut short");
  EXPECT_EQ(complaint("\"\\u12"), ":1: the file is cut short");
  EXPECT_EQ(complaint("\"\\q\""), ":1: has an unknown escape");
  EXPECT_EQ(complaint("\"\\ud83d\""), ":1: has half of a surrogate pair");
  EXPECT_EQ(complaint("\"\\ud83d"), ":1: has half of a surrogate pair");
  EXPECT_EQ(complaint(std::string(100, '[')), ":1: is nested too deep");
  EXPECT_EQ(complaint(std::string(1000000, '[')), ":1: is nested too deep");
  EXPECT_THROW(runner::read_json(folder.path() / "none.json"), runner::FileError);
  EXPECT_THROW(runner::read_json(folder.path()), runner::FileError);
}

}  // namespace
