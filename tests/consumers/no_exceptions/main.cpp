// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host without exceptions: what goes wrong in the library comes back as a status and a text, and the tracker goes on.

#include <cstdint>
#include <cstdio>
#include <cstring>

#include "dot/dot.h"

#if defined(__cpp_exceptions) || defined(__cpp_rtti)
#error "this host is to be compiled with -fno-exceptions -fno-rtti"
#endif

namespace {

constexpr std::uint32_t width = 160, height = 120;
std::uint8_t grey[width * height], mask[width * height];
float metres[width * height];

dot_image view(const void* data, std::uint32_t format, std::uint32_t pixel_bytes) {
  dot_image image = DOT_IMAGE_INIT;
  image.format = format;
  image.width = width;
  image.height = height;
  image.stride_bytes = width * pixel_bytes;
  image.data = data;
  return image;
}

int failures = 0;

void expect(bool holds, const char* what, const char* error) {
  std::printf("%s %s (%s)\n", holds ? "ok    " : "FAILED", what, error);
  failures += !holds;
}

}  // namespace

int main() {
  std::memset(grey, 100, sizeof grey);
  for (float& z : metres) z = 5;
  dot_camera camera = DOT_CAMERA_INIT;
  camera.width = width;
  camera.height = height;
  camera.fx = -1;
  camera.fy = 100;
  camera.cx = 79.5;
  camera.cy = 59.5;
  dot_tracker* tracker = nullptr;
  expect(dot_create(&camera, nullptr, &tracker) != DOT_OK && std::strstr(dot_create_error(), "fx") != nullptr,
         "a bad camera is refused by name", dot_create_error());
  camera.fx = 100;
  if (dot_create(&camera, nullptr, &tracker) != DOT_OK) return std::puts(dot_create_error()), 1;

  const dot_image image = view(grey, DOT_FORMAT_GREY8, 1);
  dot_image depth = view(metres, DOT_FORMAT_DEPTH_F32, sizeof(float));
  dot_frame frame = DOT_FRAME_INIT;
  frame.image = &image;
  frame.depth = &depth;
  depth.width = width / 2;
  expect(dot_track(tracker, &frame) != DOT_OK && std::strstr(dot_last_error(tracker), "depth") != nullptr,
         "a frame with a bad depth image is refused by name", dot_last_error(tracker));
  depth.width = width;
  expect(dot_track(tracker, &frame) == DOT_OK, "the next frame is tracked", dot_last_error(tracker));
  expect(dot_exclusion_mask(tracker, nullptr, mask, width, height, width) == DOT_OK, "its mask is written",
         dot_last_error(tracker));
  dot_destroy(tracker);
  return failures == 0 ? 0 : 1;
}
