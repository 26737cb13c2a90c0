// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <vector>

#include "dot/image/view.hpp"
#include "dot/pipeline/result.hpp"

/// A result made by hand: paint tracks, then take `result`.
class HandMadeResult {
 public:
  explicit HandMadeResult(cv::Size size) : labels_(size, CV_8UC1, cv::Scalar(0)), ids_(size, CV_32SC1, cv::Scalar(0)) {
    objects_.reserve(max_objects);
  }

  /// A track that covers `area`; the reference stays valid.
  dot::ObjectResult& add(std::uint32_t id, dot::State state, const cv::Rect& area) {
    labels_(area).setTo(static_cast<int>(state));
    ids_(area).setTo(static_cast<int>(id));
    if (objects_.size() == max_objects) throw std::length_error("HandMadeResult: too many objects");
    objects_.emplace_back();
    objects_.back().id = id;
    objects_.back().state = state;
    return objects_.back();
  }

  dot::Result result() const {
    dot::Result result;
    result.labels = {labels_.ptr<std::uint8_t>(), labels_.cols, labels_.rows,
                     static_cast<std::ptrdiff_t>(labels_.step)};
    result.ids = {reinterpret_cast<const std::uint32_t*>(ids_.ptr<int>()), ids_.cols, ids_.rows,
                  static_cast<std::ptrdiff_t>(ids_.step)};
    result.objects = {objects_.data(), objects_.size()};
    return result;
  }

 private:
  static constexpr std::size_t max_objects = 8;

  cv::Mat labels_;
  cv::Mat ids_;
  std::vector<dot::ObjectResult> objects_;
};
