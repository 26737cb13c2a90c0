// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/* cycles_test [N]: N times a tracker is made, tracks two frames, one of them wrong, and is destroyed. Its memory must
 * not grow after the first quarter. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dot/dot.h"
#include "scene.h"

/* Few points: what is tried here is life and death, not tracking. */
static dot_tracker* make_small_tracker(void) {
  const dot_camera camera = make_camera();
  dot_options options = DOT_OPTIONS_INIT;
  dot_tracker* tracker = NULL;
  options.background_points = 100;
  options.object_points = 40;
  CHECK(dot_create(&camera, &options, &tracker) == DOT_OK);
  return tracker;
}

/* Pages in memory; 0 where the system does not tell. */
static long resident_pages(void) {
  long size = 0, resident = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (file == NULL) return 0;
  if (fscanf(file, "%ld %ld", &size, &resident) != 2) resident = 0;
  fclose(file);
  return resident;
}

int main(int argc, char** argv) {
  const int cycles = argc > 1 ? atoi(argv[1]) : 200;
  scene* s = (scene*)malloc(sizeof *s);
  long early = 0, late;
  int i;
  if (s == NULL) return 1;
  make_scene(s);
  for (i = 0; i < cycles; ++i) {
    dot_tracker* tracker = make_small_tracker();
    CHECK(track_next(tracker, s) == DOT_OK);
    CHECK_INVALID(tracker, dot_track(tracker, NULL), "frame is NULL");
    CHECK(track_next(tracker, s) == DOT_OK);
    dot_destroy(tracker);
    if (i == cycles / 4) early = resident_pages();
  }
  late = resident_pages();
  printf("%d cycles, %ld pages after a quarter of them, %ld at the end\n", cycles, early, late);
  CHECK(cycles > 0);
  CHECK(late <= early + early / 20); /* a twentieth for what an allocator keeps */
  free(s);
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
