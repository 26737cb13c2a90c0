// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "dot_eval/html.hpp"
#include "dot_eval/report.hpp"
#include "dot_eval/text_table.hpp"

namespace eval {
namespace {

/// Two sequences, of which the second failed, at two rates.
std::vector<RunScore> runs() {
  std::vector<RunScore> list;
  for (const int every : {1, 4}) {
    RunScore good;
    good.name = "street <1>";
    good.every = every;
    good.frames = 3;
    good.objects.emplace();
    good.objects->confusion.add(true, Answer::Moving);
    good.objects->confusion.add(false, Answer::Missed);
    good.objects->pixels = {{0, 100, 0, 0}, {1, 90, 80, 4}, {2, 120, 115, 200}};
    good.objects->by_speed[0][1] = {1, 2, 3, 4};
    good.camera.emplace();
    good.camera->frames = 3;
    good.camera->step_cm = {0.5, 12};
    good.camera->step_deg = {0.01, 0.02};
    good.latency = {{4, 2, true, 0.3}, {5, 7, false, {}}};
    good.frame_ms = {20};
    good.stage_ms.fill(3);
    good.pictures = {{1, "a & b", {0xFF, 0xD8, 0xFF}}};
    list.push_back(good);
    RunScore failed;
    failed.name = "gone";
    failed.every = every;
    failed.error = "gone: no such folder \"x\"";
    list.push_back(failed);
  }
  return list;
}

std::vector<Pooled> pooled(const std::vector<RunScore>& list) { return {pool(list, 1, 1), pool(list, 4, 1)}; }

std::string text(const Json& json) {
  std::ostringstream stream;
  json.write(stream);
  return stream.str();
}

TEST(Report, FailedRunsSayWhy) {
  const std::string json = text(report(Arguments(), runs(), pooled(runs())));
  EXPECT_NE(json.find("\"error\": \"gone: no such folder \\\"x\\\"\""), std::string::npos);
  EXPECT_NE(json.find("\"failed_runs\": 1"), std::string::npos);
  EXPECT_NE(json.find("absent: the path is too short"), std::string::npos);
}

TEST(Report, ErrorsOverStretchesWhereThePathIsLong) {
  std::vector<RunScore> list = runs();
  list[0].camera->stretch = StretchError{1.25, 0.5, 3};
  const std::string json = text(report(Arguments(), list, pooled(list)));
  EXPECT_NE(json.find("\"translation_percent\": 1.25"), std::string::npos);
  EXPECT_EQ(stretch_lines(list), "street <1> 1/1: 1.250 %, 0.5000 deg per 100 m in 3 stretches\n");
  EXPECT_EQ(stretch_lines(runs()), "");
}

TEST(TextTable, HasARowForEachRun) {
  const std::string table = text_table(runs(), pooled(runs()));
  EXPECT_NE(table.find("gone         1/4  FAILED: gone: no such folder"), std::string::npos) << table;
  EXPECT_NE(table.find("POOLED       1/1"), std::string::npos) << table;
  EXPECT_NE(table.find("object 4 starts in frame 2, moving after 0.30 s"), std::string::npos) << table;
  EXPECT_NE(table.find("object 5 stops in frame 7, never called static"), std::string::npos) << table;
}

/// What is wrong with the nesting of the tags; empty when nothing is.
std::string nesting_error(const std::string& html) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-zA-Z0-9]+)((?:\\s+[-a-zA-Z0-9:]+=\"[^\"<>]*\")*)\\s*(/?)>");
  std::size_t angles = 0;
  for (std::sregex_iterator i(html.begin(), html.end(), tag), end; i != end; ++i) {
    ++angles;
    if ((*i)[1] == "/") {
      if (open.empty() || open.back() != (*i)[2]) return "unexpected </" + (*i)[2].str() + ">";
      open.pop_back();
    } else if ((*i)[4] != "/") {
      open.push_back((*i)[2]);
    }
  }
  if (!open.empty()) return "<" + open.back() + "> is not closed";
  const auto all = static_cast<std::size_t>(std::count(html.begin(), html.end(), '<'));
  return all == angles + 1 ? "" : "a < that begins no tag";  // + 1: the document type
}

TEST(Html, IsWellFormedAndEscaped) {
  const std::string html = html_page(runs(), pooled(runs()));
  EXPECT_EQ(nesting_error(html), "");
  EXPECT_NE(html.find("street &lt;1&gt;"), std::string::npos);
  EXPECT_NE(html.find("a &amp; b"), std::string::npos);
  EXPECT_NE(html.find("gone: no such folder &quot;x&quot;"), std::string::npos);
  EXPECT_NE(html.find("data:image/jpeg;base64,/9j/"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos) << "a link to the outside";
}

TEST(Html, NothingMeasuredIsStillAPage) {
  std::vector<RunScore> failed{runs()[1]};
  const std::string html = html_page(failed, {pool(failed, 1, 1)});
  EXPECT_EQ(nesting_error(html), "");
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace eval
