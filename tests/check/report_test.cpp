// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "check/report.hpp"

#include <gtest/gtest.h>

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

}  // namespace
