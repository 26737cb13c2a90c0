// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "dot/dot.h"
#include "fuzz/input.hpp"

/// @file
/// What dot.h promises of every call, whatever was handed in.

namespace fuzz {

/// A status that the caller's mistakes and nothing else can bring about, with a text in one line. @return the status.
inline dot_status check_status(dot_status status, const char* text) {
  FUZZ_DEMAND_FOR(status == DOT_OK || status == DOT_INVALID_ARGUMENT || status == DOT_NO_RESULT, text);
  FUZZ_DEMAND((text[0] == '\0') == (status == DOT_OK));
  for (const char* c = text; *c != '\0'; ++c) FUZZ_DEMAND_FOR(static_cast<unsigned char>(*c) >= ' ', text);
  return status;
}
inline dot_status check_status(dot_status status, const dot_tracker* tracker) {
  return check_status(status, dot_last_error(tracker));
}

/// A struct to be filled in, as a caller with this struct_size has it, and what lies behind it.
template <typename T>
class Output {
 public:
  explicit Output(std::uint32_t struct_size = sizeof(T)) : size_(struct_size) {
    std::memset(memory_, 0xa5, sizeof memory_);
    std::memcpy(memory_, &struct_size, sizeof struct_size);
  }
  T* get() { return reinterpret_cast<T*>(memory_); }
  /// That nothing was written behind the struct, and nothing at all by a call that failed.
  const T& check(dot_status status) {
    const std::size_t end = status == DOT_OK ? size_ : sizeof size_;
    FUZZ_DEMAND(end <= sizeof(T));
    for (std::size_t i = end; i < sizeof memory_; ++i) FUZZ_DEMAND(memory_[i] == 0xa5);
    FUZZ_DEMAND(std::memcmp(memory_, &size_, sizeof size_) == 0);
    return *get();
  }

 private:
  std::uint32_t size_;
  alignas(T) unsigned char memory_[sizeof(T) + 64];
};

/// The last result, copied out.
struct Answer {
  dot_status status = DOT_NO_RESULT;
  dot_camera_result camera = DOT_CAMERA_RESULT_INIT;
  std::vector<dot_object> objects;
  std::vector<dot_camera_revision> revised;
  std::vector<std::uint8_t> labels;
  std::vector<std::uint32_t> ids;

  bool operator==(const Answer& o) const {
    const auto same = [](const auto& a, const auto& b) {
      return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
    };
    return status == o.status && std::memcmp(&camera, &o.camera, sizeof camera) == 0 && same(objects, o.objects) &&
           same(revised, o.revised) && same(labels, o.labels) && same(ids, o.ids);
  }
};

inline Answer read_answer(dot_tracker* tracker, int width, int height) {
  Answer out;
  std::uint32_t count = 0;
  out.status = check_status(dot_object_count(tracker, &count), tracker);
  if (out.status != DOT_OK) return out;
  FUZZ_DEMAND(check_status(dot_get_camera(tracker, &out.camera), tracker) == DOT_OK);
  for (std::uint32_t i = 0; i < count; ++i) {
    dot_object object = DOT_OBJECT_INIT;
    FUZZ_DEMAND(check_status(dot_get_object(tracker, i, &object), tracker) == DOT_OK);
    out.objects.push_back(object);
  }
  dot_object beyond = DOT_OBJECT_INIT;
  FUZZ_DEMAND(check_status(dot_get_object(tracker, count, &beyond), tracker) == DOT_INVALID_ARGUMENT);
  FUZZ_DEMAND(check_status(dot_revision_count(tracker, &count), tracker) == DOT_OK);
  for (std::uint32_t i = 0; i < count; ++i) {
    dot_camera_revision revision = DOT_CAMERA_REVISION_INIT;
    FUZZ_DEMAND(check_status(dot_get_revision(tracker, i, &revision), tracker) == DOT_OK);
    out.revised.push_back(revision);
  }
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  out.labels.resize(pixels);
  out.ids.resize(pixels);
  FUZZ_DEMAND(check_status(dot_copy_labels(tracker, out.labels.data(), width, height, width), tracker) == DOT_OK);
  FUZZ_DEMAND(check_status(dot_copy_ids(tracker, out.ids.data(), width, height, 4 * static_cast<std::int64_t>(width)),
                           tracker) == DOT_OK);
  return out;
}

template <std::size_t N>
void check_finite(const double (&values)[N]) {
  for (const double v : values) FUZZ_DEMAND(std::isfinite(v));
}
/// Finite, with variances that are none below 0. @tparam N the square of its size
template <std::size_t N>
void check_covariance(const double (&values)[N]) {
  check_finite(values);
  constexpr std::size_t step = N == 36 ? 7 : 4;
  for (std::size_t i = 0; i < N; i += step) FUZZ_DEMAND_FOR(values[i] >= 0, std::to_string(values[i]).c_str());
}

inline void check_camera(const dot_camera_result& camera) {
  FUZZ_DEMAND(camera.status <= DOT_CAMERA_LOST);
  check_finite(camera.T_cur_prev);
  check_covariance(camera.covariance);
  check_finite({camera.timestamp, camera.interval, camera.phi, camera.gain, camera.offset, camera.residual_sigma,
                camera.normalised_variance});
  FUZZ_DEMAND(camera.interval >= 0);
  FUZZ_DEMAND(camera.masked_share >= 0 && camera.masked_share <= 1);
  FUZZ_DEMAND(camera.n_inliers >= 0 && camera.n_inliers <= camera.n_points);
}

inline void check_object(const dot_object& o) {
  FUZZ_DEMAND(o.id != 0);
  FUZZ_DEMAND(o.state >= DOT_STATE_STATIC && o.state <= DOT_STATE_NOT_OBSERVABLE);
  FUZZ_DEMAND(o.last_decided >= DOT_STATE_STATIC && o.last_decided <= DOT_STATE_NOT_OBSERVABLE);
  FUZZ_DEMAND(o.reason <= DOT_REASON_TOO_MANY_OBJECTS);
  FUZZ_DEMAND(o.flags <= (DOT_OBJECT_ALWAYS_DYNAMIC | DOT_OBJECT_SEGMENTED | DOT_OBJECT_DISCOVERED));
  FUZZ_DEMAND(o.p_moving >= 0 && o.p_moving <= 1);
  FUZZ_DEMAND(o.n_inliers >= 0 && o.n_inliers <= o.n_points);
  check_finite(o.T_o);
  check_covariance(o.covariance);
  check_finite(o.velocity);
  check_covariance(o.velocity_covariance);
  check_finite(o.angular_velocity);
  check_covariance(o.angular_covariance);
  FUZZ_DEMAND(o.point_speed >= 0 && o.point_speed_sigma >= 0);
  check_finite(o.fused_velocity);
  check_covariance(o.fused_covariance);
  check_finite({o.speed, o.point_speed, o.point_speed_sigma, o.phi, o.disparity_px, o.disparity_noise_px, o.entropy,
                o.range, o.interval});
}

/// That the images agree with the objects, pixel by pixel.
inline void check_pixels(const Answer& a, int width) {
  struct Extent {
    const dot_object* object = nullptr;
    int area = 0, left = 1 << 30, top = 1 << 30, right = 0, bottom = 0;
  };
  std::map<std::uint32_t, Extent> extents;
  for (const dot_object& o : a.objects) {
    FUZZ_DEMAND(extents.count(o.id) == 0);
    extents[o.id].object = &o;
  }
  for (std::size_t i = 0; i < a.ids.size(); ++i) {
    if (a.ids[i] == 0) {
      FUZZ_DEMAND(a.labels[i] == DOT_STATE_BACKGROUND);
      continue;
    }
    const auto found = extents.find(a.ids[i]);
    FUZZ_DEMAND(found != extents.end());
    Extent& e = found->second;
    FUZZ_DEMAND(a.labels[i] == e.object->state);
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    ++e.area;
    e.left = std::min(e.left, x), e.right = std::max(e.right, x + 1);
    e.top = std::min(e.top, y), e.bottom = std::max(e.bottom, y + 1);
  }
  for (const auto& [id, e] : extents) {
    FUZZ_DEMAND(e.object->area == e.area);
    const int box[4] = {e.left, e.top, e.right - e.left, e.bottom - e.top}, none[4] = {};
    FUZZ_DEMAND(std::memcmp(e.object->box, e.area > 0 ? box : none, sizeof box) == 0);
  }
}

inline void check_answer(const Answer& answer, int width) {
  check_camera(answer.camera);
  for (const dot_object& o : answer.objects) check_object(o);
  check_pixels(answer, width);
}

}  // namespace fuzz
