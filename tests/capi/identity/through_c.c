// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "through_c.h"

#include <stdio.h>

int track_through_c(dot_tracker* tracker, const dot_camera* camera, uint64_t number, double seconds, const uint8_t* bgr,
                    const uint16_t* depth, const uint8_t* ids, uint8_t* labels, uint32_t* track_ids) {
  const int32_t w = camera->width, h = camera->height;
  const dot_image image_view = {sizeof image_view, DOT_FORMAT_BGR8, w, h, 3 * (int64_t)w, bgr, 0};
  const dot_image depth_view = {sizeof depth_view, DOT_FORMAT_DEPTH_U16, w, h, 2 * (int64_t)w, depth, 256};
  const dot_image ids_view = {sizeof ids_view, DOT_FORMAT_ID8, w, h, w, ids, 0};
  dot_masks masks = DOT_MASKS_INIT;
  dot_frame frame = DOT_FRAME_INIT;
  masks.ids = &ids_view;
  frame.id = number;
  frame.timestamp = seconds;
  frame.image = &image_view;
  frame.depth = &depth_view;
  frame.masks = ids != NULL ? &masks : NULL;
  if (dot_track(tracker, &frame) == DOT_OK && dot_copy_labels(tracker, labels, w, h, w) == DOT_OK &&
      dot_copy_ids(tracker, track_ids, w, h, 4 * (int64_t)w) == DOT_OK)
    return 0;
  fprintf(stderr, "frame %d: %s\n", (int)number, dot_last_error(tracker));
  return 1;
}
