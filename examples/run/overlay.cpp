// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "dot/image/opencv.hpp"
#include "labels.hpp"
#include "sequence/text.hpp"
#include "turning.hpp"

namespace runner {
namespace {

constexpr int strip_height = 30;
const cv::Scalar strip_colour(34, 29, 26);
const cv::Scalar quiet_text(176, 168, 160);
const cv::Scalar bright_text(238, 234, 230);

/// How a state looks, colours in BGR.
struct Style {
  cv::Scalar colour;
  cv::Scalar text;
  float fill;        ///< share of the colour inside the object
  float saturation;  ///< of the picture inside the object
  float line;        ///< opacity of the outline
};

const Style& style_of(dot::State state) {
  static const Style moving{{20, 92, 255}, {255, 255, 255}, 0.46F, 1.0F, 1.0F};
  static const Style standing{{96, 214, 72}, {16, 48, 10}, 0.04F, 1.0F, 1.0F};
  static const Style undecided{{190, 190, 190}, {40, 40, 40}, 0.42F, 0.0F, 0.7F};
  if (state == dot::State::Moving) return moving;
  if (state == dot::State::Static) return standing;
  return undecided;
}

int zoom_of(const dot::Result& result) {
  constexpr double wanted_width = 1240;
  return std::clamp(static_cast<int>(std::lround(wanted_width / result.labels.width)), 1, 4);
}

cv::Mat enlarged_bgr(const cv::Mat& image, int zoom) {
  cv::Mat bgr, large;
  if (image.channels() == 3) bgr = image;
  if (image.channels() == 1) cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  if (image.channels() == 4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  cv::resize(bgr, large, {}, zoom, zoom, zoom > 1 ? cv::INTER_CUBIC : cv::INTER_NEAREST);
  return zoom > 1 ? large : large.clone();
}

/// Tints the part of the picture that `coverage` (0 to 255, with soft edges) covers and outlines it.
void paint(cv::Mat picture, const cv::Mat& coverage, const Style& style) {
  const auto mix = [](float from, float to, float share) { return from + share * (to - from); };
  for (int y = 0; y < picture.rows; ++y) {
    auto* pixel = picture.ptr<cv::Vec3b>(y);
    const auto* covered = coverage.ptr<std::uint8_t>(y);
    for (int x = 0; x < picture.cols; ++x) {
      if (covered[x] == 0) continue;
      const float inside = static_cast<float>(covered[x]) / 255.0F;
      // The outline runs where the soft edge is half covered.
      const float line = style.line * std::clamp(2.6F * (0.85F - std::abs(2 * inside - 1)), 0.0F, 1.0F);
      const float grey = 0.114F * pixel[x][0] + 0.587F * pixel[x][1] + 0.299F * pixel[x][2];
      for (int c = 0; c < 3; ++c) {
        const float old = pixel[x][c];
        const auto colour = static_cast<float>(style.colour[c]);
        const float tinted = mix(mix(grey, old, style.saturation), colour, style.fill);
        pixel[x][c] = cv::saturate_cast<std::uint8_t>(mix(mix(old, tinted, inside), colour, line));
      }
    }
  }
}

void draw_object(cv::Mat& picture, const cv::Mat& ids, const dot::ObjectResult& object, int zoom) {
  constexpr int margin = 6;
  const cv::Rect box =
      cv::Rect(object.box[0] - margin, object.box[1] - margin, object.box[2] + 2 * margin, object.box[3] + 2 * margin) &
      cv::Rect(0, 0, ids.cols, ids.rows);
  if (box.empty()) return;
  cv::Mat coverage;
  cv::resize(ids(box) == static_cast<double>(object.id), coverage, {}, zoom, zoom, cv::INTER_LINEAR);
  cv::GaussianBlur(coverage, coverage, {}, std::max(1.3, 0.8 * zoom), 0, cv::BORDER_REPLICATE);
  const cv::Rect large(box.x * zoom, box.y * zoom, box.width * zoom, box.height * zoom);
  paint(picture(large), coverage, style_of(object.state));
}

/// The speed of what stands is nothing but the fit's error, many m/s where it is far away.
std::string label_text(const dot::ObjectResult& object) {
  std::string text = "#" + std::to_string(object.id) + " ";
  text += object.state == dot::State::NotObservable ? "not observable" : dot::to_string(object.state);
  if (object.state == dot::State::Moving && object.reason == dot::Reason::None) text += " " + speed_label(object);
  return text;
}

/// @param objects moving ones first.
void draw_labels(cv::Mat& picture, const std::vector<const dot::ObjectResult*>& objects, int zoom) {
  LabelPlacer placer(picture.size());
  const auto box_of = [&](const dot::ObjectResult& object) {
    return cv::Rect(object.box[0] * zoom, object.box[1] * zoom, object.box[2] * zoom, object.box[3] * zoom);
  };
  const auto draw = [&](const dot::ObjectResult& object, LabelPlacer::Reach reach) {
    const Style& style = style_of(object.state);
    draw_label(picture, placer, reach, box_of(object), label_text(object), style.colour, style.text);
  };
  const auto first_other = std::find_if(objects.begin(), objects.end(),
                                        [](const auto* object) { return object->state != dot::State::Moving; });
  for (auto mover = objects.begin(); mover != first_other; ++mover) draw(**mover, LabelPlacer::Reach::Far);
  for (auto mover = objects.begin(); mover != first_other; ++mover) placer.block(box_of(**mover));
  for (auto other = first_other; other != objects.end(); ++other) draw(**other, LabelPlacer::Reach::Near);
}

int text_width(const std::string& text) { return cv::getTextSize(text, label_font, label_scale, 1, nullptr).width; }

void draw_text(cv::Mat& picture, const std::string& text, int x, const cv::Scalar& colour) {
  constexpr int baseline = 20;
  cv::putText(picture, text, {x, baseline}, label_font, label_scale, colour, 1, cv::LINE_AA);
}

/// Legend on the left, what is known of the frame on the right.
void draw_strip(cv::Mat strip, const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  strip.setTo(strip_colour);
  constexpr int gap = 24;
  int x = 14;
  const std::array<std::pair<dot::State, const char*>, 3> legend{
      {{dot::State::Moving, "moving"}, {dot::State::Static, "static"}, {dot::State::NotObservable, "not observable"}}};
  for (const auto& [state, name] : legend) {
    const Style& style = style_of(state);
    const cv::Rect swatch(x, 9, 18, 12);
    cv::rectangle(strip, swatch, strip_colour + 1.4 * style.fill * (style.colour - strip_colour), cv::FILLED);
    cv::rectangle(strip, swatch, style.colour, 1, cv::LINE_AA);
    x += swatch.width + 8;
    draw_text(strip, name, x, bright_text);
    x += text_width(name) + gap;
  }

  const dot::CameraResult& camera = result.camera;
  const double step =
      std::sqrt(camera.T_cur_prev[3] * camera.T_cur_prev[3] + camera.T_cur_prev[7] * camera.T_cur_prev[7] +
                camera.T_cur_prev[11] * camera.T_cur_prev[11]);
  std::string motion = "camera " + format("%.1f m/s", result.interval > 0 ? step / result.interval : 0);
  if (camera.status == dot::CameraStatus::FirstFrame) motion = "first frame";
  if (camera.status == dot::CameraStatus::TooLittleDepth) motion = "camera: too little depth";
  if (camera.status == dot::CameraStatus::Lost) motion = "camera lost";
  const std::array<std::string, 4> facts{format("%.1f ms", total_ms), "frame " + frame_name(frame.number, ""), motion,
                                         frame.ids.empty() ? "masks propagated" : "masks from network"};
  int right = strip.cols - 14;
  for (const std::string& fact : facts) {
    right -= text_width(fact);
    if (right < x) break;
    draw_text(strip, fact, right, quiet_text);
    right -= gap;
  }
}

}  // namespace

cv::Mat draw_overlay(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  const int zoom = zoom_of(result);
  const cv::Mat ids = dot::to_mat(result.ids);
  cv::Mat canvas(result.labels.height * zoom + strip_height, result.labels.width * zoom, CV_8UC3);
  cv::Mat picture = canvas.rowRange(0, result.labels.height * zoom);
  enlarged_bgr(frame.image, zoom).copyTo(picture);

  std::vector<const dot::ObjectResult*> objects;
  for (const dot::ObjectResult& object : result.objects)
    if (object.area > 0) objects.push_back(&object);
  // What matters most is drawn last, and gets the best place for its label.
  std::sort(objects.begin(), objects.end(), [](const auto* a, const auto* b) {
    const bool a_moves = a->state == dot::State::Moving;
    const bool b_moves = b->state == dot::State::Moving;
    return a_moves != b_moves ? a_moves : a->area > b->area;
  });
  for (auto object = objects.rbegin(); object != objects.rend(); ++object) draw_object(picture, ids, **object, zoom);
  draw_labels(picture, objects, zoom);
  draw_strip(canvas.rowRange(picture.rows, canvas.rows), frame, result, total_ms);
  return canvas;
}

}  // namespace runner
