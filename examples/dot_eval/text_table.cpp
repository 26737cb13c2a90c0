// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

namespace eval {
namespace {

std::string share(double value) { return number("%.3f", value); }

std::string rate(int every) { return "1/" + std::to_string(every); }

std::vector<std::string> decisions(const Confusion& c) {
  return {std::to_string(c.total()),   share(c.f1()),
          share(c.precision()),        share(c.recall()),
          share(c.decided_share()),    share(c.static_moving_share()),
          share(c.static_kept_share())};
}

void append(std::vector<std::string>& row, const std::vector<std::string>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

std::vector<std::string> row_of(const RunScore& run) {
  std::vector<std::string> row{run.name, rate(run.every)};
  if (!run.error.empty()) {
    row.push_back("FAILED: " + run.error);
    return row;
  }
  append(row, run.objects ? decisions(run.objects->confusion) : std::vector<std::string>(7, "-"));
  row.push_back(run.objects ? share(run.objects->mask_iou()) : "-");
  row.push_back(run.camera ? number("%.2f", run.camera->rpe_trans_median_cm()) : "-");
  row.push_back(run.camera ? number("%.4f", run.camera->rpe_rot_median_deg()) : "-");
  row.push_back(run.camera ? number("%.2f", run.camera->rpe_trans_max_cm()) : "-");
  row.push_back(run.objects ? std::to_string(run.objects->id_switches) : "-");
  const FrameTime time = frame_time(run.frame_ms);
  append(row, {number("%.1f", time.mean), number("%.1f", time.p99)});
  return row;
}

std::vector<std::string> row_of(const Pooled& p) {
  std::vector<std::string> row{"POOLED", rate(p.every)};
  append(row, decisions(p.confusion));
  append(row, {share(p.mask_iou), number("%.2f", p.rpe_trans_median_cm), number("%.4f", p.rpe_rot_median_deg),
               number("%.2f", p.rpe_trans_max_cm), std::to_string(p.id_switches), number("%.1f", p.frame_time.mean),
               number("%.1f", p.frame_time.p99)});
  return row;
}

std::string decision_table(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  Table table({"sequence", "rate", "objfr", "F1", "prec", "recall", "decid", "st>mov", "kept", "IoU", "cm", "deg",
               "max.cm", "ids", "ms", "p99"});
  for (const Pooled& p : pooled) {
    for (const RunScore& run : runs)
      if (run.every == p.every) table.add(row_of(run));
    if (p.runs > p.failed) table.add(row_of(p));
  }
  return table.text();
}

std::string pooled_table(const std::vector<Pooled>& pooled) {
  std::vector<std::string> header{"pooled"};
  for (const Pooled& p : pooled) header.push_back(rate(p.every));
  Table table(header);
  const auto add = [&](const std::string& name, const char* pattern, auto&& figure) {
    std::vector<std::string> row{name};
    for (const Pooled& p : pooled) row.push_back(number(pattern, figure(p)));
    table.add(std::move(row));
  };
  add("mask IoU over that at the first rate, mean", "%.3f", [](auto& p) { return p.iou_ratio_mean; });
  add("  of the worst sequence", "%.3f", [](auto& p) { return p.iou_ratio_min; });
  add("instance IoU", "%.3f", [](auto& p) { return p.instance_iou; });
  add("movers under 30 m: speed error, m/s", "%.3f", [](auto& p) { return p.near_speed_error; });
  add("  motion error, m", "%.3f", [](auto& p) { return p.near_motion_error_m; });
  add("  motion error, deg", "%.3f", [](auto& p) { return p.near_motion_error_deg; });
  for (std::size_t i = 0; i + 1 < band_count; ++i) {
    const std::string where = std::string("standing at ") + band_names[i] + " m: ";
    add(where + "NEES per axis", "%.3f", [i](auto& p) { return p.bands[i].nees_per_axis(); });
    add("  inside the 95 % ellipsoid", "%.3f", [i](auto& p) { return p.bands[i].within_95(); });
  }
  add("turning at 20 deg/s or more: object-frames", "%.0f",
      [](auto& p) { return static_cast<double>(p.turning.moving_total()); });
  add("  called moving", "%.3f", [](auto& p) { return p.turning.recall(); });
  add("coverage of speed, worst sequence", "%.3f", [](auto& p) { return p.speed_coverage; });
  add("  of sigma", "%.3f", [](auto& p) { return p.sigma_coverage; });
  add("  of T_o", "%.3f", [](auto& p) { return p.motion_coverage; });
  add("camera: ATE, worst sequence, m", "%.3f", [](auto& p) { return p.ate_m; });
  add("  NEES per axis, median", "%.3f", [](auto& p) { return p.camera_nees; });
  for (const bool starts : {true, false}) {
    const auto of = [starts](auto& p) { return events_of(p.latency, starts); };
    add(starts ? "objects that start" : "objects that stop", "%.0f",
        [&](auto& p) { return static_cast<double>(of(p).size()); });
    add("  told after, median, s", "%.2f", [&](auto& p) { return latency(of(p), 50); });
    add("  the last one, s", "%.2f", [&](auto& p) { return latency(of(p), 100); });
    if (!starts) continue;
    add("  had gone until then, median, m", "%.2f", [&](auto& p) { return displacement(of(p), 50); });
    add("  at most, m", "%.2f", [&](auto& p) { return displacement(of(p), 100); });
  }
  if (std::any_of(pooled.begin(), pooled.end(), [](auto& p) { return p.hidden.standing > 0; })) {
    add("hidden movers: share of their pixels found", "%.3f", [](auto& p) { return p.hidden.found_share(); });
    add("  pixels that do not move called moving", "%.4f", [](auto& p) { return p.hidden.false_share(); });
    add("  pixels called moving that do not move", "%.3f", [](auto& p) { return p.hidden.outside_share(); });
  }
  for (std::size_t i = 0; i < stage_count; ++i)
    add((i == 0 ? "ms a frame: " : "  ") + std::string(dot::to_string(static_cast<dot::Stage>(i))), "%.2f",
        [i](auto& p) { return p.stage_ms[i]; });
  add("  all", "%.2f", [](auto& p) { return p.frame_time.mean; });
  add("  all, median", "%.2f", [](auto& p) { return p.frame_time.median; });
  add("  99 of 100 frames, worst sequence", "%.2f", [](auto& p) { return p.frame_time.p99; });
  add("  the slowest frame", "%.2f", [](auto& p) { return p.frame_time.largest; });
  add("  the second frame, worst sequence", "%.2f", [](auto& p) { return p.frame_time.second; });
  return table.text();
}

/// Of what moves more slowly than most scores count, how much is called moving and static.
std::string slow_table(const std::vector<Pooled>& pooled) {
  std::vector<std::string> header{"called moving, static, of"};
  for (const char* const band : band_names) header.push_back(std::string(band) + " m");
  Table table(header);
  bool found = false;
  for (const Pooled& p : pooled)
    for (std::size_t i = 1; i < speed_count && std::string(speed_names[i]) != "3-8"; ++i) {
      bool any = false;
      std::vector<std::string> row{rate(p.every) + "  " + speed_names[i] + " m/s"};
      for (std::size_t b = 0; b < band_count; ++b) {
        const AnswerCounts& counts = p.by_speed[i][b];
        const long all = std::accumulate(counts.begin(), counts.end(), 0L);
        const auto of = [&](Answer answer) { return std::to_string(counts[static_cast<std::size_t>(answer)]); };
        row.push_back(all > 0 ? of(Answer::Moving) + ", " + of(Answer::Static) + ", " + std::to_string(all) : "-");
        any = any || all > 0;
      }
      if (any) table.add(std::move(row));
      found = found || any;
    }
  return found ? '\n' + table.text() : "";
}

std::string latency_lines(const std::vector<RunScore>& runs) {
  std::string text;
  for (const RunScore& run : runs) {
    for (const LatencyEvent& event : run.latency) {
      const std::string what =
          event.seconds ? (event.starts ? "moving after " : "static after ") + number("%.2f s", *event.seconds) +
                              (event.starts ? number(" and %.2f m", event.metres) : "")
                        : std::string(event.starts ? "never called moving" : "never called static");
      text += run.name + " " + rate(run.every) + ": object " + std::to_string(event.id) +
              (event.starts ? " starts" : " stops") + " in frame " + std::to_string(event.frame) + ", " + what + '\n';
    }
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows_) {
    if (row.size() < rows_[0].size()) continue;  // a remark
    widths.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const std::vector<std::string>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] > row[i].size() ? widths[i] - row[i].size() : 0, ' ');
      text += (i > 0 ? "  " : "") + (i == 0 ? row[i] + padding : padding + row[i]);
    }
    text += '\n';
  }
  return text;
}

std::string number(const char* pattern, double value) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string stretch_lines(const std::vector<RunScore>& runs) {
  std::string text;
  for (const RunScore& run : runs)
    if (run.camera && run.camera->stretch)
      text += run.name + " " + rate(run.every) + ": " + number("%.3f %%, ", run.camera->stretch->translation_percent) +
              number("%.4f deg per 100 m", run.camera->stretch->rotation_deg_per_100m) + " in " +
              std::to_string(run.camera->stretch->stretches) + " stretches\n";
  return text;
}

std::string text_table(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  const std::string stretches = stretch_lines(runs);
  return decision_table(runs, pooled) + '\n' + pooled_table(pooled) + slow_table(pooled) + latency_lines(runs) +
         "\ncamera error over stretches of 100 to 800 m" +
         (stretches.empty() ? ": absent, no path is long enough\n" : '\n' + stretches);
}

}  // namespace eval
