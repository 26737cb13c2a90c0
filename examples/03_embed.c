// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Embeds dot in a C program. The frames are drawn here: a camera glides past a textured wall with two textured boxes in
// front of it, the left one at rest, the right one sliding to the right at 0.4 m/s.

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "dot/dot.h"

enum { WIDTH = 320, HEIGHT = 240, FRAMES = 12, BOXES = 2 };
static const double focal = 280, cx = 159.5, cy = 119.5, dt = 0.1;

static uint8_t grey[HEIGHT][WIDTH];
static float depth[HEIGHT][WIDTH];
static uint8_t ids[HEIGHT][WIDTH];

static double lattice(int x, int y, int z) {
  uint32_t h = (uint32_t)x * 73856093u ^ (uint32_t)y * 19349663u ^ (uint32_t)z * 83492791u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return (double)((h ^ (h >> 16)) & 0xffffu) / 65535.0;
}

// Smooth noise in 0..1, a value for each point of space: a solid texture, cut open by the surfaces.
static double noise(const double p[3], double cell) {
  double sum = 0, f[3];
  int i[3], k;
  for (k = 0; k < 3; ++k) {
    f[k] = p[k] / cell - floor(p[k] / cell);
    i[k] = (int)floor(p[k] / cell);
    f[k] = f[k] * f[k] * (3 - 2 * f[k]);
  }
  for (k = 0; k < 8; ++k) {
    const int x = k & 1, y = k >> 1 & 1, z = k >> 2;
    sum +=
        (x ? f[0] : 1 - f[0]) * (y ? f[1] : 1 - f[1]) * (z ? f[2] : 1 - f[2]) * lattice(i[0] + x, i[1] + y, i[2] + z);
  }
  return sum;
}

// Depth at which the ray camera + s (rx, ry, 1) meets a box turned by 45 degrees about the vertical; infinite if it
// misses. `p` becomes the point in the box's own coordinates, which its texture moves with.
static double hit_box(const double camera[3], const double ray[3], const double centre[3], double p[3]) {
  const double half = 0.25, r = sqrt(0.5), d[3] = {camera[0] - centre[0], camera[1] - centre[1], camera[2] - centre[2]};
  const double from[3] = {r * (d[0] + d[2]), d[1], r * (d[2] - d[0])};
  const double along[3] = {r * (ray[0] + ray[2]), ray[1], r * (ray[2] - ray[0])};
  double near = 0, far = INFINITY;
  int k;
  for (k = 0; k < 3; ++k) {
    const double a = (-half - from[k]) / along[k], b = (half - from[k]) / along[k];
    near = fmax(near, fmin(a, b));
    far = fmin(far, fmax(a, b));
  }
  if (near > far) return INFINITY;
  for (k = 0; k < 3; ++k) p[k] = from[k] + near * along[k];
  return near;
}

// What camera, depth sensor and segmentation network would deliver at time t.
static void draw(double t) {
  const double camera[3] = {0.1 * t, 0, 0.2 * t};
  const double centre[BOXES][3] = {{-0.5, 0.2, 2.2}, {0.3 + 0.4 * t, 0.2, 2.0}};
  int u, v, k;
  for (v = 0; v < HEIGHT; ++v)
    for (u = 0; u < WIDTH; ++u) {
      const double ray[3] = {(u - cx) / focal, (v - cy) / focal, 1};
      // The wall: z = 4 + 0.3 x - 0.2 y.
      double z = (4 + 0.3 * camera[0] - 0.2 * camera[1] - camera[2]) / (1 - 0.3 * ray[0] + 0.2 * ray[1]);
      double p[3], q[3] = {0, 0, 0};
      for (k = 0; k < 3; ++k) p[k] = camera[k] + z * ray[k];
      ids[v][u] = 0;
      for (k = 0; k < BOXES; ++k) {
        const double box_z = hit_box(camera, ray, centre[k], q);
        if (box_z >= z) continue;
        z = box_z;
        p[0] = q[0] + 10 * (k + 1);  // so that each box has a texture of its own
        p[1] = q[1];
        p[2] = q[2];
        ids[v][u] = (uint8_t)(k + 1);
      }
      grey[v][u] = (uint8_t)(20 + 120 * noise(p, 0.25) + 90 * noise(p, 0.08));
      depth[v][u] = (float)z;
    }
}

static dot_image view(const void* data, uint32_t format, int64_t bytes_per_pixel) {
  const dot_image image = {.struct_size = sizeof image,
                           .format = format,
                           .width = WIDTH,
                           .height = HEIGHT,
                           .stride_bytes = WIDTH * bytes_per_pixel,
                           .data = data};
  return image;
}

int main(void) {
  static const char* const states[] = {"background", "static", "moving", "not observable"};
  static uint8_t excluded[HEIGHT][WIDTH];  // 255 = take no features here
  const dot_camera camera = {
      .struct_size = sizeof camera, .width = WIDTH, .height = HEIGHT, .fx = focal, .fy = focal, .cx = cx, .cy = cy};
  const dot_image image = view(grey, DOT_FORMAT_GREY8, 1);
  const dot_image metres = view(depth, DOT_FORMAT_DEPTH_F32, sizeof(float));
  const dot_image instances = view(ids, DOT_FORMAT_ID8, 1);
  const dot_masks masks = {.struct_size = sizeof masks, .ids = &instances};
  int frame_number, n_static = 0, n_moving = 0;
  dot_options options;
  dot_tracker* tracker;

  if (dot_options_init(&options, sizeof options) != DOT_OK) {
    fprintf(stderr, "dot_options_init: %s\n", dot_create_error());
    return 1;
  }
  options.depth_source = DOT_DEPTH_RGBD;
  if (dot_create(&camera, &options, &tracker) != DOT_OK) {
    fprintf(stderr, "dot_create: %s\n", dot_create_error());
    return 1;
  }

  for (frame_number = 0; frame_number < FRAMES; ++frame_number) {
    const dot_frame frame = {.struct_size = sizeof frame,
                             .id = (uint64_t)frame_number,
                             .timestamp = frame_number * dt,
                             .image = &image,
                             .depth = &metres,
                             .masks = frame_number % 3 == 0 ? &masks : NULL};  // in between, dot carries them on
    uint32_t i, count = 0;
    draw(frame.timestamp);
    if (dot_track(tracker, &frame) != DOT_OK || dot_object_count(tracker, &count) != DOT_OK ||
        dot_exclusion_mask(tracker, NULL, &excluded[0][0], WIDTH, HEIGHT, WIDTH) != DOT_OK) {
      fprintf(stderr, "frame %d: %s\n", frame_number, dot_last_error(tracker));
      dot_destroy(tracker);
      return 1;
    }
    n_static = n_moving = 0;
    for (i = 0; i < count; ++i) {
      dot_object object = {.struct_size = sizeof object};
      if (dot_get_object(tracker, i, &object) != DOT_OK) continue;
      printf("frame %2d  object %u  %-14s  P(moving) %.2f", frame_number, (unsigned)object.id, states[object.state],
             object.p_moving);
      if (object.reason == DOT_REASON_NONE) printf("  %.2f m/s", object.speed);
      printf("\n");
      n_static += object.state == DOT_STATE_STATIC;
      n_moving += object.state == DOT_STATE_MOVING;
    }
  }
  dot_destroy(tracker);
  return n_static == 1 && n_moving == 1 ? 0 : 1;
}
