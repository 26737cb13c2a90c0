/* SPDX-FileCopyrightText: 2026 The dot authors
 * SPDX-License-Identifier: MIT
 *
 * A host in C: one grey frame goes in, a label image of its size comes out. */

#include <stdint.h>
#include <stdio.h>

#include "dot/dot.h"

enum { WIDTH = 160, HEIGHT = 120 };
static uint8_t grey[WIDTH * HEIGHT];
static float metres[WIDTH * HEIGHT];

static dot_image view(const void* data, uint32_t format, int64_t pixel) {
  dot_image image = DOT_IMAGE_INIT;
  image.format = format;
  image.width = WIDTH;
  image.height = HEIGHT;
  image.stride_bytes = WIDTH * pixel;
  image.data = data;
  return image;
}

int main(void) {
  dot_camera camera = DOT_CAMERA_INIT;
  dot_frame frame = DOT_FRAME_INIT;
  dot_image image = view(grey, DOT_FORMAT_GREY8, 1);
  dot_image depth = view(metres, DOT_FORMAT_DEPTH_F32, sizeof(float));
  dot_image labels = DOT_IMAGE_INIT;
  dot_tracker* tracker = NULL;
  int i;

  for (i = 0; i < WIDTH * HEIGHT; ++i) {
    grey[i] = 100;
    metres[i] = 5;
  }
  camera.width = WIDTH;
  camera.height = HEIGHT;
  camera.fx = camera.fy = 100;
  camera.cx = 79.5;
  camera.cy = 59.5;
  frame.image = &image;
  frame.depth = &depth;

  if (dot_version() != DOT_HEADER_VERSION || dot_abi_version() != DOT_ABI_VERSION) {
    fprintf(stderr, "library %u, header %u\n", (unsigned)dot_version(), (unsigned)DOT_HEADER_VERSION);
    return 1;
  }
  if (dot_create(&camera, NULL, &tracker) != DOT_OK) {
    fprintf(stderr, "dot_create: %s\n", dot_create_error());
    return 1;
  }
  if (dot_track(tracker, &frame) != DOT_OK || dot_label_image(tracker, &labels) != DOT_OK) {
    fprintf(stderr, "dot_track: %s\n", dot_last_error(tracker));
    dot_destroy(tracker);
    return 1;
  }
  printf("%d x %d labels\n", (int)labels.width, (int)labels.height);
  i = labels.width == WIDTH && labels.height == HEIGHT ? 0 : 1;
  dot_destroy(tracker);
  return i;
}
