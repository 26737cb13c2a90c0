// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "dot/version.hpp"
#include "embedded.hpp"
#include "frame_data.hpp"
#include "page/base64.hpp"
#include "page/escape.hpp"
#include "page/json.hpp"
#include "page/style.hpp"

namespace player {
namespace fs = std::filesystem;

namespace {

using page::Json;

std::vector<std::uint8_t> jpeg_of(const cv::Mat& image) {
  constexpr int widest = 1280;  // pixels
  constexpr int quality = 82;
  cv::Mat picture = image;
  if (image.channels() == 4) cv::cvtColor(image, picture, cv::COLOR_BGRA2BGR);
  const double scale = std::min(1.0, static_cast<double>(widest) / picture.cols);
  if (scale < 1) {
    cv::Mat small;
    cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
    picture = small;
  }
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality});
  return jpeg;
}

Json run_data(const RunInfo& info) {
  Json json = Json::object({{"sequence", info.sequence},
                            {"version", DOT_VERSION_STRING},
                            {"width", info.camera.width},
                            {"height", info.camera.height},
                            {"minPhi", info.options.object.min_phi}});
  if (info.options.classifier == dot::ClassifierKind::Velocity) {
    json.set("decide", info.options.velocity.decide);
    json.set("keep", info.options.velocity.keep);
  }
  Json names = Json::array();
  for (const std::string& name : info.class_names) names.push(name);
  json.set("classNames", names);
  return json;
}

}  // namespace

Player::Player(fs::path path, const RunInfo& info)
    : path_(std::move(path)),
      options_(info.options),
      file_(path_),
      moved_outlines_(info.camera),
      point_finder_(info.camera, info.options),
      rest_(player_html) {
  copy_template_to("<!-- title -->");
  file_.stream() << page::escaped(info.sequence);
  copy_template_to("/* style */");
  file_.stream() << page::style_css << player_css;
  copy_template_to("<!-- frames -->");
  file_.stream() << "<script type=\"application/json\" id=\"run\">";
  run_data(info).write(file_.stream(), Json::one_line);
  file_.stream() << "</script>\n";
}

Player::~Player() {
  std::error_code error;
  if (!finished_) fs::remove(runner::partial_name(path_), error);
}

void Player::add(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms) {
  const FrameDrawing drawing{moved_outlines_.next(frame, result), point_finder_.find(frame, result),
                             revised_motions_.next(result)};
  file_.stream() << "<script type=\"application/json\" class=\"frame\">";
  frame_data(frame, result, total_ms, drawing, options_).write(file_.stream(), Json::one_line);
  file_.stream() << "</script>\n<script type=\"text/plain\" class=\"jpeg\">" << page::base64(jpeg_of(frame.image))
                 << "</script>\n";
  file_.flush();
}

void Player::finish() {
  copy_template_to("/* script */");
  file_.stream() << player_js << rest_;
  file_.finish();
  finished_ = true;
}

void Player::copy_template_to(std::string_view marker) {
  const std::size_t place = rest_.find(marker);
  if (place == std::string_view::npos) throw std::logic_error("player.html lacks " + std::string(marker));
  file_.stream() << rest_.substr(0, place);
  rest_.remove_prefix(place + marker.size());
}

}  // namespace player
