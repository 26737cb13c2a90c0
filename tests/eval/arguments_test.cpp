// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/arguments.hpp"

#include <gtest/gtest.h>

#include "sequence/errors.hpp"

namespace eval {
namespace {

TEST(Arguments, AllOfThem) {
  const char* const line[] = {"dot_eval",    "/d/a", "--rates", "1,4",    "/d/b",     "--jobs=3",   "--from", "5",
                              "--min-speed", "0.25", "--html",  "x.html", "--stereo", "--mask-dir", "m"};
  const Arguments a = parse_arguments(static_cast<int>(std::size(line)), line);
  EXPECT_EQ(a.sequences.size(), 2U);
  EXPECT_EQ(a.rates, (std::vector<int>{1, 4}));
  EXPECT_EQ(a.jobs, 3);
  EXPECT_EQ(a.scoring.from, 5);
  EXPECT_DOUBLE_EQ(a.scoring.min_speed, 0.25);
  EXPECT_EQ(a.html, "x.html");
  EXPECT_TRUE(a.run.sequence.stereo);
  EXPECT_EQ(a.run.sequence.mask_dir, "m");
}

Arguments delays(const std::string& value, const std::string& plot = "") {
  std::vector<const char*> line{"dot_eval", "/d/a", "--network-delay", value.c_str()};
  if (!plot.empty()) line.insert(line.end(), {"--plot", plot.c_str()});
  return parse_arguments(static_cast<int>(line.size()), line.data());
}

TEST(Arguments, DelaysAreInTheirOrderAndOnce) {
  EXPECT_EQ(delays("0,500,100,500").network_delays, (std::vector<int>{0, 100, 500}));
}

TEST(Arguments, APlotNeedsTwoDelays) {
  EXPECT_EQ(delays("0,100", "x.svg").plot, "x.svg");
  EXPECT_THROW(delays("100", "x.svg"), runner::UsageError);
  EXPECT_THROW(delays("100,100", "x.svg"), runner::UsageError);
}

}  // namespace
}  // namespace eval
