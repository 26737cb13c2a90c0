// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// @file
/// The C interface under any sequence of calls. An input is a camera, options, a scene, and then records of
/// kRecordBytes, each of them one call.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <utility>
#include <vector>

#include "dot/dot.h"
#include "fuzz/frames.hpp"
#include "fuzz/input.hpp"
#include "fuzz/invariants.hpp"
#include "fuzz/masks.hpp"
#include "fuzz/scene.hpp"
#include "fuzz/setup.hpp"
#include "fuzz/views.hpp"

namespace {

using namespace fuzz;

constexpr std::size_t kRecordBytes = 8;
constexpr std::size_t kMaxBytes = kCameraBytes + kOptionBytes + 1 + kSceneBytes + 48 * kRecordBytes;
constexpr std::size_t kRemembered = 16;  // frames whose masks may be submitted late

/// Told at the end, whichever program runs the inputs.
struct Counter {
  unsigned long long frames = 0;
  ~Counter() { std::printf("frames tracked: %llu\n", frames); }
} tracked;

void on_log(void* user, std::uint32_t level, const char* text) {
  FUZZ_DEMAND(level >= DOT_LOG_ERROR && level <= DOT_LOG_INFO && text[0] != '\0');
  std::uint32_t count = 0;
  FUZZ_DEMAND(dot_object_count(static_cast<dot_tracker*>(user), &count) == DOT_BUSY);
}

/// One scene, seen by one tracker after the other.
class Session {
 public:
  explicit Session(Input& in)
      : camera_(read_camera(in.record(kCameraBytes))),
        setup_(in.record(kOptionBytes)),
        start_(in.byte()),
        scene_(in.record(kSceneBytes), camera_.fx, camera_.width, camera_.height) {}
  ~Session() { dot_destroy(tracker_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void run(Input& in) {
    if (!create()) return;
    while (!in.empty()) {
      Input record = in.record(kRecordBytes);
      switch (record.choice(16)) {
        default: track(record); break;
        case 10:
        case 11: submit(record); break;
        case 12: scene_.change(record); break;
        case 13: read_masks(record); break;
        case 14: read_structs(record); break;
        case 15:
          if ((record.byte() & 1) == 0) {
            FUZZ_DEMAND(check_status(dot_reset(tracker_), tracker_) == DOT_OK);
            forget();
          } else {
            dot_destroy(std::exchange(tracker_, nullptr));
            if (!create()) return;
          }
      }
    }
  }

 private:
  bool create();
  void forget();
  bool track(const dot_frame* frame);
  void track(Input& in);
  void submit(Input& in);
  void read_masks(Input& in);
  void read_structs(Input& in);
  Answer answer() { return read_answer(tracker_, camera_.width, camera_.height); }

  dot_camera camera_;
  Setup setup_;
  int start_;
  Scene scene_;
  dot_tracker* tracker_ = nullptr;
  std::deque<std::pair<std::uint64_t, Picture>> pictures_;  ///< of the last frames, by their ids, the newest first
  std::uint64_t id_ = 0;
  double time_ = 0;  ///< of the last frame
  bool has_time_ = false;
};

bool Session::create() {
  Arena arena;
  dot_options options = setup_.options;
  options.settings = setup_.settings.data();
  const dot_camera* camera = arena.place(camera_, camera_.struct_size);
  const dot_status status =
      check_status(dot_create(camera, arena.place(options, options.struct_size), &tracker_), dot_create_error());
  FUZZ_DEMAND(status != DOT_NO_RESULT && (tracker_ != nullptr) == (status == DOT_OK));
  if (status != DOT_OK) return false;
  FUZZ_DEMAND(check_status(dot_set_log(tracker_, on_log, tracker_), tracker_) == DOT_OK);
  constexpr double times[] = {0, 1.7e9, -5, 1e-3};
  time_ = times[start_ & 3];
  forget();
  return true;
}

/// What the tracker has forgotten as well.
void Session::forget() {
  pictures_.clear();
  has_time_ = false;
  FUZZ_DEMAND(answer().status == DOT_NO_RESULT);
}

/// @return whether it was tracked. A frame that is refused leaves everything as it was.
bool Session::track(const dot_frame* frame) {
  const Answer before = answer();
  const dot_status status = check_status(dot_track(tracker_, frame), tracker_);
  const Answer after = answer();
  FUZZ_DEMAND(status != DOT_NO_RESULT);
  if (status != DOT_OK) {
    FUZZ_DEMAND(after == before);
    return false;
  }
  ++tracked.frames;
  FUZZ_DEMAND(after.camera.frame_id == frame->id && after.camera.timestamp == frame->timestamp);
  check_answer(after, camera_.width);
  time_ = frame->timestamp;
  has_time_ = true;
  return true;
}

void Session::track(Input& in) {
  const FrameChoice choice(in);
  scene_.advance(std::min(choice.interval(), 0.5));
  Picture picture = scene_.render();
  spoil(picture, choice.pixels);
  if ((choice.motion & 128) == 0) ++id_;  // else as the frame before: the interface allows it
  const double timestamp = time_ + choice.interval();
  const auto make = [&](Arena& arena, int fault) {
    return make_frame(arena, scene_, picture, choice, id_, timestamp, fault);
  };
  Arena arena;
  bool taken = choice.has_fault() && track(make(arena, choice.fault));
  if (!taken) {
    const bool valid = !has_time_ || timestamp > time_;
    taken = track(make(arena, -1));
    // Masks of very many ids may be refused.
    FUZZ_DEMAND_FOR(taken == valid || (choice.mask_kind & 7) == 7, dot_last_error(tracker_));
  }
  if (!taken) return;
  pictures_.emplace_front(id_, std::move(picture));
  if (pictures_.size() > kRemembered) pictures_.pop_back();
}

/// Masks of an earlier frame, or of none.
void Session::submit(Input& in) {
  const std::size_t age = static_cast<std::size_t>(in.byte());
  const int kind = in.byte() + 2, detail = in.byte(), fault = in.byte() - 128, value = in.byte();
  if (pictures_.empty()) return;
  const auto& [id, picture] = pictures_[age % pictures_.size()];
  Arena arena;
  const dot_masks* masks = make_masks(arena, picture, kind, detail, {fault < 0 ? -1 : fault % kMaskFaults, value});
  const Answer before = answer();
  const dot_status status = check_status(dot_submit_masks(tracker_, age < 250 ? id : id + age, masks), tracker_);
  FUZZ_DEMAND(status != DOT_NO_RESULT);
  if (masks == nullptr) FUZZ_DEMAND(status == DOT_INVALID_ARGUMENT);
  FUZZ_DEMAND(answer() == before);
}

/// The images of the last result, also into buffers that do not fit.
void Session::read_masks(Input& in) {
  dot_exclusion_policy policy = DOT_EXCLUSION_POLICY_INIT;
  policy.flags = static_cast<std::uint32_t>(in.byte() % 9);
  const int dilation = in.byte(), fault = in.byte(), value = in.byte();
  policy.dilation = dilation < 224 ? dilation % 16 : odd_integer(dilation);
  int width = camera_.width, height = camera_.height;
  const int padding = value % 9;
  std::int64_t stride = width + padding;
  const std::size_t size =
      static_cast<std::size_t>(stride) * static_cast<std::size_t>(height - 1) + static_cast<std::size_t>(width);
  Arena arena;
  unsigned char* data = arena.take(size);
  std::uint32_t struct_size = sizeof policy;
  switch (fault) {
    case 250: struct_size = odd_size(struct_size, value); break;
    case 251: width += value - 128; break;
    case 252: height = odd_integer(value); break;
    case 253: stride = -stride; break;
    case 254: stride = width - 1; break;
    case 255: data = nullptr; break;
    default: break;
  }
  const dot_status status = check_status(
      dot_exclusion_mask(tracker_, arena.place(policy, struct_size), data, width, height, stride), tracker_);
  if (status != DOT_OK) return;
  const Answer last = answer();
  const bool inverted = (policy.flags & DOT_EXCLUDE_INVERTED) != 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int pixel = data[y * stride + x];
      FUZZ_DEMAND(pixel == 0 || pixel == 255);
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      if (last.labels[at] == DOT_STATE_MOVING) FUZZ_DEMAND((pixel == 255) != inverted);
    }
}

/// What a caller with an older or a newer header has, and views instead of copies.
void Session::read_structs(Input& in) {
  const int index = in.byte(), value = in.byte();
  Output<dot_object> object(odd_size(sizeof(dot_object), value));
  object.check(check_status(dot_get_object(tracker_, static_cast<std::uint32_t>(index), object.get()), tracker_));
  Output<dot_camera_result> camera(odd_size(sizeof(dot_camera_result), value));
  camera.check(check_status(dot_get_camera(tracker_, camera.get()), tracker_));
  Output<dot_camera_revision> revision(odd_size(sizeof(dot_camera_revision), value));
  revision.check(check_status(dot_get_revision(tracker_, static_cast<std::uint32_t>(index), revision.get()), tracker_));
  Output<dot_options> options(0xa5a5a5a5);
  const std::uint32_t size = odd_size(sizeof(dot_options), value);
  if (check_status(dot_options_init(options.get(), size), dot_create_error()) == DOT_OK)
    FUZZ_DEMAND(options.get()->struct_size == size);
  const Answer last = answer();
  Output<dot_image> labels, ids;
  if (labels.check(check_status(dot_label_image(tracker_, labels.get()), tracker_)).data == nullptr) return;
  if (last.status != DOT_OK) return;
  ids.check(check_status(dot_id_image(tracker_, ids.get()), tracker_));
  for (int y = 0; y < camera_.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width);
    const auto row = [&](dot_image& view) {
      return static_cast<const unsigned char*>(view.data) + y * view.stride_bytes;
    };
    FUZZ_DEMAND(std::equal(row(*labels.get()), row(*labels.get()) + camera_.width, &last.labels[at]));
    FUZZ_DEMAND(std::memcmp(row(*ids.get()), &last.ids[at], 4 * static_cast<std::size_t>(camera_.width)) == 0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMaxBytes) return 0;  // long inputs find what several short ones do, and take their time
  Input in(data, size);
  Session(in).run(in);
  return 0;
}
