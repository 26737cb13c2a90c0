// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#pragma once

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dot/dot.h"

enum { WIDTH = 160, HEIGHT = 120 };

/* Ids of the segmentation. */
enum { CAR = 7, PERSON = 9 };

/* A textured wall at 5 m with two textured plates at 3 m; everything stands still. */
typedef struct scene {
  uint8_t grey[HEIGHT][WIDTH];
  float depth[HEIGHT][WIDTH];
  uint8_t ids[HEIGHT][WIDTH];
  dot_image grey_view;
  dot_image depth_view;
  dot_image ids_view;
  dot_instance person;
  dot_masks masks;
  dot_frame frame;
} scene;

static inline dot_image view_of(const void* data, uint32_t format, int64_t stride_bytes) {
  dot_image view;
  memset(&view, 0, sizeof view);
  view.struct_size = sizeof view;
  view.format = format;
  view.width = WIDTH;
  view.height = HEIGHT;
  view.stride_bytes = stride_bytes;
  view.data = data;
  return view;
}

static inline void make_scene(scene* s) {
  int x, y;
  memset(s, 0, sizeof *s);
  for (y = 0; y < HEIGHT; ++y)
    for (x = 0; x < WIDTH; ++x) {
      const int in_rows = y >= 40 && y < 90;
      const int car = in_rows && x >= 20 && x < 70;
      const int person = in_rows && x >= 100 && x < 130;
      const double phase = car ? 1.0 : person ? 2.0 : 0.0;
      const double wave = sin(0.31 * x + phase) * cos(0.23 * y) + sin(0.11 * x * (1 + phase) - 0.17 * y);
      s->grey[y][x] = (uint8_t)(128 + 50 * wave);
      s->depth[y][x] = car || person ? 3.0f : 5.0f;
      s->ids[y][x] = (uint8_t)(car ? CAR : person ? PERSON : 0);
    }
  s->grey_view = view_of(s->grey, DOT_FORMAT_GREY8, WIDTH);
  s->depth_view = view_of(s->depth, DOT_FORMAT_DEPTH_F32, WIDTH * (int64_t)sizeof(float));
  s->ids_view = view_of(s->ids, DOT_FORMAT_ID8, WIDTH);
  s->person.struct_size = sizeof s->person;
  s->person.id = PERSON;
  s->person.class_id = 42;
  s->person.score = 0.5f;
  s->person.flags = DOT_INSTANCE_ALWAYS_DYNAMIC;
  s->masks.struct_size = sizeof s->masks;
  s->masks.ids = &s->ids_view;
  s->masks.instances = &s->person;
  s->masks.instance_count = 1;
  s->frame.struct_size = sizeof s->frame;
  s->frame.image = &s->grey_view;
  s->frame.depth = &s->depth_view;
  s->frame.masks = &s->masks;
}

static inline dot_camera make_camera(void) {
  dot_camera camera;
  memset(&camera, 0, sizeof camera);
  camera.struct_size = sizeof camera;
  camera.width = WIDTH;
  camera.height = HEIGHT;
  camera.fx = 150;
  camera.fy = 150;
  camera.cx = 79.5;
  camera.cy = 59.5;
  return camera;
}

/* Ends the program when there is none. */
static inline dot_tracker* make_tracker(void) {
  const dot_camera camera = make_camera();
  dot_tracker* tracker = NULL;
  if (dot_create(&camera, NULL, &tracker) != DOT_OK) {
    fprintf(stderr, "dot_create: %s\n", dot_create_error());
    exit(1);
  }
  return tracker;
}

/* Tracks the scene as its next frame, 0.1 s after the last. */
static inline dot_status track_next(dot_tracker* tracker, scene* s) {
  ++s->frame.id;
  s->frame.timestamp += 0.1;
  return dot_track(tracker, &s->frame);
}
