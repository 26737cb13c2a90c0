// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "html.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "chart.hpp"
#include "page/base64.hpp"
#include "page/escape.hpp"
#include "page/style.hpp"
#include "text_table.hpp"

namespace eval {

using page::base64;
using page::escaped;

namespace {

const char* const colour_names[] = {"moving", "static", "unobservable", "missed", "rate0",  "rate1",
                                    "rate2",  "rate3",  "rate4",        "rate5",  "stage0", "stage1",
                                    "stage2", "stage3", "stage4",       "stage5"};
constexpr std::size_t rate_colours = 6;

std::string style() {
  std::string css(page::style_css);
  for (const std::string name : colour_names) {
    const std::string colour = "var(--" + name + "); }";
    css += "rect." + name + " { fill: " + colour;
    css += " polyline." + name + " { stroke: " + colour;
    css += " i." + name + " { background: " + colour + '\n';
  }
  return css;
}

std::string rate_name(int every) {
  return every == 1 ? "a mask in every frame"
                    : "in every " + std::to_string(every) +
                          (every == 2   ? "nd"
                           : every == 3 ? "rd"
                                        : "th");
}

std::string short_rate(int every) { return "1/" + std::to_string(every); }

std::string rate_colour(std::size_t index) { return "rate" + std::to_string(index % rate_colours); }

std::string legend(const std::vector<Series>& series) {
  std::string html = "<span class=\"legend\">";
  for (const Series& s : series) html += "<span><i class=\"" + s.colour + "\"></i>" + escaped(s.name) + "</span>";
  return html + "</span>";
}

/// @param series listed in the legend; none: no legend.
std::string card(const std::string& title, const std::string& svg, const std::vector<Series>& series = {}) {
  return "<figure class=\"card\"><div class=\"head\"><h3>" + escaped(title) + "</h3>" +
         (series.empty() ? "" : legend(series)) + "</div>\n" + svg + "</figure>\n";
}

std::string heading(const std::string& title, const std::string& remark) {
  return "<h2>" + escaped(title) + "</h2>\n<p>" + escaped(remark) + "</p>\n";
}

// --- What is drawn ---------------------------------------------------------------------------------------------------

/// A series for each rate; `figure` gives its value for each category.
template <typename Figure>
std::vector<Series> by_rate(const std::vector<Pooled>& pooled, std::size_t categories, Figure&& figure) {
  std::vector<Series> series;
  for (std::size_t k = 0; k < pooled.size(); ++k) {
    series.push_back({rate_name(pooled[k].every), rate_colour(k), {}});
    for (std::size_t i = 0; i < categories; ++i) series.back().values.push_back(figure(pooled[k], i));
  }
  return series;
}

/// Names of the sequences that were measured at some rate, in the order of the runs.
std::vector<std::string> measured_names(const std::vector<RunScore>& runs) {
  std::vector<std::string> names;
  for (const RunScore& run : runs)
    if (run.error.empty() && std::find(names.begin(), names.end(), run.name) == names.end()) names.push_back(run.name);
  return names;
}

/// The run of a sequence at a rate, or null where it failed.
const RunScore* find_run(const std::vector<RunScore>& runs, const std::string& name, int every) {
  for (const RunScore& run : runs)
    if (run.name == name && run.every == every && run.error.empty()) return &run;
  return nullptr;
}

std::string tile(const std::string& title, const std::vector<Pooled>& pooled, const char* pattern,
                 double (*figure)(const Pooled&)) {
  std::string html = "<div class=\"tile\"><h3>" + escaped(title) + "</h3><dl>";
  for (const Pooled& p : pooled)
    html += "<dt>" + short_rate(p.every) + "</dt><dd>" + number(pattern, figure(p)) + "</dd>";
  return html + "</dl></div>\n";
}

std::string tiles(const std::vector<Pooled>& pooled) {
  std::string html = "<div class=\"tiles\">\n";
  html += tile("moving F1", pooled, "%.3f", [](const Pooled& p) { return p.confusion.f1(); });
  html +=
      tile("static called moving", pooled, "%.3f", [](const Pooled& p) { return p.confusion.static_moving_share(); });
  html += tile("decided", pooled, "%.3f", [](const Pooled& p) { return p.confusion.decided_share(); });
  html += tile("moving mask IoU", pooled, "%.3f", [](const Pooled& p) { return p.mask_iou; });
  html += tile("camera cm, worst", pooled, "%.2f", [](const Pooled& p) { return p.rpe_trans_median_cm; });
  html += tile("ms a frame", pooled, "%.1f", [](const Pooled& p) { return p.frame_time.mean; });
  if (std::any_of(pooled.begin(), pooled.end(), [](const Pooled& p) { return p.hidden.standing > 0; }))
    html += tile("hidden movers found", pooled, "%.3f", [](const Pooled& p) { return p.hidden.found_share(); });
  return html + "</div>\n";
}

std::string cell(const char* pattern, double value) { return "<td>" + number(pattern, value) + "</td>"; }

std::string decision_cells(const Confusion& c) {
  return cell("%.0f", static_cast<double>(c.total())) + cell("%.3f", c.f1()) + cell("%.3f", c.precision()) +
         cell("%.3f", c.recall()) + cell("%.3f", c.decided_share()) + cell("%.3f", c.static_moving_share()) +
         cell("%.3f", c.static_kept_share());
}

std::string run_row(const RunScore& run) {
  std::string html = "<tr><td>" + escaped(run.name) + "</td><td>" + short_rate(run.every) + "</td>";
  if (!run.error.empty()) return html + "<td class=\"reason\" colspan=\"15\">" + escaped(run.error) + "</td></tr>\n";
  html += run.objects ? decision_cells(run.objects->confusion) + cell("%.3f", run.objects->mask_iou()) +
                            cell("%.3f", mean(run.objects->instance_iou)) + cell("%.0f", run.objects->id_switches)
                      : decision_cells({}) + cell("", not_a_number) + cell("", not_a_number) + cell("", not_a_number);
  const auto camera = [&](const char* pattern, auto&& figure) {
    return cell(pattern, run.camera ? figure(*run.camera) : not_a_number);
  };
  html += camera("%.2f", [](auto& c) { return c.rpe_trans_median_cm(); });
  html += camera("%.2f", [](auto& c) { return c.rpe_trans_max_cm(); });
  html += camera("%.4f", [](auto& c) { return c.rpe_rot_median_deg(); });
  html += camera("%.3f", [](auto& c) { return c.ate_m; });
  return html + cell("%.1f", frame_time(run.frame_ms).mean) + "</tr>\n";
}

std::string pooled_row(const Pooled& p) {
  return "<tr class=\"pooled\"><td>all</td><td>" + short_rate(p.every) + "</td>" + decision_cells(p.confusion) +
         cell("%.3f", p.mask_iou) + cell("%.3f", p.instance_iou) + cell("%.0f", p.id_switches) +
         cell("%.2f", p.rpe_trans_median_cm) + cell("%.2f", p.rpe_trans_max_cm) + cell("%.4f", p.rpe_rot_median_deg) +
         cell("%.3f", p.ate_m) + cell("%.1f", p.frame_time.mean) + "</tr>\n";
}

std::string summary(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  std::string html =
      heading("Summary",
              "Objects are counted by the frame. The last row of a rate pools them; its mask IoU is the mean over the "
              "sequences, its camera figures those of the worst one.") +
      "<div class=\"card scroll\"><table><thead><tr><th>sequence</th><th>masks</th><th>object<br/>frames</th>"
      "<th>moving<br/>F1</th><th>preci-<br/>sion</th><th>recall</th><th>decided</th><th>static<br/>as moving</th>"
      "<th>static<br/>kept</th><th>mask<br/>IoU</th><th>instance<br/>IoU</th><th>id<br/>switches</th>"
      "<th>camera<br/>cm</th><th>worst<br/>cm</th><th>camera<br/>deg</th><th>ATE<br/>m</th><th>ms</th></tr></thead>"
      "<tbody>\n";
  for (const Pooled& p : pooled) {
    for (const RunScore& run : runs)
      if (run.every == p.every) html += run_row(run);
    if (p.runs > p.failed) html += pooled_row(p);
  }
  return html + "</tbody></table></div>\n";
}

std::string decision_plots(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  const std::vector<std::string> names = measured_names(runs);
  if (names.empty()) return "";
  const auto per_sequence = [&](auto&& figure) {
    return by_rate(pooled, names.size(), [&](const Pooled& p, std::size_t i) {
      const RunScore* run = find_run(runs, names[i], p.every);
      return run != nullptr && run->objects ? figure(*run->objects) : not_a_number;
    });
  };
  const ChartSize wide{1140, 220};
  const std::vector<Series> f1 = per_sequence([](const ObjectScore& o) { return o.confusion.f1(); });
  const std::vector<Series> iou = per_sequence([](const ObjectScore& o) { return o.mask_iou(); });
  return heading("By mask rate", "How much is lost when the network sees only some of the frames.") +
         "<div class=\"grid\">\n" + card("moving F1", grouped_bars(wide, names, f1, 1), f1) +
         card("moving mask IoU", grouped_bars(wide, names, iou, 1), iou) + "</div>\n";
}

std::string range_plots(const std::vector<Pooled>& pooled) {
  std::vector<std::string> bands;
  for (const char* name : band_names) bands.push_back(name + std::string(" m"));
  const auto per_band = [&](auto&& figure) {
    return by_rate(pooled, band_count, [&](const Pooled& p, std::size_t i) { return figure(p.bands[i]); });
  };
  const ChartSize size{540, 220};
  const std::vector<Series> f1 = per_band([](const Band& b) { return b.confusion.f1(); });
  const std::vector<Series> decided = per_band([](const Band& b) { return b.confusion.decided_share(); });
  const std::vector<Series> nees = per_band([](const Band& b) { return b.nees_per_axis(); });
  const std::vector<Series> within = per_band([](const Band& b) { return b.within_95(); });
  return heading("By range",
                 "All sequences together. Below, how truly the stated sigmas tell the error of standing "
                 "objects' velocities.") +
         "<div class=\"grid two\">\n" + card("moving F1", grouped_bars(size, bands, f1, 1), f1) +
         card("share of objects decided", grouped_bars(size, bands, decided, 1), decided) +
         card("NEES per axis, standing objects; 1 is right", grouped_bars(size, bands, nees, 0, 1.0), nees) +
         card("inside the 95 % ellipsoid; .95 is right", grouped_bars(size, bands, within, 1, 0.95), within) +
         "</div>\n";
}

std::string speed_plots(const std::vector<Pooled>& pooled) {
  const std::vector<std::string> names(speed_names, speed_names + speed_count);
  std::string html = heading("By true speed",
                             "What is said of objects of each speed, m/s; the number below is that "
                             "of object-frames.") +
                     "<div class=\"grid two\">\n";
  for (const Pooled& p : pooled) {
    std::vector<Series> parts{{"moving", "moving", {}},
                              {"static", "static", {}},
                              {"not observable", "unobservable", {}},
                              {"missed", "missed", {}}};
    const Answer order[] = {Answer::Moving, Answer::Static, Answer::NotObservable, Answer::Missed};
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (const auto& by_range : p.by_speed)
        parts[k].values.push_back(static_cast<double>(at_all_ranges(by_range)[static_cast<std::size_t>(order[k])]));
    html += card(rate_name(p.every), stacked_shares({540, 240}, names, parts), parts);
  }
  return html + "</div>\n";
}

std::vector<double> pixel_frames(const ObjectScore& score) {
  std::vector<double> frames;
  for (const FramePixels& f : score.pixels) frames.push_back(f.frame);
  return frames;
}

std::string pixel_plots(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  std::string plots;
  std::vector<Series> names;
  for (const std::string& name : measured_names(runs)) {
    std::vector<Series> series;
    std::vector<double> frames;
    Series truth{"moving in truth", "truth", {}};
    for (std::size_t k = 0; k < pooled.size(); ++k) {
      const RunScore* run = find_run(runs, name, pooled[k].every);
      if (run == nullptr || !run->objects) continue;
      frames = pixel_frames(*run->objects);
      series.push_back({rate_name(pooled[k].every), rate_colour(k), {}});
      truth.values.clear();
      for (const FramePixels& f : run->objects->pixels) {
        series.back().values.push_back(static_cast<double>(f.correct - f.wrong));
        truth.values.push_back(static_cast<double>(f.moving));
      }
    }
    if (series.empty()) continue;
    series.push_back(truth);
    if (series.size() > names.size()) names = series;
    plots += card(name, lines({370, 170}, frames, series));
  }
  if (plots.empty()) return "";
  return heading("Pixels, frame by frame",
                 "Pixels rightly labelled moving minus pixels wrongly labelled moving; the "
                 "dashed line is what can be reached.") +
         "<p>" + legend(names) + "</p>\n<div class=\"grid three\">\n" + plots + "</div>\n";
}

std::string camera_plots(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  std::string plots;
  std::vector<Series> names;
  for (const std::string& name : measured_names(runs)) {
    std::vector<Series> series;
    for (std::size_t k = 0; k < pooled.size(); ++k) {
      const RunScore* run = find_run(runs, name, pooled[k].every);
      if (run != nullptr && run->camera)
        series.push_back({rate_name(pooled[k].every), rate_colour(k), run->camera->step_cm});
    }
    if (series.empty()) continue;
    std::vector<double> steps;
    for (std::size_t i = 0; i < series[0].values.size(); ++i) steps.push_back(static_cast<double>(i + 1));
    if (series.size() > names.size()) names = series;
    plots += card(name, lines({370, 150}, steps, series));
  }
  if (plots.empty()) return "";
  const std::string stretches = stretch_lines(runs);
  return heading("Camera error, frame by frame",
                 "Translation error of each step, cm. " +
                     (stretches.empty() ? "No path is long enough for KITTI's error over stretches of 100 to 800 m."
                                        : "Over stretches of 100 to 800 m: " + stretches)) +
         "<p>" + legend(names) + "</p>\n<div class=\"grid three\">\n" + plots + "</div>\n";
}

std::string time_plots(const std::vector<RunScore>& runs) {
  std::vector<std::string> names;
  std::vector<Series> parts;
  for (std::size_t i = 0; i < stage_count; ++i)
    parts.push_back({dot::to_string(static_cast<dot::Stage>(i)), "stage" + std::to_string(i), {}});
  for (const RunScore& run : runs) {
    if (!run.error.empty() || run.frame_ms.empty()) continue;
    names.push_back(run.name + " " + short_rate(run.every));
    for (std::size_t i = 0; i < stage_count; ++i) parts[i].values.push_back(run.stage_ms[i]);
  }
  if (names.empty()) return "";
  return heading("Time", "Milliseconds a frame inside track, by stage, mean without the first frame.") +
         "<div class=\"grid\">\n" +
         card("ms a frame", stacked_rows({1140, 10 + 24 * static_cast<int>(names.size())}, names, parts, "%.1f"),
              parts) +
         "</div>\n";
}

std::string latency_table(const std::vector<RunScore>& runs) {
  std::string rows;
  for (const RunScore& run : runs)
    for (const LatencyEvent& event : run.latency)
      rows += "<tr><td>" + escaped(run.name) + "</td><td>" + short_rate(run.every) + "</td><td>" +
              std::to_string(event.id) + "</td><td>" + (event.starts ? "starts" : "stops") + "</td><td>" +
              std::to_string(event.frame) + "</td>" +
              (event.seconds ? cell("%.2f s", *event.seconds) : "<td class=\"weak\">never told</td>") + "</tr>\n";
  if (rows.empty()) return "";
  return heading("Decision latency",
                 "Objects that start or stop within 30 m: time from the event to the first right "
                 "answer.") +
         "<div class=\"card scroll\"><table><thead><tr><th>sequence</th><th>masks</th><th>object</th><th>event</th>"
         "<th>frame</th><th>told after</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string gallery(const std::vector<RunScore>& runs) {
  std::string html;
  for (const RunScore& run : runs)
    for (const Picture& picture : run.pictures)
      html += "<figure class=\"card\"><img alt=\"" + escaped(run.name) + ", frame " + std::to_string(picture.frame) +
              "\" src=\"data:image/jpeg;base64," + base64(picture.jpeg) + "\"/><figcaption><b>" + escaped(run.name) +
              ' ' + short_rate(run.every) + ", frame " + std::to_string(picture.frame) +
              "</b>: " + escaped(picture.title) + "</figcaption></figure>\n";
  if (html.empty()) return "";
  return heading("Pictures",
                 "Of each run the frame in which most moves and the worst of each half. Orange: called "
                 "moving; green: static; grey: not observable. White lines: what truly moves, however slowly; objects "
                 "too slow or without depth do not count.") +
         "<div class=\"grid two\">\n" + html + "</div>\n";
}

std::string intro(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  int frames = 0;
  for (const RunScore& run : runs)
    if (run.every == pooled.front().every) frames += run.frames;
  std::string remark;
  if (pooled.front().hidden.standing > 0)
    remark = " Every second mover is hidden, and all where there are no masks: the tracker gets no mask of it.";
  std::string rates;
  for (const Pooled& p : pooled) rates += (rates.empty() ? "" : ", ") + rate_name(p.every);
  const std::size_t sequences = measured_names(runs).size();
  return "<h1>What moves, and how well it is told</h1>\n<p>" + std::to_string(sequences) +
         (sequences == 1 ? " sequence, " : " sequences, ") + std::to_string(frames) + " frames; masks: " + rates + "." +
         remark + "</p>\n";
}

}  // namespace

std::string html_page(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>dot_eval</title>\n<style>" +
         style() + "</style></head>\n<body><main>\n" + intro(runs, pooled) + tiles(pooled) + summary(runs, pooled) +
         decision_plots(runs, pooled) + range_plots(pooled) + speed_plots(pooled) + pixel_plots(runs, pooled) +
         camera_plots(runs, pooled) + time_plots(runs) + latency_table(runs) + gallery(runs) +
         "</main></body></html>\n";
}

}  // namespace eval
