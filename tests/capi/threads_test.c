// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/* Two trackers in two threads see what one sees alone; one tracker in two threads is noticed. Masks come with the
 * frame, late, or not at all, and what no mask shows is looked for. */

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

static dot_tracker* make_searching_tracker(void) {
  const dot_setting discover = {"discover_unknown", 1};
  const dot_camera camera = make_camera();
  dot_options options = DOT_OPTIONS_INIT;
  dot_tracker* tracker = NULL;
  options.settings = &discover;
  options.setting_count = 1;
  if (dot_create(&camera, &options, &tracker) != DOT_OK) {
    fprintf(stderr, "dot_create: %s\n", dot_create_error());
    exit(1);
  }
  return tracker;
}

/* The next frame: with masks, without, or without until the next call. */
static dot_status track_any(dot_tracker* tracker, scene* s, int i) {
  dot_status status;
  s->frame.masks = i % 3 == 0 ? &s->masks : NULL;
  status = track_next(tracker, s);
  if (status == DOT_OK && i % 3 == 2) status = dot_submit_masks(tracker, s->frame.id, &s->masks);
  return status;
}

static void* run(void* argument) {
  worker* w = (worker*)argument;
  dot_tracker* tracker = make_searching_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  dot_object object = DOT_OBJECT_INIT;
  int i;
  if (s == NULL) exit(1);
  make_scene(s);
  w->status = DOT_OK;
  for (i = 0; i < FRAMES && w->status == DOT_OK; ++i) {
    w->status = track_any(tracker, s, i);
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

typedef struct visitor {
  pthread_t thread;
  dot_tracker* tracker;
  pthread_mutex_t* mutex; /* of `*last` */
  const int* last;        /* the visit that has begun is the last */
  int granted, busy, other;
} visitor;

static void count(visitor* v, dot_status status) {
  if (status == DOT_OK || status == DOT_NO_RESULT || status == DOT_INVALID_ARGUMENT)
    ++v->granted;
  else if (status == DOT_BUSY)
    ++v->busy;
  else
    ++v->other;
}

/* Whatever a second thread may call, again and again. */
static void* visit(void* argument) {
  visitor* v = (visitor*)argument;
  scene* s = (scene*)malloc(sizeof *s);
  static uint8_t mask[HEIGHT][WIDTH];
  int i, last = 0;
  if (s == NULL) exit(1);
  make_scene(s);
  for (i = 0; !last; ++i) {
    dot_object object = DOT_OBJECT_INIT;
    dot_camera_result camera = DOT_CAMERA_RESULT_INIT;
    dot_image view = DOT_IMAGE_INIT;
    uint32_t objects;
    CHECK(pthread_mutex_lock(v->mutex) == 0);
    last = *v->last;
    CHECK(pthread_mutex_unlock(v->mutex) == 0);
    count(v, dot_object_count(v->tracker, &objects));
    count(v, dot_get_object(v->tracker, 0, &object));
    count(v, dot_get_camera(v->tracker, &camera));
    count(v, dot_label_image(v->tracker, &view));
    count(v, dot_exclusion_mask(v->tracker, NULL, &mask[0][0], WIDTH, HEIGHT, WIDTH));
    count(v, dot_submit_masks(v->tracker, (uint64_t)i, &s->masks));
    if (i % 100 == 50) count(v, dot_reset(v->tracker));
  }
  free(s);
  return NULL;
}

/* Calls of two threads meet or do not, as it happens; each is done as a whole or refused as a whole. */
static void test_one_tracker_at_random(void) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  visitor owner = {0}, guest = {0};
  scene* s = (scene*)malloc(sizeof *s);
  int i, last = 0;
  if (s == NULL) exit(1);
  make_scene(s);
  owner.tracker = guest.tracker = make_searching_tracker();
  guest.mutex = &mutex;
  guest.last = &last;
  CHECK(pthread_create(&guest.thread, NULL, visit, &guest) == 0);
  for (i = 0; i < FRAMES; ++i) count(&owner, track_any(owner.tracker, s, i));
  CHECK(pthread_mutex_lock(&mutex) == 0);
  last = 1;
  CHECK(pthread_mutex_unlock(&mutex) == 0);
  CHECK(pthread_join(guest.thread, NULL) == 0);
  CHECK(owner.other == 0 && guest.other == 0);
  CHECK(owner.granted + owner.busy == FRAMES && guest.granted > 0);
  s->frame.masks = &s->masks;
  CHECK(track_next(owner.tracker, s) == DOT_OK);
  free(s);
  dot_destroy(owner.tracker);
}

int main(void) {
  test_two_trackers();
  test_one_tracker_at_random();
  test_one_tracker_twice();
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
