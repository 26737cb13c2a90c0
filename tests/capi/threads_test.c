// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/* Two trackers in two threads see what one sees alone; one tracker in two threads is noticed. */

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dot/dot.h"
#include "scene.h"

enum { FRAMES = 12 };

typedef struct worker {
  pthread_t thread;
  uint8_t labels[FRAMES][HEIGHT][WIDTH];
  double p_moving;
  dot_status status;
} worker;

static void* run(void* argument) {
  worker* w = (worker*)argument;
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  dot_object object = DOT_OBJECT_INIT;
  int i;
  if (s == NULL) exit(1);
  make_scene(s);
  w->status = DOT_OK;
  for (i = 0; i < FRAMES && w->status == DOT_OK; ++i) {
    w->status = track_next(tracker, s);
    if (w->status == DOT_OK) w->status = dot_copy_labels(tracker, &w->labels[i][0][0], WIDTH, HEIGHT, WIDTH);
  }
  if (w->status == DOT_OK) w->status = dot_get_object(tracker, 0, &object);
  w->p_moving = object.p_moving;
  free(s);
  dot_destroy(tracker);
  return NULL;
}

static void test_two_trackers(void) {
  worker* workers = (worker*)calloc(3, sizeof *workers);
  int i;
  if (workers == NULL) exit(1);
  run(&workers[2]);
  for (i = 0; i < 2; ++i) CHECK(pthread_create(&workers[i].thread, NULL, run, &workers[i]) == 0);
  for (i = 0; i < 2; ++i) CHECK(pthread_join(workers[i].thread, NULL) == 0);
  for (i = 0; i < 3; ++i) CHECK(workers[i].status == DOT_OK);
  for (i = 0; i < 2; ++i) {
    CHECK(memcmp(workers[i].labels, workers[2].labels, sizeof workers[i].labels) == 0);
    CHECK(workers[i].p_moving == workers[2].p_moving);
  }
  free(workers);
}

typedef struct intruder {
  dot_tracker* tracker;
  dot_status count, reset;
} intruder;

static void* intrude(void* argument) {
  intruder* in = (intruder*)argument;
  uint32_t count;
  in->count = dot_object_count(in->tracker, &count);
  in->reset = dot_reset(in->tracker);
  return NULL;
}

/* Runs while the tracker is at work, which makes the meeting certain. */
static void let_in(void* user, uint32_t level, const char* text) {
  pthread_t thread;
  (void)level;
  (void)text;
  CHECK(pthread_create(&thread, NULL, intrude, user) == 0);
  CHECK(pthread_join(thread, NULL) == 0);
}

static void test_one_tracker_twice(void) {
  intruder in = {NULL, DOT_OK, DOT_OK};
  scene* s = (scene*)malloc(sizeof *s);
  uint32_t count = 0;
  if (s == NULL) exit(1);
  make_scene(s);
  in.tracker = make_tracker();
  CHECK(track_next(in.tracker, s) == DOT_OK);
  CHECK(dot_set_log(in.tracker, let_in, &in) == DOT_OK);
  CHECK(dot_track(in.tracker, NULL) == DOT_INVALID_ARGUMENT);
  CHECK(in.count == DOT_BUSY && in.reset == DOT_BUSY);
  CHECK(dot_object_count(in.tracker, &count) == DOT_OK && count == 2);
  free(s);
  dot_destroy(in.tracker);
}

int main(void) {
  test_two_trackers();
  test_one_tracker_twice();
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
