// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef DOT_CAPI_EXPORTS
#define DOT_CAPI_EXPORTS
#endif
#include "dot/dot.h"

#include <cstdio>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "dot/pipeline/exclusion.hpp"
#include "dot/tracker.hpp"
#include "dot/version.hpp"
#include "marshal.hpp"

static_assert(DOT_HEADER_VERSION == DOT_VERSION_MAJOR * 1000000 + DOT_VERSION_MINOR * 1000 + DOT_VERSION_PATCH,
              "dot/dot.h and dot/version.hpp must state the same version");

using namespace dot_c;  // NOLINT(google-build-using-namespace): marshal.hpp is this file's other half

namespace {

/// A message in memory of its own: reporting that memory is short must not take any.
struct ErrorText {
  char text[512];

  void set(const char* message) noexcept { std::snprintf(text, sizeof text, "%s", message); }
  void clear() noexcept { text[0] = '\0'; }
};

thread_local ErrorText create_error;

struct NoResult : std::logic_error {
  NoResult() : std::logic_error("no result: no frame was tracked yet, or none since a reset or a failure") {}
};

}  // namespace

struct dot_tracker {
  dot_tracker(const dot::Intrinsics& camera, const dot::Options& options) : tracker(camera, options) { error.clear(); }

  dot::Tracker tracker;
  const dot::Result* result = nullptr;   // of the tracker's last frame; null when there is none
  std::vector<dot::Instance> instances;  // of the frame being tracked; here to keep its memory
  ErrorText error;
};

namespace {

/// Runs `body` and turns what it throws into a status; status and text are set here and nowhere else.
template <typename Body>
dot_status guard(ErrorText& error, Body&& body) noexcept {
  error.clear();
  const auto fail = [&error](dot_status status, const char* message) noexcept {
    error.set(message);
    return status;
  };
  try {
    body();
    return DOT_OK;
  } catch (const std::invalid_argument& e) {
    return fail(DOT_INVALID_ARGUMENT, e.what());
  } catch (const NoResult& e) {
    return fail(DOT_NO_RESULT, e.what());
  } catch (const std::bad_alloc&) {
    return fail(DOT_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& e) {
    return fail(DOT_INTERNAL, e.what());
  } catch (...) {
    return fail(DOT_INTERNAL, "unknown exception");
  }
}

/// The same for a call on a tracker. Whatever interrupts one half-way leaves a state that nobody has planned; the
/// tracker starts afresh from there.
template <typename Body>
dot_status guard(dot_tracker* tracker, Body&& body) noexcept {
  if (tracker == nullptr) return DOT_INVALID_ARGUMENT;
  const dot_status status = guard(tracker->error, body);
  if (status == DOT_OUT_OF_MEMORY || status == DOT_INTERNAL) {
    tracker->result = nullptr;
    try {
      tracker->tracker.reset();
    } catch (...) {
      tracker->error.set("the tracker could not be reset after a failure");
      return DOT_INTERNAL;
    }
  }
  return status;
}

const dot::Result& result_of(const dot_tracker* tracker) {
  if (tracker->result == nullptr) throw NoResult();
  return *tracker->result;
}

}  // namespace

uint32_t dot_version(void) noexcept { return DOT_HEADER_VERSION; }

const char* dot_status_string(dot_status status) noexcept {
  switch (status) {
    case DOT_OK: return "ok";
    case DOT_INVALID_ARGUMENT: return "invalid argument";
    case DOT_NO_RESULT: return "no result";
    case DOT_OUT_OF_MEMORY: return "out of memory";
    case DOT_INTERNAL: return "internal error";
    default: return "unknown status";
  }
}

dot_status dot_options_init(dot_options* options, uint32_t struct_size) noexcept {
  return guard(create_error, [&] {
    if (options == nullptr) invalid("options is NULL");
    check_size<dot_options>(struct_size, "options");
    const dot::Options defaults;
    dot_options out{};
    out.struct_size = struct_size;
    out.classifier = DOT_CLASSIFIER_VELOCITY;
    out.depth_source = DOT_DEPTH_UNKNOWN;
    out.background_points = defaults.selection.background_points;
    out.object_points = defaults.selection.object_points;
    out.v0 = defaults.velocity.v0;
    out.stereo_sigma_px = defaults.depth_noise.stereo_sigma_px;
    std::memcpy(options, &out, struct_size);
  });
}

dot_status dot_create(const dot_camera* camera, const dot_options* options, dot_tracker** out) noexcept {
  return guard(create_error, [&] {
    if (out == nullptr) invalid("out is NULL");
    *out = nullptr;
    const dot::Intrinsics intrinsics = read_camera(camera);
    *out = new dot_tracker(intrinsics, read_options(options));
  });
}

const char* dot_create_error(void) noexcept { return create_error.text; }

void dot_destroy(dot_tracker* tracker) noexcept { delete tracker; }

dot_status dot_reset(dot_tracker* tracker) noexcept {
  return guard(tracker, [&] {
    tracker->result = nullptr;
    tracker->tracker.reset();
  });
}

dot_status dot_track(dot_tracker* tracker, const dot_frame* frame) noexcept {
  return guard(tracker, [&] { tracker->result = &tracker->tracker.track(read_frame(frame, tracker->instances)); });
}

dot_status dot_object_count(dot_tracker* tracker, uint32_t* count) noexcept {
  return guard(tracker, [&] {
    if (count == nullptr) invalid("count is NULL");
    *count = 0;
    *count = static_cast<std::uint32_t>(result_of(tracker).objects.size);
  });
}

dot_status dot_get_object(dot_tracker* tracker, uint32_t index, dot_object* out) noexcept {
  return guard(tracker, [&] {
    const dot::Span<dot::ObjectResult> objects = result_of(tracker).objects;
    if (index >= objects.size)
      invalid("index is " + std::to_string(index) + ", there are " + std::to_string(objects.size) + " objects");
    write(to_c(objects[index]), out, "out");
  });
}

dot_status dot_get_camera(dot_tracker* tracker, dot_camera_result* out) noexcept {
  return guard(tracker, [&] { write(to_c(result_of(tracker)), out, "out"); });
}

dot_status dot_label_image(dot_tracker* tracker, dot_image* out) noexcept {
  return guard(tracker, [&] { write(to_c(result_of(tracker).labels, DOT_FORMAT_LABEL8), out, "out"); });
}

dot_status dot_id_image(dot_tracker* tracker, dot_image* out) noexcept {
  return guard(tracker, [&] { write(to_c(result_of(tracker).ids, DOT_FORMAT_ID32), out, "out"); });
}

dot_status dot_exclusion_mask(dot_tracker* tracker, const dot_exclusion_policy* policy, uint8_t* data, int32_t width,
                              int32_t height, int64_t stride_bytes) noexcept {
  return guard(tracker, [&] {
    const dot::Result& result = result_of(tracker);
    const dot::ExclusionPolicy exclusion = read_policy(policy);
    if (data == nullptr) invalid("data is NULL");
    if (width != result.labels.width)
      invalid("width is " + std::to_string(width) + ", the label image has " + std::to_string(result.labels.width));
    if (height != result.labels.height)
      invalid("height is " + std::to_string(height) + ", the label image has " + std::to_string(result.labels.height));
    if (stride_bytes < width || stride_bytes > std::numeric_limits<std::ptrdiff_t>::max() / height)
      invalid("stride_bytes is " + std::to_string(stride_bytes) + ", a row takes " + std::to_string(width));
    dot::exclusion_mask(result, exclusion, {data, width, height, static_cast<std::ptrdiff_t>(stride_bytes)});
  });
}

const char* dot_last_error(const dot_tracker* tracker) noexcept {
  return tracker != nullptr ? tracker->error.text : "tracker is NULL";
}
