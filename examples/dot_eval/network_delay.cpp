// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "network_delay.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "chart.hpp"
#include "statistics.hpp"
#include "text_table.hpp"

namespace eval {
namespace {

double f1(const DelayScore& s) { return s.pooled.confusion.f1(); }
double mask_iou(const DelayScore& s) { return s.pooled.mask_iou; }
double decided(const DelayScore& s) { return s.pooled.confusion.decided_share(); }

}  // namespace

std::vector<Job> delay_jobs(const Arguments& arguments) {
  std::vector<std::optional<double>> delays{std::nullopt};
  for (const int ms : arguments.network_delays) delays.emplace_back(ms / 1000.0);
  std::vector<Job> jobs;
  for (const std::optional<double>& delay : delays)
    for (std::size_t i = 0; i < arguments.sequences.size(); ++i) jobs.push_back({i, arguments.rates[0], delay});
  return jobs;
}

std::vector<DelayScore> pool_delays(const Arguments& arguments, const std::vector<RunScore>& runs) {
  std::vector<DelayScore> scores;
  const auto count = static_cast<std::ptrdiff_t>(arguments.sequences.size());
  for (auto first = runs.begin(); first != runs.end(); first += count) {
    const std::vector<RunScore> group(first, first + count);
    DelayScore& score = scores.emplace_back();
    score.network_seconds = first->network_seconds;
    score.pooled = pool(group, arguments.rates[0], arguments.rates[0]);
    for (const RunScore& run : group) {
      score.frames += run.frames;
      score.refused += run.late.refused;
      score.mask_latency.insert(score.mask_latency.end(), run.late.mask_latency.begin(), run.late.mask_latency.end());
    }
  }
  return scores;
}

std::string delay_table(const std::vector<RunScore>& runs, const std::vector<DelayScore>& scores) {
  Table table({"network", "used", "too late", "latency", "F1", "prec", "recall", "decided", "st>mov", "IoU"});
  const auto share = [](double value) { return number("%.3f", value); };
  for (const DelayScore& s : scores) {
    const Confusion& c = s.pooled.confusion;
    std::vector<std::string> row{"with frame", "-", "-", "-"};
    if (s.network_seconds)
      row = {number("%.0f", *s.network_seconds * 1000),
             std::to_string(s.mask_latency.size()) + "/" + std::to_string(s.frames), std::to_string(s.refused),
             number("%.0f", 1000 * median(s.mask_latency))};
    for (const double value :
         {c.f1(), c.precision(), c.recall(), c.decided_share(), c.static_moving_share(), s.pooled.mask_iou})
      row.push_back(share(value));
    table.add(std::move(row));
  }
  std::string text =
      "network: ms for a frame; used: segmentations, of the frames; latency: ms from frame to masks\n" + table.text();
  for (const RunScore& run : runs)
    if (!run.error.empty()) text += run.name + " FAILED: " + run.error + "\n";
  return text;
}

std::string delay_plot(const std::vector<DelayScore>& scores) {
  std::vector<double> x;
  std::vector<Series> series{{"F1 of moving", "f1", {}}, {"decided share", "decided", {}}, {"mask IoU", "iou", {}}};
  for (const DelayScore& s : scores) {
    if (!s.network_seconds) continue;
    x.push_back(1000 * *s.network_seconds);
    series[0].values.push_back(f1(s));
    series[1].values.push_back(decided(s));
    series[2].values.push_back(mask_iou(s));
  }
  constexpr ChartSize size{620, 300};
  const char* const colours[] = {"#2a63c8", "#16a3a0", "#e06a3b"};
  std::string style =
      "text{font:12px sans-serif;fill:#5d6672}line.tick{stroke:#e4e6e8}line.axis{stroke:#5d6672}"
      "polyline{fill:none;stroke-width:1.8}";
  std::string legend;
  for (std::size_t i = 0; i < series.size(); ++i) {
    style += "polyline." + series[i].colour + "{stroke:" + colours[i] + "}";
    const std::string y = std::to_string(226 + 16 * i);
    legend += "<rect x=\"80\" y=\"" + y + "\" width=\"14\" height=\"3\" fill=\"" + colours[i] +
              "\"/><text x=\"100\" y=\"" + std::to_string(231 + 16 * i) + "\">" + series[i].name + "</text>\n";
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 620 326\">\n<style>" + style +
         "</style>\n<rect width=\"620\" height=\"326\" fill=\"#fff\"/>\n<svg width=\"620\" height=\"300\">" +
         lines(size, x, series) + "</svg>\n" + legend +
         "<text x=\"332\" y=\"318\" text-anchor=\"middle\">time of the network for a frame, ms</text>\n</svg>\n";
}

}  // namespace eval
