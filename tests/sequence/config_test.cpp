// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run/config.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/recording_folder.hpp"

namespace {

/// What read_config says of a file; empty if it takes it.
std::string complaint(const std::string& text, dot::Options* options = nullptr) {
  const RecordingFolder folder;
  folder.text("config", text);
  dot::Options unused;
  try {
    runner::read_config(folder.path() / "config", options != nullptr ? *options : unused);
  } catch (const runner::FileError& error) {
    const std::string place = (folder.path() / "config").string(), message = error.what();
    EXPECT_EQ(message.compare(0, place.size(), place), 0) << message;
    return message.substr(std::min(place.size(), message.size()));
  }
  return {};
}

TEST(ReadConfig, NumbersTruthAndNames) {
  dot::Options options;
  EXPECT_EQ(complaint("# settings\n\nthreads = 2e0 # two\r\nvelocity.v0=.25\ndiscover_unknown = 1\n"
                      "motion_prior.ground_vehicle = true\nclassifier = entropy\ndepth_noise.source = lidar\n",
                      &options),
            "");
  EXPECT_EQ(options.threads, 2);
  EXPECT_EQ(options.velocity.v0, 0.25);
  EXPECT_TRUE(options.discover_unknown);
  EXPECT_TRUE(options.motion_prior.ground_vehicle);
  EXPECT_EQ(options.classifier, dot::ClassifierKind::Entropy);
  EXPECT_EQ(options.depth_noise.source, dot::DepthSource::Lidar);
}

TEST(ReadConfig, ASettingTwice) {
  EXPECT_EQ(complaint("threads=1\nthreads=2\n"), ":2: threads stands in line 1 already");
  EXPECT_EQ(complaint("classifier = entropy\n\nclassifier = velocity"), ":3: classifier stands in line 1 already");
}

TEST(ReadConfig, Junk) {
  using std::string_literals::operator""s;
  EXPECT_EQ(complaint("discover_unknown = 7"), ":1: discover_unknown cannot be '7'");
  EXPECT_EQ(complaint("threads = 2\0junk"s), ":1: threads cannot be '2?junk'");
  EXPECT_EQ(complaint("\nvelocity.v0 = 0x1p-1"), ":2: velocity.v0 cannot be '0x1p-1'");
  EXPECT_EQ(complaint("velocity.v0 = 0.5 m/s"), ":1: velocity.v0 cannot be '0.5 m/s'");
  EXPECT_EQ(complaint("velocity.v0 = nan"), ":1: velocity.v0 cannot be 'nan'");
  EXPECT_EQ(complaint("velocity.v0 = 1e999"), ":1: velocity.v0 cannot be '1e999'");
  EXPECT_EQ(complaint("align.max_iterations = 1e10"), ":1: align.max_iterations cannot be '1e10'");
  EXPECT_EQ(complaint("align.max_levels = 2.5"), ":1: align.max_levels cannot be '2.5'");
  EXPECT_EQ(complaint("threads 2"), ":1: 'threads 2' is not of the form name = value");
  EXPECT_EQ(complaint("velocity\x01.v0 = 1"), ":1: unknown option 'velocity?.v0'");
}

TEST(ReadConfig, OutOfRangeNamesTheLine) {
  EXPECT_EQ(complaint("# many\nthreads = 1e9\n").substr(0, 11), ":2: threads");
  EXPECT_EQ(complaint("\n\nvelocity.v0 = -1\n").substr(0, 15), ":3: velocity.v0");
  // What one line does to the default of another is told without a line.
  EXPECT_EQ(complaint("velocity.decide = 0.6\n").substr(0, 15), ": velocity.keep");
}

}  // namespace
