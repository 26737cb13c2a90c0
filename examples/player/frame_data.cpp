// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "frame_data.hpp"

#include <cmath>
#include <string>

#include "dot/image/opencv.hpp"
#include "explanation.hpp"
#include "run/turning.hpp"

namespace player {
namespace {

using page::Json;

/// Fewer digits make a smaller page.
double rounded(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  return std::round(value * scale) / scale;
}

void set_finite(Json& object, const char* name, double value, int decimals) {
  if (std::isfinite(value)) object.set(name, rounded(value, decimals));
}

Json flat(const std::vector<cv::Point>& points) {
  Json list = Json::array();
  for (const cv::Point& point : points) {
    list.push(point.x);
    list.push(point.y);
  }
  return list;
}

Json list_of(const Outlines& outlines) {
  Json list = Json::array();
  for (const std::vector<cv::Point>& outline : outlines) list.push(flat(outline));
  return list;
}

double length(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Json camera_data(const dot::Result& result, const FrameDrawing& drawing) {
  const dot::CameraResult& camera = result.camera;
  Json json = Json::object({{"status", dot::to_string(camera.status)}, {"words", in_words(camera.status)}});
  const auto& T = camera.T_cur_prev;
  if (result.interval > 0) set_finite(json, "speed", length({T[3], T[7], T[11]}) / result.interval, 2);
  if (camera.status == dot::CameraStatus::Tracked) {
    set_finite(json, "phi", camera.phi, 3);
    json.set("points", camera.n_points);
    json.set("inliers", camera.n_inliers);
  }
  if (!drawing.revised.empty()) {
    Json revised = Json::array();
    for (const RevisedMotion& motion : drawing.revised) {
      Json item = Json::object({{"frame", static_cast<long>(motion.frame_id)}});
      set_finite(item, "wrong", motion.metres, 3);
      revised.push(item);
    }
    json.set("revised", revised);
  }
  return json;
}

void set_measurement(Json& json, const dot::ObjectResult& object, const dot::Options& options) {
  set_finite(json, "speed", object.speed, 3);
  set_finite(json, "sigma", sigma_of_length(object.velocity, object.velocity_covariance), 3);
  set_finite(json, "pointSpeed", object.point_speed, 3);
  set_finite(json, "pointSigma", object.point_speed_sigma, 3);
  if (runner::mostly_turns(object)) json.set("turning", true);
  if (options.classifier == dot::ClassifierKind::Velocity)
    set_finite(json, "limit", options.velocity.v0_at(object.range), 3);
  set_finite(json, "phi", object.phi, 3);
  set_finite(json, "range", object.range, 2);
  json.set("points", object.n_points);
  json.set("inliers", object.n_inliers);
}

Json object_data(const dot::ObjectResult& object, const dot::Result& result, const FrameDrawing& drawing,
                 const dot::Options& options) {
  Json json = Json::object({{"id", static_cast<long>(object.id)},
                            {"state", dot::to_string(object.state)},
                            {"reason", dot::to_string(object.reason)},
                            {"words", in_words(object.reason)},
                            {"why", explanation(object, options)},
                            {"class", object.class_id},
                            {"segmented", object.segmented},
                            {"area", object.area},
                            {"box", Json::array({object.box[0], object.box[1], object.box[2], object.box[3]})}});
  set_finite(json, "p", object.p_moving, 4);
  set_finite(json, "score", object.score, 3);
  if (object.last_decided != dot::State::NotObservable) json.set("decided", dot::to_string(object.last_decided));
  if (object.always_dynamic) json.set("always", true);
  if (object.discovered) json.set("discovered", true);
  if (object.reason == dot::Reason::None) set_measurement(json, object, options);
  if (object.fused_covariance[0] > 0) {
    set_finite(json, "fused", length(object.fused_velocity), 3);
    set_finite(json, "fusedSigma", sigma_of_length(object.fused_velocity, object.fused_covariance), 3);
  }
  const cv::Rect box(object.box[0], object.box[1], object.box[2], object.box[3]);
  if (object.area > 0) {
    const cv::Mat mask = dot::to_mat(result.ids)(box) == static_cast<double>(object.id);
    json.set("outline", list_of(outlines_of(mask, box.tl())));
  }
  if (const auto found = drawing.predicted.find(object.id); found != drawing.predicted.end() && !found->second.empty())
    json.set("predicted", list_of(found->second));
  if (const auto found = drawing.points.find(object.id); found != drawing.points.end())
    json.set("texture", flat(found->second));
  return json;
}

}  // namespace

Json frame_data(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms,
                const FrameDrawing& drawing, const dot::Options& options) {
  const dot::Frame input = frame.frame();
  Json json = Json::object({{"frame", frame.number}, {"masks", input.masks.has_value()}});
  set_finite(json, "time", result.timestamp, 4);
  set_finite(json, "interval", result.interval, 4);
  set_finite(json, "ms", total_ms, 2);
  json.set("camera", camera_data(result, drawing));
  Json objects = Json::array();
  for (const dot::ObjectResult& object : result.objects) objects.push(object_data(object, result, drawing, options));
  json.set("objects", objects);
  if (input.masks) {
    Json network = Json::array();
    for (const Outlines& outlines : outlines_of(*input.masks)) network.push(list_of(outlines));
    json.set("network", network);
  }
  if (const auto found = drawing.points.find(0); found != drawing.points.end())
    json.set("texture", flat(found->second));
  return json;
}

}  // namespace player
