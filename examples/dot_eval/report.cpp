// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <cmath>
#include <string>

namespace eval {
namespace {

Json answers(const AnswerCounts& counts) {
  Json json = Json::object({});
  for (std::size_t i = 0; i < answer_count; ++i)
    if (counts[i] > 0) json.set(answer_names[i], counts[i]);
  return json;
}

Json confusion_counts(const Confusion& confusion) {
  Json json = Json::object({});
  for (std::size_t i = 0; i < answer_count; ++i)
    if (confusion.moving[i] > 0) json.set(std::string("moving->") + answer_names[i], confusion.moving[i]);
  for (std::size_t i = 0; i < answer_count; ++i)
    if (confusion.standing[i] > 0) json.set(std::string("static->") + answer_names[i], confusion.standing[i]);
  return json;
}

void set_decisions(Json& json, const Confusion& c) {
  json.set("object_frames", c.total());
  json.set("moving_precision", c.precision());
  json.set("moving_recall", c.recall());
  json.set("moving_f1", c.f1());
  json.set("decided_share", c.decided_share());
  json.set("decided_accuracy", c.decided_accuracy());
  json.set("static_kept_share", c.static_kept_share());
  json.set("static_moving_share", c.static_moving_share());
  json.set("missed_share", c.missed_share());
}

Json band(const Band& b) {
  return Json::object({{"moving", static_cast<long>(b.moving_speed_error.size())},
                       {"static", static_cast<long>(b.static_speed.size())},
                       {"moving_f1", b.confusion.f1()},
                       {"decided_share", b.confusion.decided_share()},
                       {"static_moving_share", b.confusion.static_moving_share()},
                       {"moving_speed_error_median_mps", median(b.moving_speed_error)},
                       {"moving_motion_error_m", median(b.motion_error_m)},
                       {"moving_motion_error_deg", median(b.motion_error_deg)},
                       {"static_speed_p90_mps", percentile(b.static_speed, 90)},
                       {"static_nees_per_axis", b.nees_per_axis()},
                       {"static_within_95", b.within_95()}});
}

Json bands(const std::array<Band, band_count>& list) {
  Json json = Json::object({});
  for (std::size_t i = 0; i < band_count; ++i) json.set(band_names[i], band(list[i]));
  return json;
}

Json speeds(const AnswersBySpeed& by_speed) {
  Json json = Json::object({});
  for (std::size_t i = 0; i < speed_count; ++i) {
    Json speed = answers(at_all_ranges(by_speed[i]));
    Json by_range = Json::object({});
    for (std::size_t b = 0; b <= band_count; ++b)
      by_range.set(b < band_count ? band_names[b] : "unknown", answers(by_speed[i][b]));
    speed.set("by_range_m", std::move(by_range));
    json.set(speed_names[i], std::move(speed));
  }
  return json;
}

Json numbers(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push(value);
  return json;
}

Json camera(const CameraScore& c) {
  Json json = Json::object({{"frames", c.frames},
                            {"path_m", c.path_m},
                            {"rpe_trans_cm", c.rpe_trans_cm()},
                            {"rpe_trans_median_cm", c.rpe_trans_median_cm()},
                            {"rpe_trans_max_cm", c.rpe_trans_max_cm()},
                            {"rpe_rot_deg", c.rpe_rot_deg()},
                            {"rpe_rot_median_deg", c.rpe_rot_median_deg()},
                            {"drift_percent", c.drift_percent},
                            {"ate_m", c.ate_m},
                            {"nees_per_axis", c.nees_per_axis()}});
  if (c.stretch)
    json.set("stretches", Json::object({{"count", c.stretch->stretches},
                                        {"translation_percent", c.stretch->translation_percent},
                                        {"rotation_deg_per_100m", c.stretch->rotation_deg_per_100m}}));
  else
    json.set("stretches", "absent: the path is too short for a stretch of 100 m");
  json.set("step_cm", numbers(c.step_cm));
  json.set("step_deg", numbers(c.step_deg));
  return json;
}

Json latencies(const std::vector<LatencyEvent>& events) {
  Json list = Json::array();
  for (const LatencyEvent& event : events)
    list.push(Json::object({{"id", event.id},
                            {"frame", event.frame},
                            {"event", event.starts ? "starts" : "stops"},
                            {"seconds", event.seconds ? Json(*event.seconds) : Json()},
                            {"metres", event.seconds ? Json(event.metres) : Json()}}));
  return Json::object({{"median_s", latency(events, 50)}, {"events", std::move(list)}});
}

Json told(const std::vector<LatencyEvent>& events, bool starts) {
  const std::vector<LatencyEvent> some = events_of(events, starts);
  return Json::object({{"events", static_cast<long>(some.size())},
                       {"median_s", latency(some, 50)},
                       {"worst_s", latency(some, 100)},
                       {"median_m", displacement(some, 50)},
                       {"worst_m", displacement(some, 100)}});
}

Json hidden(const HiddenScore& h) {
  return Json::object({{"movers", h.movers},
                       {"pixels", h.pixels},
                       {"found_share", h.found_share()},
                       {"standing_pixels", h.standing},
                       {"false_share", h.false_share()},
                       {"outside_share", h.outside_share()}});
}

Json frame_times(const FrameTime& t) {
  return Json::object({{"mean_ms", t.mean},
                       {"median_ms", t.median},
                       {"p99_ms", t.p99},
                       {"largest_ms", t.largest},
                       {"second_frame_ms", t.second}});
}

Json times(const StageTimes& stages, double total) {
  Json json = Json::object({});
  for (std::size_t i = 0; i < stage_count; ++i) json.set(dot::to_string(static_cast<dot::Stage>(i)), stages[i]);
  json.set("total", total);
  return json;
}

Json pixels(const std::vector<FramePixels>& frames) {
  Json list = Json::array();
  for (const FramePixels& f : frames)
    list.push(Json::array({f.frame, f.moving, f.correct, f.wrong, f.correct - f.wrong}));
  return Json::object(
      {{"columns", Json::array({"frame", "moving", "correct", "mislabelled", "correct_minus_mislabelled"})},
       {"frames", std::move(list)}});
}

void set_objects(Json& json, const ObjectScore& o) {
  set_decisions(json, o.confusion);
  json.set("moving_mask_iou", o.mask_iou());
  json.set("instance_iou_mean", mean(o.instance_iou));
  json.set("id_switches", o.id_switches);
  json.set("no_depth", o.no_depth);
  json.set("speed_coverage", o.speed_coverage());
  json.set("sigma_coverage", o.sigma_coverage());
  json.set("motion_coverage", o.motion_coverage());
  json.set("by_range_m", bands(o.bands));
  json.set("confusion", confusion_counts(o.confusion));
  json.set("by_true_speed_mps", speeds(o.by_speed));
  json.set("pixels", pixels(o.pixels));
}

Json run_json(const RunScore& run) {
  Json json = Json::object({{"name", run.name}, {"every", run.every}});
  if (!run.error.empty()) {
    json.set("error", run.error);
    return json;
  }
  json.set("frames", run.frames);
  const FrameTime time = frame_time(run.frame_ms);
  json.set("ms_per_frame", time.mean);
  json.set("time", frame_times(time));
  json.set("stage_ms", times(run.stage_ms, time.mean));
  if (run.objects) {
    set_objects(json, *run.objects);
    json.set("latency", latencies(run.latency));
  }
  if (run.camera) json.set("camera", camera(*run.camera));
  if (run.hidden) json.set("hidden_movers", hidden(*run.hidden));
  return json;
}

Json pooled_json(const Pooled& p) {
  Json json = Json::object({{"runs", p.runs}, {"failed_runs", p.failed}});
  set_decisions(json, p.confusion);
  json.set("moving_mask_iou", p.mask_iou);
  json.set("iou_ratio_mean", p.iou_ratio_mean);
  json.set("iou_ratio_min", p.iou_ratio_min);
  json.set("instance_iou_mean", p.instance_iou);
  json.set("id_switches", p.id_switches);
  json.set("near_speed_error_mps", p.near_speed_error);
  json.set("near_motion_error_m", p.near_motion_error_m);
  json.set("near_motion_error_deg", p.near_motion_error_deg);
  for (std::size_t i = 0; i + 1 < band_count; ++i) {
    json.set(std::string("static_nees_") + band_names[i], p.bands[i].nees_per_axis());
    json.set(std::string("static_within_95_") + band_names[i], p.bands[i].within_95());
  }
  json.set("turning", Json::object({{"object_frames", p.turning.moving_total()}, {"moving", p.turning.recall()}}));
  json.set("speed_coverage", p.speed_coverage);
  json.set("sigma_coverage", p.sigma_coverage);
  json.set("motion_coverage", p.motion_coverage);
  json.set("rpe_trans_median_cm", p.rpe_trans_median_cm);
  json.set("rpe_trans_cm", p.rpe_trans_cm);
  json.set("rpe_trans_max_cm", p.rpe_trans_max_cm);
  json.set("rpe_rot_median_deg", p.rpe_rot_median_deg);
  json.set("ate_m", p.ate_m);
  json.set("camera_nees_per_axis", p.camera_nees);
  json.set("by_range_m", bands(p.bands));
  json.set("confusion", confusion_counts(p.confusion));
  json.set("by_true_speed_mps", speeds(p.by_speed));
  json.set("latency_median_s", latency(p.latency, 50));
  json.set("latency_events", static_cast<long>(p.latency.size()));
  for (const bool starts : {true, false}) json.set(starts ? "starts" : "stops", told(p.latency, starts));
  if (p.hidden.standing > 0) json.set("hidden_movers", hidden(p.hidden));
  json.set("time", frame_times(p.frame_time));
  json.set("stage_ms", times(p.stage_ms, p.frame_time.mean));
  return json;
}

}  // namespace

Json report(const Arguments& arguments, const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled) {
  Json list = Json::array();
  for (const RunScore& run : runs) list.push(run_json(run));
  Json rates = Json::object({});
  for (const Pooled& p : pooled) rates.set(std::to_string(p.every), pooled_json(p));
  const Json settings = Json::object({{"min_speed_mps", arguments.scoring.min_speed},
                                      {"from_frame", arguments.scoring.from},
                                      {"hide_movers", arguments.hide_movers}});
  return Json::object({{"settings", settings}, {"runs", std::move(list)}, {"pooled", std::move(rates)}});
}

}  // namespace eval
