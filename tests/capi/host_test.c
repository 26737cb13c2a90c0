// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/* What a host lives on besides the labels: copies, both polarities, the masked share, the log, the guard against two
 * calls at once. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dot/dot.h"
#include "scene.h"

enum { PADDED = WIDTH + 3, AREA = WIDTH * HEIGHT };

static scene* new_scene(void) {
  scene* s = (scene*)malloc(sizeof *s);
  if (s == NULL) exit(1);
  make_scene(s);
  return s;
}

static void test_copies(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = new_scene();
  static uint8_t labels[HEIGHT][PADDED];
  static uint32_t ids[HEIGHT][PADDED];
  dot_image label_view = DOT_IMAGE_INIT, id_view = DOT_IMAGE_INIT;
  int y, seen = 0;
  CHECK(dot_copy_labels(tracker, &labels[0][0], WIDTH, HEIGHT, PADDED) == DOT_NO_RESULT);
  CHECK(dot_copy_ids(tracker, &ids[0][0], WIDTH, HEIGHT, 4 * PADDED) == DOT_NO_RESULT);
  CHECK(track_next(tracker, s) == DOT_OK);
  memset(labels, 77, sizeof labels);
  memset(ids, 77, sizeof ids);
  CHECK(dot_copy_labels(tracker, &labels[0][0], WIDTH, HEIGHT, PADDED) == DOT_OK);
  CHECK(dot_copy_ids(tracker, &ids[0][0], WIDTH, HEIGHT, 4 * PADDED) == DOT_OK);
  CHECK(dot_label_image(tracker, &label_view) == DOT_OK);
  CHECK(dot_id_image(tracker, &id_view) == DOT_OK);
  for (y = 0; y < HEIGHT; ++y) {
    const uint8_t* label_row = (const uint8_t*)label_view.data + y * label_view.stride_bytes;
    const uint8_t* id_row = (const uint8_t*)id_view.data + y * id_view.stride_bytes;
    CHECK(memcmp(labels[y], label_row, WIDTH) == 0 && labels[y][WIDTH] == 77);
    CHECK(memcmp(ids[y], id_row, 4 * WIDTH) == 0 && ids[y][WIDTH] == 77u * 0x01010101u);
    seen += labels[y][115] == DOT_STATE_MOVING && ids[y][115] != 0;
  }
  CHECK(seen > 20);

  CHECK_INVALID(tracker, dot_copy_labels(tracker, NULL, WIDTH, HEIGHT, PADDED), "data is NULL");
  CHECK_INVALID(tracker, dot_copy_labels(tracker, &labels[0][0], WIDTH + 1, HEIGHT, PADDED), "width");
  CHECK_INVALID(tracker, dot_copy_labels(tracker, &labels[0][0], WIDTH, HEIGHT - 1, PADDED), "height");
  CHECK_INVALID(tracker, dot_copy_labels(tracker, &labels[0][0], WIDTH, HEIGHT, WIDTH - 1), "stride_bytes");
  CHECK_INVALID(tracker, dot_copy_ids(tracker, &ids[0][0], WIDTH, HEIGHT, WIDTH), "stride_bytes");
  CHECK_INVALID(tracker, dot_copy_ids(tracker, &ids[0][0], WIDTH, HEIGHT, 4 * PADDED + 2), "aligned");
  free(s);
  dot_destroy(tracker);
}

static void test_polarity_and_share(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = new_scene();
  static uint8_t mask[AREA], inverted[AREA];
  dot_exclusion_policy policy = DOT_EXCLUSION_POLICY_INIT;
  dot_camera_result camera = DOT_CAMERA_RESULT_INIT;
  int i, opposite = 0, excluded = 0;
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(dot_exclusion_mask(tracker, &policy, mask, WIDTH, HEIGHT, WIDTH) == DOT_OK);
  policy.flags |= DOT_EXCLUDE_INVERTED;
  CHECK(dot_exclusion_mask(tracker, &policy, inverted, WIDTH, HEIGHT, WIDTH) == DOT_OK);
  for (i = 0; i < AREA; ++i) {
    opposite += (mask[i] == 0 || mask[i] == 255) && mask[i] + inverted[i] == 255;
  }
  CHECK(opposite == AREA);
  CHECK(mask[65 * WIDTH + 115] == 255 && mask[10 * WIDTH + 80] == 0);

  policy.flags = DOT_EXCLUDE_NOT_OBSERVABLE;
  policy.dilation = 0;
  CHECK(dot_exclusion_mask(tracker, &policy, mask, WIDTH, HEIGHT, WIDTH) == DOT_OK);
  for (i = 0; i < AREA; ++i) excluded += mask[i] != 0;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(excluded > 1000 && camera.masked_share * AREA > excluded - 0.5 && camera.masked_share * AREA < excluded + 0.5);
  free(s);
  dot_destroy(tracker);
}

typedef struct journal {
  int count;
  uint32_t level;
  char text[256];
  dot_tracker* used_inside;
  dot_status status_inside;
} journal;

static void record(void* user, uint32_t level, const char* text) {
  journal* j = (journal*)user;
  uint32_t count;
  ++j->count;
  j->level = level;
  snprintf(j->text, sizeof j->text, "%s", text);
  if (j->used_inside != NULL) j->status_inside = dot_object_count(j->used_inside, &count);
}

static void test_log(void) {
  dot_tracker* tracker = make_tracker();
  dot_tracker* other = make_tracker();
  scene* s = new_scene();
  journal j;
  int y, x;
  memset(&j, 0, sizeof j);
  CHECK(dot_set_log(NULL, record, &j) == DOT_INVALID_ARGUMENT);
  CHECK(dot_set_log(tracker, record, &j) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 0);

  CHECK(dot_track(tracker, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(j.count == 1 && j.level == DOT_LOG_ERROR);
  CHECK(strcmp(j.text, dot_last_error(tracker)) == 0 && strcmp(j.text, "frame is NULL") == 0);
  CHECK(dot_track(other, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(j.count == 1);

  /* A picture without anything in it has no motion; said once, not with every frame. */
  for (y = 0; y < HEIGHT; ++y)
    for (x = 0; x < WIDTH; ++x) s->grey[y][x] = 100;
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 2 && j.level == DOT_LOG_WARNING);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 2);
  {
    const dot_frame frame = s->frame;
    make_scene(s);
    s->frame.id = frame.id;
    s->frame.timestamp = frame.timestamp;
  }
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 3 && j.level == DOT_LOG_INFO);

  CHECK(dot_set_log(tracker, NULL, NULL) == DOT_OK);
  CHECK(dot_track(tracker, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(j.count == 3);
  free(s);
  dot_destroy(other);
  dot_destroy(tracker);
}

/* The first frame after a gap has no motion that could be known. */
static void test_log_after_a_gap(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = new_scene();
  dot_frame frame;
  journal j;
  memset(&j, 0, sizeof j);
  CHECK(dot_set_log(tracker, record, &j) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  memset(s->grey, 100, sizeof s->grey);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 1 && j.level == DOT_LOG_WARNING);
  frame = s->frame;
  make_scene(s);
  s->frame.id = frame.id;
  s->frame.timestamp = frame.timestamp + 100;
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 1);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(j.count == 2 && j.level == DOT_LOG_INFO);
  free(s);
  dot_destroy(tracker);
}

/* Times in milliseconds are told once, not with every frame; again after a reset. */
static void test_log_of_suspicion(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = new_scene();
  journal j;
  int i, way; /* track; label and prepare; label alone */
  memset(&j, 0, sizeof j);
  CHECK(dot_set_log(tracker, record, &j) == DOT_OK);
  for (way = 0; way < 3; ++way) {
    for (i = 0; i < 40; ++i) {
      ++s->frame.id;
      s->frame.timestamp += 100;
      CHECK((way ? dot_label : dot_track)(tracker, &s->frame) == DOT_OK);
      if (way == 1) {
        CHECK(j.count == (i > 7)); /* the labels are ready before the diagnosis */
        CHECK(dot_prepare(tracker) == DOT_OK && dot_prepare(tracker) == DOT_OK);
      }
      CHECK(j.count == (i >= (way == 2 ? 8 : 7)));
    }
    CHECK(j.level == DOT_LOG_WARNING);
    CHECK(strstr(j.text, "suspicion implausible_times (100 s): ") == j.text && strstr(j.text, "in seconds?") != NULL);
    j.count = 0;
    CHECK(dot_reset(tracker) == DOT_OK);
  }
  free(s);
  dot_destroy(tracker);
}

/* A log function that uses its own tracker meets the call that it was called from. */
static void test_busy(void) {
  dot_tracker* tracker = make_tracker();
  dot_tracker* other = make_tracker();
  journal j;
  memset(&j, 0, sizeof j);
  CHECK(dot_set_log(tracker, record, &j) == DOT_OK);
  j.used_inside = tracker;
  CHECK(dot_track(tracker, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(j.status_inside == DOT_BUSY && j.count == 1);
  CHECK(strcmp(dot_last_error(tracker), "frame is NULL") == 0);
  j.used_inside = other;
  CHECK(dot_track(tracker, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(j.status_inside == DOT_NO_RESULT);
  CHECK(dot_reset(tracker) == DOT_OK);
  dot_destroy(other);
  dot_destroy(tracker);
}

int main(void) {
  test_copies();
  test_polarity_and_share();
  test_log();
  test_log_after_a_gap();
  test_log_of_suspicion();
  test_busy();
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
