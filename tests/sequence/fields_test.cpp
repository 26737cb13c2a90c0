// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/fields.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace {

using runner::parse_number;
using runner::to_whole;
using std::string_literals::operator""s;

TEST(ParseNumber, TakesAllOfADecimalNumber) {
  EXPECT_EQ(parse_number("36"), 36);
  EXPECT_EQ(parse_number("-1.5e+02"), -150);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("7."), 7);
  EXPECT_EQ(parse_number("1e-320"), 1e-320) << "too small for all its digits, and a number all the same";
  for (const std::string& text :
       {""s,    " "s,     " 1"s,   "1 "s,  "36\0"s, "36\0junk"s, "\0"s,    "1,5"s,    "1e"s,   "e5"s,
        "--1"s, "1.2.3"s, "0x10"s, "inf"s, "nan"s,  "NAN(1)"s,   "1e999"s, "-1e999"s, "12px"s, "."s})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(ToWhole, ChecksBeforeItConverts) {
  EXPECT_EQ(to_whole(7, 0, 7), 7);
  EXPECT_EQ(to_whole(-2147483648.0, std::numeric_limits<int>::min(), 0), std::numeric_limits<int>::min());
  EXPECT_EQ(to_whole<std::uint8_t>(255, 0, 255), 255);
  EXPECT_EQ(to_whole(1, false, true), true);
  for (const double value : {8.0, -1.0, 0.7, 1e300, -1e300, 2147483648.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(to_whole(value, 0, 7)) << value;
}

TEST(Quoted, ShowsNothingThatBreaksALine) {
  EXPECT_EQ(runner::quoted("a\nb\0c\xff"s), "'a?b?c?'");
  EXPECT_EQ(runner::quoted(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
