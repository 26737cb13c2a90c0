/* SPDX-FileCopyrightText: 2026 The dot authors
   SPDX-License-Identifier: MIT */

/* The C of docs/tasks.md: what lies between "snippet:" and "end of snippet" is replaced by the page's. */

#include "scene.h"

#include "check.h"

static int excluded(const uint8_t* mask) {
  int i, count = 0;
  for (i = 0; i < WIDTH * HEIGHT; ++i) count += mask[i] == 255;
  return count;
}

int main(void) {
  const int32_t width = WIDTH, height = HEIGHT;
  static uint8_t exclude[WIDTH * HEIGHT];
  static scene s;
  dot_camera camera = DOT_CAMERA_INIT;
  dot_tracker* tracker = NULL;
  int usual;
  camera.width = width, camera.height = height;
  camera.fx = camera.fy = 140, camera.cx = 79.5, camera.cy = 59.5;
  make_scene(&s);
  CHECK(dot_create(&camera, NULL, &tracker) == DOT_OK);
  CHECK(dot_track(tracker, &s.frame) == DOT_OK);
  CHECK(dot_exclusion_mask(tracker, NULL, exclude, width, height, width) == DOT_OK);
  usual = excluded(exclude);
  CHECK(usual > 0);
  // snippet: task_exclude_c
  // end of snippet
  CHECK(excluded(exclude) > usual);
  dot_destroy(tracker);
  return failures != 0;
}
