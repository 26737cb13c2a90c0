// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef DOT_CAPI_EXPORTS
#define DOT_CAPI_EXPORTS
#endif
#include "dot/dot.h"

#include <atomic>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "dot/diagnosis/message.hpp"
#include "dot/pipeline/exclusion.hpp"
#include "dot/tracker.hpp"
#include "dot/version.hpp"
#include "marshal/frame.hpp"
#include "marshal/options.hpp"
#include "marshal/result.hpp"

static_assert(DOT_HEADER_VERSION == DOT_VERSION_MAJOR * 1000000 + DOT_VERSION_MINOR * 1000 + DOT_VERSION_PATCH,
              "dot/dot.h and dot/version.hpp must state the same version");

using namespace dot_c;  // NOLINT(google-build-using-namespace): marshal/ is a part of this file

namespace {

/// A message in a fixed buffer, because the report of a lack of memory must not allocate.
struct ErrorText {
  char text[512];

  /// Stores the text in one line, also if a message of another library has several.
  void set(const char* message) noexcept {
    std::snprintf(text, sizeof text, "%s", message);
    for (char* c = text; *c != '\0'; ++c)
      if (static_cast<unsigned char>(*c) < ' ') *c = ' ';
    for (std::size_t end = std::strlen(text); end > 0 && text[end - 1] == ' '; --end) text[end - 1] = '\0';
  }
  void clear() noexcept { text[0] = '\0'; }
};

thread_local ErrorText create_error;

struct NoResult : std::exception {
  const char* what() const noexcept override {
    return "no result: no frame was tracked yet, or none since a reset or a failure";
  }
};

}  // namespace

struct dot_tracker {
  dot_tracker(const dot::Intrinsics& camera, const dot::Options& options) : tracker(camera, options) { error.clear(); }

  dot::Tracker tracker;
  const dot::Result* result = nullptr;   // of the tracker's last frame; null if there is none
  std::vector<dot::Instance> instances;  // of the current call; a member to keep its memory
  ErrorText error;
  dot_log_function log = nullptr;
  void* log_user = nullptr;
  std::uint32_t camera_status = DOT_CAMERA_FIRST_FRAME;
  dot::DiagnosisNews news;
  bool diagnosis_is_new = false;  // of the last frame: it was not looked at yet
  std::atomic_flag busy = ATOMIC_FLAG_INIT;
};

namespace {

/// Runs `body` and turns its exceptions into a status. Status and text are set only here.
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

void log(const dot_tracker& tracker, std::uint32_t level, const char* text) noexcept {
  if (tracker.log == nullptr) return;
  try {
    tracker.log(tracker.log_user, level, text);
  } catch (...) {  // a host in C++ may throw; it cannot be handled here
  }
}

/// Holds a tracker for the duration of one call.
class Use {
 public:
  explicit Use(dot_tracker& tracker) noexcept
      : busy_(tracker.busy), granted_(!busy_.test_and_set(std::memory_order_acquire)) {}
  ~Use() {
    if (granted_) busy_.clear(std::memory_order_release);
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  bool granted() const noexcept { return granted_; }

 private:
  std::atomic_flag& busy_;
  bool granted_;
};

/// Forgets what was said of the frames so far, with these frames.
void forget(dot_tracker& tracker) noexcept {
  tracker.result = nullptr;
  tracker.camera_status = DOT_CAMERA_FIRST_FRAME;
  tracker.news.clear();
  tracker.diagnosis_is_new = false;
  tracker.tracker.reset();
}

/// The same for a call on a tracker. An interrupted call leaves an undefined state, so the tracker is reset.
template <typename Body>
dot_status guard(dot_tracker* tracker, Body&& body) noexcept {
  if (tracker == nullptr) return DOT_INVALID_ARGUMENT;
  const Use use(*tracker);
  if (!use.granted()) return DOT_BUSY;
  const dot_status status = guard(tracker->error, body);
  if (status == DOT_OUT_OF_MEMORY || status == DOT_INTERNAL) {
    forget(*tracker);
  }
  if (status != DOT_OK) log(*tracker, DOT_LOG_ERROR, tracker->error.text);
  return status;
}

/// Logs when the camera's motion becomes a guess, and when it is known again. A first frame has no motion.
void log_camera(dot_tracker& tracker, std::uint32_t status) noexcept {
  const auto guessed = [](std::uint32_t s) { return s == DOT_CAMERA_LOST || s == DOT_CAMERA_TOO_LITTLE_DEPTH; };
  const std::uint32_t before = tracker.camera_status;
  if (status == DOT_CAMERA_FIRST_FRAME) return;
  tracker.camera_status = status;
  if (status == DOT_CAMERA_LOST && before != status) {
    log(tracker, DOT_LOG_WARNING, "camera lost: its motion is guessed from the frames before");
  } else if (status == DOT_CAMERA_TOO_LITTLE_DEPTH && before != status) {
    log(tracker, DOT_LOG_WARNING, "too little depth: the camera's motion is guessed from the frames before");
  } else if (guessed(before) && !guessed(status)) {
    log(tracker, DOT_LOG_INFO, "the camera's motion is known again");
  }
}

/// Logs a suspicion when it appears. `label` leaves the diagnosis to what comes after it, see `end_last`.
void log_diagnosis(dot_tracker& tracker) noexcept {
  if (!tracker.diagnosis_is_new) return;
  tracker.diagnosis_is_new = false;
  const dot::Diagnosis& diagnosis = tracker.result->diagnosis;
  if (!tracker.news.add(diagnosis)) return;
  try {
    log(tracker, DOT_LOG_WARNING, ("suspicion " + dot::describe(diagnosis)).c_str());
  } catch (const std::bad_alloc&) {  // the frame is tracked all the same
  }
}

/// Ends the frame of a `label` before the next one, which would do it, too. Its suspicion would not be seen then.
void end_last(dot_tracker& tracker) {
  if (!tracker.diagnosis_is_new) return;
  tracker.tracker.prepare();
  log_diagnosis(tracker);
}

const dot::Result& result_of(const dot_tracker* tracker) {
  if (tracker->result == nullptr) throw NoResult();
  return *tracker->result;
}

}  // namespace

uint32_t dot_version(void) noexcept { return DOT_HEADER_VERSION; }

uint32_t dot_abi_version(void) noexcept { return DOT_ABI_VERSION; }

const char* dot_status_string(dot_status status) noexcept {
  switch (status) {
    case DOT_OK: return "ok";
    case DOT_INVALID_ARGUMENT: return "invalid argument";
    case DOT_NO_RESULT: return "no result";
    case DOT_OUT_OF_MEMORY: return "out of memory";
    case DOT_INTERNAL: return "internal error";
    case DOT_BUSY: return "busy";
    default: return "unknown status";
  }
}

dot_status dot_options_init(dot_options* options, uint32_t struct_size) noexcept {
  return guard(create_error, [&] {
    if (options == nullptr) invalid("options is NULL");
    check_size<dot_options>(struct_size, "options");
    dot_options out = DOT_OPTIONS_INIT;
    out.struct_size = struct_size;
    std::memcpy(options, &out, struct_size);
  });
}

dot_status dot_exclusion_policy_init(dot_exclusion_policy* policy, uint32_t struct_size) noexcept {
  return guard(create_error, [&] {
    if (policy == nullptr) invalid("policy is NULL");
    check_size<dot_exclusion_policy>(struct_size, "policy");
    dot_exclusion_policy out = DOT_EXCLUSION_POLICY_INIT;
    out.struct_size = struct_size;
    std::memcpy(policy, &out, struct_size);
  });
}

dot_status dot_create(const dot_camera* camera, const dot_options* options, dot_tracker** out) noexcept {
  return guard(create_error, [&] {
    if (out == nullptr) invalid("out is NULL");
    *out = nullptr;
    const dot::Intrinsics intrinsics = read_camera(camera);
    *out = std::make_unique<dot_tracker>(intrinsics, read_options(options)).release();
  });
}

const char* dot_create_error(void) noexcept { return create_error.text; }

void dot_destroy(dot_tracker* tracker) noexcept { delete tracker; }

dot_status dot_set_log(dot_tracker* tracker, dot_log_function function, void* user) noexcept {
  return guard(tracker, [&] {
    tracker->log = function;
    tracker->log_user = user;
  });
}

dot_status dot_reset(dot_tracker* tracker) noexcept {
  return guard(tracker, [&] { forget(*tracker); });
}

dot_status dot_track(dot_tracker* tracker, const dot_frame* frame) noexcept {
  return guard(tracker, [&] {
    end_last(*tracker);
    tracker->result = &tracker->tracker.track(read_frame(frame, tracker->instances));
    tracker->diagnosis_is_new = true;
    log_camera(*tracker, to_c(tracker->result->camera.status));
    log_diagnosis(*tracker);
  });
}

dot_status dot_label(dot_tracker* tracker, const dot_frame* frame) noexcept {
  return guard(tracker, [&] {
    end_last(*tracker);
    tracker->result = &tracker->tracker.label(read_frame(frame, tracker->instances));
    tracker->diagnosis_is_new = true;
    log_camera(*tracker, to_c(tracker->result->camera.status));
  });
}

dot_status dot_prepare(dot_tracker* tracker) noexcept {
  return guard(tracker, [&] { end_last(*tracker); });
}

dot_status dot_submit_masks(dot_tracker* tracker, uint64_t frame_id, const dot_masks* masks) noexcept {
  return guard(tracker, [&] {
    tracker->tracker.submit_masks(frame_id, read_masks(masks, "masks", tracker->instances));
    log_diagnosis(*tracker);
  });
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

dot_status dot_revision_count(dot_tracker* tracker, uint32_t* count) noexcept {
  return guard(tracker, [&] {
    if (count == nullptr) invalid("count is NULL");
    *count = 0;
    *count = static_cast<std::uint32_t>(result_of(tracker).revised.size);
  });
}

dot_status dot_get_revision(dot_tracker* tracker, uint32_t index, dot_camera_revision* out) noexcept {
  return guard(tracker, [&] {
    const dot::Span<dot::CameraRevision> revised = result_of(tracker).revised;
    if (index >= revised.size)
      invalid("index is " + std::to_string(index) + ", there are " + std::to_string(revised.size) + " revisions");
    write(to_c(revised[index]), out, "out");
  });
}

dot_status dot_label_image(dot_tracker* tracker, dot_image* out) noexcept {
  return guard(tracker, [&] { write(to_c(result_of(tracker).labels, DOT_FORMAT_LABEL8), out, "out"); });
}

dot_status dot_id_image(dot_tracker* tracker, dot_image* out) noexcept {
  return guard(tracker, [&] { write(to_c(result_of(tracker).ids, DOT_FORMAT_ID32), out, "out"); });
}

dot_status dot_copy_labels(dot_tracker* tracker, uint8_t* data, int32_t width, int32_t height,
                           int64_t stride_bytes) noexcept {
  return guard(tracker, [&] {
    const dot::Result& result = result_of(tracker);
    copy_rows(result.labels, read_buffer(data, width, height, stride_bytes, result.labels));
  });
}

dot_status dot_copy_ids(dot_tracker* tracker, uint32_t* data, int32_t width, int32_t height,
                        int64_t stride_bytes) noexcept {
  return guard(tracker, [&] {
    const dot::Result& result = result_of(tracker);
    copy_rows(result.ids, read_buffer(data, width, height, stride_bytes, result.labels));
  });
}

dot_status dot_exclusion_mask(dot_tracker* tracker, const dot_exclusion_policy* policy, uint8_t* data, int32_t width,
                              int32_t height, int64_t stride_bytes) noexcept {
  return guard(tracker, [&] {
    const dot::Result& result = result_of(tracker);
    const dot::ExclusionPolicy exclusion = read_policy(policy);
    const bool inverted = policy != nullptr && (policy->flags & DOT_EXCLUDE_INVERTED) != 0;
    const dot::ImageView<std::uint8_t> out = read_buffer(data, width, height, stride_bytes, result.labels);
    (inverted ? dot::feature_mask : dot::exclusion_mask)(result, exclusion, out);
  });
}

const char* dot_last_error(const dot_tracker* tracker) noexcept {
  return tracker != nullptr ? tracker->error.text : "tracker is NULL";
}
