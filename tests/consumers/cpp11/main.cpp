// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host in C++11 that holds the C library's tracker in a class of its own.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

#include "dot/dot.h"

#if __cplusplus > 201103L
#error "this host is to be compiled as C++11"
#endif

namespace {

class Tracker {
 public:
  explicit Tracker(const dot_camera& camera) : handle_(nullptr, dot_destroy) {
    dot_tracker* made = nullptr;
    if (dot_create(&camera, nullptr, &made) != DOT_OK) throw std::runtime_error(dot_create_error());
    handle_.reset(made);
  }
  std::vector<std::uint8_t> exclude(const dot_frame& frame) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(frame.image->width * frame.image->height));
    check(dot_track(handle_.get(), &frame));
    check(dot_exclusion_mask(handle_.get(), nullptr, mask.data(), frame.image->width, frame.image->height,
                             frame.image->width));
    return mask;
  }

 private:
  void check(dot_status status) {
    if (status != DOT_OK) throw std::runtime_error(dot_last_error(handle_.get()));
  }
  std::unique_ptr<dot_tracker, void (*)(dot_tracker*)> handle_;
};

}  // namespace

int main() {
  const int width = 160, height = 120;
  const std::vector<std::uint8_t> grey(width * height, 100);
  const std::vector<float> metres(width * height, 5.0F);
  dot_camera camera = DOT_CAMERA_INIT;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 100;
  camera.cx = 79.5;
  camera.cy = 59.5;
  dot_image image = DOT_IMAGE_INIT, depth = DOT_IMAGE_INIT;
  image.format = DOT_FORMAT_GREY8;
  depth.format = DOT_FORMAT_DEPTH_F32;
  image.width = depth.width = width;
  image.height = depth.height = height;
  image.stride_bytes = width;
  depth.stride_bytes = width * static_cast<std::int64_t>(sizeof(float));
  image.data = grey.data();
  depth.data = metres.data();
  dot_frame frame = DOT_FRAME_INIT;
  frame.image = &image;
  frame.depth = &depth;
  try {
    Tracker tracker(camera);
    const std::vector<std::uint8_t> mask = tracker.exclude(frame);
    std::size_t excluded = 0;
    for (const std::uint8_t pixel : mask) excluded += pixel != 0;
    std::printf("%zu of %zu pixels excluded\n", excluded, mask.size());
    return mask.size() == grey.size() && excluded == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
