// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "check/report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "support/recording_folder.hpp"

namespace {

check::Report report() {
  return {"a<b",
          10,
          8,
          {check::faulty("depth-lag", 1, "frames", "Late \"by\" one.", "Pair them."),
           check::fine("time-unit", 0.1, "s", "Seconds."), check::unknown("pair-rows", "No pair.")}};
}

TEST(CheckReport, TextNamesFaultFigureAndAdvice) {
  const std::string text = check::text_report(report());
  for (const char* const part : {"1 fault found", "8 frames of 10", "FAULT", "depth-lag", "1 frames", "Pair them."})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(CheckReport, HintsAreNoFaults) {
  check::Report hinted = report();
  hinted.findings[0].verdict = check::Verdict::Hint;
  EXPECT_EQ(hinted.faults(), 0u);
  const std::string text = check::text_report(hinted);
  for (const char* const part : {"no fault found, 1 hint", "HINT", "1 frames", "Pair them."})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  EXPECT_NE(check::json_report(hinted).find("\"hint\""), std::string::npos);
  EXPECT_EQ(check::text_report(report()).find("hint"), std::string::npos);
}

TEST(CheckReport, PageEscapesWhatItShows) {
  const std::string page = check::html_report(report());
  EXPECT_NE(page.find("a&lt;b"), std::string::npos);
  EXPECT_EQ(page.find("a<b"), std::string::npos);
}

TEST(CheckReport, JsonHasNullWhereNothingWasMeasured) {
  const std::string json = check::json_report(report());
  EXPECT_NE(json.find("null"), std::string::npos);
  EXPECT_EQ(json.find("nan"), std::string::npos);
  EXPECT_NE(json.find("\"faults\": 1"), std::string::npos);
}

TEST(CheckRecording, SampleIsFine) {
  runner::SequenceOptions options;
  options.folder = DOT_SAMPLE_DIR;
  const check::Report of_sample = check::check_recording(options);
  EXPECT_EQ(of_sample.faults(), 0u) << check::text_report(of_sample);
  EXPECT_EQ(of_sample.frames, of_sample.looked_at);
}

// Its steps look like another unit, or another baseline, and the two sides of things change places.
TEST(CheckRecording, DisparityIsOneFault) {
  namespace fs = std::filesystem;
  const RecordingFolder folder;
  const fs::path sample = DOT_SAMPLE_DIR;
  for (const char* const name : {"rgb", "right", "masks", "depth"}) fs::copy(sample / name, folder.path() / name);
  for (const char* const name : {"intrinsics.txt", "times.txt"}) fs::copy(sample / name, folder.path() / name);
  for (const auto& file : fs::directory_iterator(folder.path() / "depth")) {
    constexpr double fx_baseline = 362.5 * 0.532725, steps = 64;
    cv::Mat depth = cv::imread(file.path().string(), cv::IMREAD_UNCHANGED), disparity;
    depth.convertTo(disparity, CV_32F);
    disparity = 256 * fx_baseline * steps / disparity;
    disparity.setTo(0, depth == 0);
    disparity.convertTo(depth, CV_16U);
    cv::imwrite(file.path().string(), depth);
  }
  runner::SequenceOptions options;
  options.folder = folder.path();
  const check::Report report = check::check_recording(options);
  EXPECT_EQ(report.faults(), 1u) << check::text_report(report);
  EXPECT_EQ(report.findings[0].fault, "depth-inverse");
}

}  // namespace
