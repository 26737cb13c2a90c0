// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "run/overlay.hpp"

namespace eval {
namespace {

constexpr int width = 1000;  // pixels
constexpr int jpeg_quality = 76;

void outline_movers(cv::Mat& picture, const runner::TruthEntry& entry, const cv::Mat& instance) {
  const double zoom = static_cast<double>(picture.cols) / instance.cols;
  for (const auto& [id, object] : entry.objects) {
    if (!object.moving) continue;
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(instance == id, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    for (std::vector<cv::Point>& outline : outlines)
      for (cv::Point& point : outline)
        point = {static_cast<int>(std::lround((point.x + 0.5) * zoom - 0.5)),
                 static_cast<int>(std::lround((point.y + 0.5) * zoom - 0.5))};
    cv::polylines(picture, outlines, true, cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
  }
}

Picture draw(const runner::SequenceFrame& frame, const runner::TruthEntry& entry, const cv::Mat& instance,
             const dot::Result& result, double total_ms, std::string title) {
  cv::Mat overlay = runner::draw_overlay(frame, result, total_ms);
  if (!instance.empty()) outline_movers(overlay, entry, instance);
  const double scale = std::min(1.0, static_cast<double>(width) / overlay.cols);
  cv::Mat small;
  cv::resize(overlay, small, {}, scale, scale, cv::INTER_AREA);
  Picture picture;
  picture.frame = frame.number;
  picture.title = std::move(title);
  cv::imencode(".jpg", small, picture.jpeg, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
  return picture;
}

}  // namespace

void PictureBook::consider(int index, const runner::SequenceFrame& frame, const runner::TruthEntry& entry,
                           const cv::Mat& instance, const FramePixels& pixels, const dot::Result& result,
                           double total_ms) {
  // At the start nothing can be decided yet, which is no news.
  if (index < std::min(5, frames_ / 4)) return;
  const std::string title = std::to_string(pixels.moving) + " px move, " + std::to_string(pixels.missed()) +
                            " of them not found; " + std::to_string(pixels.wrong) + " px wrongly called moving";
  const std::size_t half = 2 * index < frames_ ? 0 : 1;
  const std::array<std::pair<std::size_t, long>, 2> values{
      {{half, pixels.missed() + pixels.wrong}, {2, pixels.moving}}};
  for (const auto& [slot, value] : values) {
    if (value <= slots_[slot].value) continue;
    slots_[slot].value = value;
    slots_[slot].picture = draw(frame, entry, instance, result, total_ms, title);
  }
}

std::vector<Picture> PictureBook::take() {
  std::vector<Picture> pictures;
  for (Slot& slot : slots_) {
    const bool is_new = std::none_of(pictures.begin(), pictures.end(),
                                     [&](const Picture& other) { return other.frame == slot.picture.frame; });
    if (slot.value >= 0 && is_new) pictures.push_back(std::move(slot.picture));
  }
  std::sort(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  return pictures;
}

}  // namespace eval
