// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dot/dot.h"
#include "scene.h"

static void test_version_and_strings(void) {
  const dot_status statuses[] = {DOT_OK,  DOT_INVALID_ARGUMENT, DOT_NO_RESULT, DOT_OUT_OF_MEMORY, DOT_INTERNAL,
                                 DOT_BUSY};
  size_t i, j;
  CHECK(dot_version() == DOT_HEADER_VERSION);
  CHECK(dot_abi_version() == DOT_ABI_VERSION);
  for (i = 0; i < sizeof statuses / sizeof *statuses; ++i) {
    CHECK(strlen(dot_status_string(statuses[i])) > 0);
    for (j = 0; j < i; ++j) CHECK(strcmp(dot_status_string(statuses[i]), dot_status_string(statuses[j])) != 0);
  }
  CHECK(strcmp(dot_status_string(12345), "unknown status") == 0);
}

static void test_create_errors(void) {
  dot_camera camera = make_camera();
  dot_options options;
  dot_setting settings[2];
  dot_tracker* tracker = (dot_tracker*)&camera;

  CHECK_CREATE_INVALID(dot_create(NULL, NULL, &tracker), "camera is NULL");
  CHECK(tracker == NULL);
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, NULL), "out is NULL");
  camera.struct_size = 4;
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, &tracker), "camera.struct_size");
  camera.struct_size = sizeof camera + 8;
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, &tracker), "camera.struct_size");
  camera = make_camera();
  camera.reserved = 1;
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, &tracker), "camera.reserved");
  camera = make_camera();
  camera.fx = 0;
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, &tracker), "fx");
  camera = make_camera();
  camera.width = -1;
  CHECK_CREATE_INVALID(dot_create(&camera, NULL, &tracker), "width");
  camera = make_camera();

#define CHECK_OPTION(assignment, field)                                 \
  CHECK(dot_options_init(&options, sizeof options) == DOT_OK);          \
  assignment;                                                           \
  CHECK_CREATE_INVALID(dot_create(&camera, &options, &tracker), field); \
  CHECK(tracker == NULL)
  CHECK_OPTION(options.struct_size = 0, "options.struct_size");
  CHECK_OPTION(options.classifier = 77, "options.classifier");
  CHECK_OPTION(options.depth_source = 77, "options.depth_source");
  CHECK_OPTION(options.background_points = 0, "options.background_points");
  CHECK_OPTION(options.object_points = -5, "options.object_points");
  CHECK_OPTION(options.v0 = -1, "options.v0");
  CHECK_OPTION(options.v0 = NAN, "options.v0");
  CHECK_OPTION(options.stereo_sigma_px = 0, "options.stereo_sigma_px");
  CHECK_OPTION(options.setting_count = 1, "options.settings is NULL");
#undef CHECK_OPTION

#define CHECK_SETTING(setting_name, setting_value, field)               \
  CHECK(dot_options_init(&options, sizeof options) == DOT_OK);          \
  settings[0].name = "velocity.decide";                                 \
  settings[0].value = 0.9;                                              \
  settings[1].name = setting_name;                                      \
  settings[1].value = setting_value;                                    \
  options.settings = settings;                                          \
  options.setting_count = 2;                                            \
  CHECK_CREATE_INVALID(dot_create(&camera, &options, &tracker), field); \
  CHECK(tracker == NULL)
  CHECK_SETTING(NULL, 1, "settings[1].name is NULL");
  CHECK_SETTING("velocity.nonsense", 1, "velocity.nonsense");
  CHECK_SETTING("", 1, "settings[1].name");
  CHECK_SETTING("velocity.nonsense", 1, "settings[1].name is unknown: velocity.nonsense");
  CHECK_SETTING("depth_noise.source", 1, "unknown: depth_noise.source; set options.depth_source instead");
  CHECK_SETTING("depth_source", 1, "set options.depth_source instead");
  CHECK_SETTING("classifier", 1, "set options.classifier instead");
  CHECK_SETTING("align.max_levels", 2.5, "align.max_levels");
  CHECK_SETTING("motion_prior.ground_vehicle", 2, "motion_prior.ground_vehicle");
  CHECK_SETTING("velocity.decide", INFINITY, "velocity.decide");
#undef CHECK_SETTING

  CHECK(dot_options_init(&options, sizeof options) == DOT_OK);
  settings[1].name = "mask.keep_seconds";
  settings[1].value = 0.5;
  options.settings = settings;
  options.setting_count = 2;
  options.depth_source = DOT_DEPTH_RGBD;
  CHECK(dot_create(&camera, &options, &tracker) == DOT_OK);
  CHECK(tracker != NULL);
  CHECK(strcmp(dot_create_error(), "") == 0);
  dot_destroy(tracker);
}

static void test_null_tracker(void) {
  scene* s = (scene*)malloc(sizeof *s);
  uint32_t count;
  dot_object object;
  dot_camera_result camera;
  dot_camera_revision revision;
  dot_image image;
  uint8_t byte;
  if (s == NULL) exit(1);
  make_scene(s);
  dot_destroy(NULL);
  CHECK_INVALID(NULL, dot_reset(NULL), "tracker is NULL");
  CHECK_INVALID(NULL, dot_track(NULL, &s->frame), "tracker is NULL");
  CHECK_INVALID(NULL, dot_label(NULL, &s->frame), "tracker is NULL");
  CHECK_INVALID(NULL, dot_prepare(NULL), "tracker is NULL");
  CHECK_INVALID(NULL, dot_submit_masks(NULL, 0, &s->masks), "tracker is NULL");
  CHECK_INVALID(NULL, dot_object_count(NULL, &count), "tracker is NULL");
  CHECK_INVALID(NULL, dot_get_object(NULL, 0, &object), "tracker is NULL");
  CHECK_INVALID(NULL, dot_get_camera(NULL, &camera), "tracker is NULL");
  CHECK_INVALID(NULL, dot_revision_count(NULL, &count), "tracker is NULL");
  CHECK_INVALID(NULL, dot_get_revision(NULL, 0, &revision), "tracker is NULL");
  CHECK_INVALID(NULL, dot_label_image(NULL, &image), "tracker is NULL");
  CHECK_INVALID(NULL, dot_id_image(NULL, &image), "tracker is NULL");
  CHECK_INVALID(NULL, dot_exclusion_mask(NULL, NULL, &byte, 1, 1, 1), "tracker is NULL");
  free(s);
}

static void test_no_result(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  uint8_t* out = (uint8_t*)malloc(WIDTH * HEIGHT);
  uint32_t count = 5;
  dot_object object;
  dot_camera_result camera;
  dot_camera_revision revision;
  dot_image image;
  int round;
  if (s == NULL || out == NULL) exit(1);
  make_scene(s);
  object.struct_size = sizeof object;
  camera.struct_size = sizeof camera;
  revision.struct_size = sizeof revision;
  image.struct_size = sizeof image;
  CHECK(strcmp(dot_last_error(tracker), "") == 0);
  for (round = 0; round < 2; ++round) {
    CHECK(dot_object_count(tracker, &count) == DOT_NO_RESULT);
    CHECK(count == 0);
    CHECK(dot_get_object(tracker, 0, &object) == DOT_NO_RESULT);
    CHECK(dot_get_camera(tracker, &camera) == DOT_NO_RESULT);
    count = 5;
    CHECK(dot_revision_count(tracker, &count) == DOT_NO_RESULT);
    CHECK(count == 0);
    CHECK(dot_get_revision(tracker, 0, &revision) == DOT_NO_RESULT);
    CHECK(dot_label_image(tracker, &image) == DOT_NO_RESULT);
    CHECK(dot_id_image(tracker, &image) == DOT_NO_RESULT);
    CHECK(dot_exclusion_mask(tracker, NULL, out, WIDTH, HEIGHT, WIDTH) == DOT_NO_RESULT);
    CHECK(strlen(dot_last_error(tracker)) > 0);
    CHECK(track_next(tracker, s) == DOT_OK);
    CHECK(strcmp(dot_last_error(tracker), "") == 0);
    CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
    CHECK(dot_reset(tracker) == DOT_OK);
  }
  dot_destroy(tracker);
  free(out);
  free(s);
}

/* Every bad frame names its field and leaves the tracker and its last result as they were. */
static void test_frame_errors(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  dot_camera_motion motion;
  double prior[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  dot_image mask;
  uint32_t count_before = 0, count = 0;
  dot_camera_result camera;
  dot_frame good;
  if (s == NULL) exit(1);
  make_scene(s);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(dot_object_count(tracker, &count_before) == DOT_OK);
  good = s->frame;
  good.id += 1;
  good.timestamp += 0.1;

#define CHECK_FRAME(change, field)                                \
  do {                                                            \
    make_scene(s);                                                \
    s->frame.id = good.id;                                        \
    s->frame.timestamp = good.timestamp;                          \
    memset(&motion, 0, sizeof motion);                            \
    motion.struct_size = sizeof motion;                           \
    motion.T_cur_prev[0] = 1;                                     \
    motion.T_cur_prev[5] = 1;                                     \
    motion.T_cur_prev[10] = 1;                                    \
    mask = view_of(s->ids, DOT_FORMAT_GREY8, WIDTH);              \
    change;                                                       \
    CHECK_INVALID(tracker, dot_track(tracker, &s->frame), field); \
  } while (0)

  CHECK_INVALID(tracker, dot_track(tracker, NULL), "frame is NULL");
  CHECK_FRAME(s->frame.struct_size = 0, "frame.struct_size");
  CHECK_FRAME(s->frame.struct_size = offsetof(dot_frame, camera_motion), "frame.struct_size");
  CHECK_FRAME(s->frame.struct_size = sizeof s->frame + 8, "frame.struct_size");
  /* A size that cuts a pointer in half: the half of it that is not there would be read as part of an address. */
  CHECK_FRAME((s->frame.camera_prior = prior, s->frame.struct_size = offsetof(dot_frame, camera_prior) + 4),
              "frame.struct_size");
  CHECK_FRAME(s->frame.reserved = 3, "frame.reserved");
  CHECK_FRAME(s->frame.timestamp = 0.2, "timestamp");
  CHECK_FRAME(s->frame.timestamp = NAN, "timestamp");

  CHECK_FRAME(s->frame.image = NULL, "frame.image is NULL");
  CHECK_FRAME(s->grey_view.struct_size = 1, "frame.image.struct_size");
  CHECK_FRAME(s->grey_view.format = 0, "frame.image.format");
  CHECK_FRAME(s->grey_view.format = 77, "frame.image.format");
  CHECK_FRAME(s->grey_view.format = DOT_FORMAT_DEPTH_U16, "frame.image.format");
  CHECK_FRAME(s->grey_view.format = DOT_FORMAT_LABEL8, "frame.image.format");
  CHECK_FRAME(s->grey_view.data = NULL, "frame.image.data");
  CHECK_FRAME(s->grey_view.width = 0, "frame.image.width");
  CHECK_FRAME(s->grey_view.height = -HEIGHT, "frame.image.height");
  CHECK_FRAME(s->grey_view.stride_bytes = WIDTH - 1, "frame.image.stride_bytes");
  CHECK_FRAME(s->grey_view.stride_bytes = -WIDTH, "frame.image.stride_bytes");
  CHECK_FRAME(s->grey_view.stride_bytes = INT64_MAX, "frame.image.stride_bytes");
  CHECK_FRAME(s->grey_view.width = WIDTH - 2, "image");
  CHECK_FRAME(s->grey_view.height = HEIGHT - 2, "image");

  CHECK_FRAME(s->frame.depth = NULL, "frame.depth is NULL");
  CHECK_FRAME(s->depth_view.struct_size = 12, "frame.depth.struct_size");
  CHECK_FRAME(s->depth_view.format = DOT_FORMAT_GREY8, "frame.depth.format");
  CHECK_FRAME(s->depth_view.data = NULL, "frame.depth.data");
  CHECK_FRAME(s->depth_view.data = (const char*)s->depth_view.data + 1, "frame.depth.data");
  CHECK_FRAME(s->depth_view.stride_bytes += 1, "frame.depth.stride_bytes");
  CHECK_FRAME(s->depth_view.stride_bytes = WIDTH, "frame.depth.stride_bytes");
  CHECK_FRAME(s->depth_view.format = DOT_FORMAT_DEPTH_U16, "depth_units_per_metre");
  CHECK_FRAME(s->depth_view.width = WIDTH / 2, "depth");

  CHECK_FRAME(s->masks.struct_size = 0, "frame.masks.struct_size");
  CHECK_FRAME(s->ids_view.struct_size = 0, "frame.masks.ids.struct_size");
  CHECK_FRAME(s->ids_view.format = DOT_FORMAT_GREY8, "frame.masks.ids.format");
  CHECK_FRAME(s->ids_view.data = NULL, "frame.masks.ids.data");
  CHECK_FRAME(s->ids_view.height = HEIGHT / 2, "ids");
  CHECK_FRAME(s->masks.instances = NULL, "frame.masks.instances");
  CHECK_FRAME(s->masks.ids = NULL, "frame.masks.instances[0].mask");
  CHECK_FRAME(s->person.struct_size = 0, "frame.masks.instances[0].struct_size");
  CHECK_FRAME(s->person.flags = 2, "frame.masks.instances[0].flags");
  CHECK_FRAME(s->person.reserved = 1, "frame.masks.instances[0].reserved");
  CHECK_FRAME((s->person.mask = &mask, mask.struct_size = 0), "frame.masks.instances[0].mask.struct_size");
  CHECK_FRAME((s->person.mask = &mask, mask.format = DOT_FORMAT_ID32), "frame.masks.instances[0].mask.format");
  CHECK_FRAME((s->person.mask = &mask, mask.data = NULL), "frame.masks.instances[0].mask.data");

  CHECK_FRAME((s->frame.camera_motion = &motion, motion.struct_size = 0), "frame.camera_motion.struct_size");
  CHECK_FRAME((s->frame.camera_motion = &motion, motion.reserved = 1), "frame.camera_motion.reserved");
  CHECK_FRAME((s->frame.camera_motion = &motion, motion.T_cur_prev[3] = NAN), "frame.camera_motion.T_cur_prev");
  CHECK_FRAME((s->frame.camera_motion = &motion, motion.covariance[7] = INFINITY), "frame.camera_motion.covariance");
  CHECK_FRAME((s->frame.camera_prior = prior, prior[0] = 2), "frame.camera_prior");
#undef CHECK_FRAME

  camera.struct_size = sizeof camera;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.frame_id == good.id - 1);
  CHECK(dot_object_count(tracker, &count) == DOT_OK);
  CHECK(count == count_before);
  make_scene(s);
  CHECK(dot_track(tracker, &good) == DOT_OK);
  CHECK(strcmp(dot_last_error(tracker), "") == 0);
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.frame_id == good.id);
  dot_destroy(tracker);
  free(s);
}

static void test_late_masks(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  const dot_masks* masks;
  dot_masks bad;
  dot_object object;
  uint32_t count = 5;
  uint64_t first;
  int i;
  if (s == NULL) exit(1);
  make_scene(s);
  masks = &s->masks;
  s->frame.masks = NULL;
  CHECK_INVALID(tracker, dot_submit_masks(tracker, 1, masks), "frame_id");
  first = s->frame.id + 1;
  for (i = 0; i < 3; ++i) CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(dot_object_count(tracker, &count) == DOT_OK && count == 0);

  CHECK_INVALID(tracker, dot_submit_masks(tracker, first, NULL), "masks is NULL");
  CHECK_INVALID(tracker, dot_submit_masks(tracker, first + 3, masks), "frame_id");
  bad = *masks;
  bad.struct_size = 0;
  CHECK_INVALID(tracker, dot_submit_masks(tracker, first, &bad), "masks.struct_size");
  bad = *masks;
  bad.ids = &s->depth_view;
  CHECK_INVALID(tracker, dot_submit_masks(tracker, first, &bad), "masks.ids.format");
  bad = *masks;
  bad.ids = NULL;
  CHECK_INVALID(tracker, dot_submit_masks(tracker, first, &bad), "masks.instances[0].mask is NULL and masks.ids too");

  CHECK(dot_submit_masks(tracker, first + 1, masks) == DOT_OK);
  CHECK(strcmp(dot_last_error(tracker), "") == 0);
  CHECK(dot_object_count(tracker, &count) == DOT_OK && count == 0);
  CHECK_INVALID(tracker, dot_submit_masks(tracker, first, masks), "frame_id");
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(dot_object_count(tracker, &count) == DOT_OK && count == 2);
  object.struct_size = sizeof object;
  for (i = 0; i < 2; ++i) {
    CHECK(dot_get_object(tracker, (uint32_t)i, &object) == DOT_OK);
    CHECK(abs(object.box[0] - (i == 0 ? 20 : 100)) <= 1 && abs(object.box[1] - 40) <= 1);
    CHECK((object.flags & DOT_OBJECT_SEGMENTED) == 0);
  }
  CHECK((object.flags & DOT_OBJECT_ALWAYS_DYNAMIC) != 0 && object.class_id == 42);
  dot_destroy(tracker);
  free(s);
}

static void test_camera_prior(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  dot_camera_result camera;
  double prior[12] = {1, 0, 0, 0.25, 0, 1, 0, 0, 0, 0, 1, 0};
  if (s == NULL) exit(1);
  make_scene(s);
  CHECK(track_next(tracker, s) == DOT_OK);
  s->frame.camera_prior = prior;
  CHECK(track_next(tracker, s) == DOT_OK);
  camera.struct_size = sizeof camera;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.status == DOT_CAMERA_TRACKED && fabs(camera.T_cur_prev[3]) < 0.01);
  /* Nothing to align to: the prior is the guess. */
  memset(s->grey, 9, sizeof s->grey);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.status == DOT_CAMERA_LOST && camera.T_cur_prev[3] == 0.25);
  dot_destroy(tracker);
  free(s);
}

static void test_getter_errors(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  uint8_t* out = (uint8_t*)malloc(WIDTH * HEIGHT);
  uint32_t count = 0;
  dot_object object;
  dot_camera_result camera;
  dot_camera_revision revision = DOT_CAMERA_REVISION_INIT;
  dot_image image;
  dot_exclusion_policy policy;
  if (s == NULL || out == NULL) exit(1);
  make_scene(s);
  CHECK(track_next(tracker, s) == DOT_OK);

  CHECK_INVALID(tracker, dot_object_count(tracker, NULL), "count is NULL");
  CHECK(dot_object_count(tracker, &count) == DOT_OK);
  CHECK(count > 0);
  object.struct_size = sizeof object;
  CHECK_INVALID(tracker, dot_get_object(tracker, count, &object), "index");
  CHECK_INVALID(tracker, dot_get_object(tracker, UINT32_MAX, &object), "index");
  CHECK_INVALID(tracker, dot_get_object(tracker, 0, NULL), "out is NULL");
  object.struct_size = 8;
  CHECK_INVALID(tracker, dot_get_object(tracker, 0, &object), "out.struct_size");
  object.struct_size = sizeof object + 8;
  CHECK_INVALID(tracker, dot_get_object(tracker, 0, &object), "out.struct_size");
  CHECK_INVALID(tracker, dot_revision_count(tracker, NULL), "count is NULL");
  CHECK(dot_revision_count(tracker, &count) == DOT_OK && count == 0);
  CHECK_INVALID(tracker, dot_get_revision(tracker, 0, &revision), "there are 0 revisions");
  CHECK_INVALID(tracker, dot_get_camera(tracker, NULL), "out is NULL");
  camera.struct_size = 0;
  CHECK_INVALID(tracker, dot_get_camera(tracker, &camera), "out.struct_size");
  CHECK_INVALID(tracker, dot_label_image(tracker, NULL), "out is NULL");
  CHECK_INVALID(tracker, dot_id_image(tracker, NULL), "out is NULL");
  image.struct_size = 0;
  CHECK_INVALID(tracker, dot_label_image(tracker, &image), "out.struct_size");
  CHECK_INVALID(tracker, dot_id_image(tracker, &image), "out.struct_size");

  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, NULL, NULL, WIDTH, HEIGHT, WIDTH), "data is NULL");
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, NULL, out, WIDTH - 1, HEIGHT, WIDTH), "width");
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, NULL, out, WIDTH, HEIGHT + 1, WIDTH), "height");
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, NULL, out, WIDTH, HEIGHT, WIDTH - 1), "stride_bytes");
  memset(&policy, 0, sizeof policy);
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, WIDTH), "policy.struct_size");
  policy.struct_size = sizeof policy;
  policy.flags = 8;
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, WIDTH), "policy.flags");
  policy.flags = 0;
  policy.dilation = -1;
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, WIDTH), "policy.dilation");
  policy.dilation = 0;
  policy.reserved = 1;
  CHECK_INVALID(tracker, dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, WIDTH), "policy.reserved");

  CHECK(track_next(tracker, s) == DOT_OK);
  dot_destroy(tracker);
  free(out);
  free(s);
}

static const uint8_t* row8(const dot_image* image, int y) {
  return (const uint8_t*)image->data + y * image->stride_bytes;
}

static const uint32_t* row32(const dot_image* image, int y) {
  return (const uint32_t*)(const void*)((const uint8_t*)image->data + y * image->stride_bytes);
}

/* Finds the object that was associated with an id of the segmentation. */
static int find_instance(dot_tracker* tracker, uint32_t instance_id, dot_object* out) {
  uint32_t i, count = 0;
  CHECK(dot_object_count(tracker, &count) == DOT_OK);
  for (i = 0; i < count; ++i) {
    memset(out, 0, sizeof *out);
    out->struct_size = sizeof *out;
    CHECK(dot_get_object(tracker, i, out) == DOT_OK);
    CHECK(out->struct_size == sizeof *out);
    if ((out->flags & DOT_OBJECT_SEGMENTED) != 0 && out->instance_id == instance_id) return 1;
  }
  return 0;
}

/* Labels, ids, objects and the exclusion mask of one tracker agree with one another. */
static void test_result(void) {
  enum { PADDED = WIDTH + 13 };
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  uint8_t* out = (uint8_t*)malloc((size_t)PADDED * HEIGHT);
  dot_object car, person;
  dot_camera_result camera;
  dot_image labels, ids;
  dot_exclusion_policy policy;
  uint32_t person_id = 0, car_id = 0;
  int frame, x, y;
  if (s == NULL || out == NULL) exit(1);
  make_scene(s);
  memset(&policy, 0, sizeof policy);
  policy.struct_size = sizeof policy;
  camera.struct_size = labels.struct_size = ids.struct_size = 0;
  for (frame = 0; frame < 4; ++frame) {
    int person_area = 0, wrong_state = 0, wrong_exclusion = 0, wrong_wide = 0, padding_touched = 0;
    CHECK(track_next(tracker, s) == DOT_OK);
    camera.struct_size = sizeof camera;
    CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
    CHECK(camera.frame_id == s->frame.id);
    CHECK(camera.timestamp == s->frame.timestamp);
    CHECK(camera.status == (frame == 0 ? (uint32_t)DOT_CAMERA_FIRST_FRAME : (uint32_t)DOT_CAMERA_TRACKED));
    CHECK(fabs(camera.T_cur_prev[0] - 1) < 1e-3 && fabs(camera.T_cur_prev[3]) < 1e-2);
    CHECK(frame == 0 || fabs(camera.interval - 0.1) < 1e-9);

    CHECK(find_instance(tracker, PERSON, &person));
    CHECK(person.state == DOT_STATE_MOVING);
    CHECK((person.flags & DOT_OBJECT_ALWAYS_DYNAMIC) != 0);
    CHECK(person.class_id == 42 && person.score == 0.5f);
    CHECK(person.id != 0 && (frame == 0 || person.id == person_id));
    person_id = person.id;
    CHECK(find_instance(tracker, CAR, &car));
    CHECK((car.flags & DOT_OBJECT_ALWAYS_DYNAMIC) == 0);
    CHECK(frame > 0 || (car.state == DOT_STATE_NOT_OBSERVABLE && car.reason == DOT_REASON_NEW));
    CHECK(car.id != 0 && car.id != person.id && (frame == 0 || car.id == car_id));
    car_id = car.id;
    CHECK(car.box[0] >= 0 && car.box[2] > 0 && car.box[0] + car.box[2] <= WIDTH);

    labels.struct_size = sizeof labels;
    ids.struct_size = sizeof ids;
    CHECK(dot_label_image(tracker, &labels) == DOT_OK);
    CHECK(dot_id_image(tracker, &ids) == DOT_OK);
    CHECK(labels.format == DOT_FORMAT_LABEL8 && labels.width == WIDTH && labels.height == HEIGHT);
    CHECK(ids.format == DOT_FORMAT_ID32 && ids.width == WIDTH && ids.height == HEIGHT);
    CHECK(labels.stride_bytes >= WIDTH && ids.stride_bytes >= 4 * WIDTH);

    memset(out, 77, (size_t)PADDED * HEIGHT);
    policy.flags = 0;
    CHECK(dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, PADDED) == DOT_OK);
    for (y = 0; y < HEIGHT; ++y) {
      for (x = 0; x < WIDTH; ++x) {
        const uint32_t id = row32(&ids, y)[x];
        const uint8_t label = row8(&labels, y)[x];
        const uint32_t state = id == 0 ? (uint32_t)DOT_STATE_BACKGROUND : id == person.id ? person.state : car.state;
        person_area += id == person.id;
        wrong_state += label != state || (id != 0 && id != person.id && id != car.id);
        wrong_exclusion += out[y * PADDED + x] != (label == DOT_STATE_MOVING ? 255 : 0);
      }
      for (x = WIDTH; x < PADDED; ++x) padding_touched += out[y * PADDED + x] != 77;
    }
    CHECK(wrong_state == 0);
    CHECK(wrong_exclusion == 0);
    CHECK(padding_touched == 0);
    CHECK(person_area == person.area && person_area > 1000);
    CHECK(row8(&labels, 65)[115] == DOT_STATE_MOVING && row8(&labels, 10)[80] == DOT_STATE_BACKGROUND);

    policy.flags = DOT_EXCLUDE_NOT_OBSERVABLE | DOT_EXCLUDE_STATIC;
    CHECK(dot_exclusion_mask(tracker, &policy, out, WIDTH, HEIGHT, PADDED) == DOT_OK);
    for (y = 0; y < HEIGHT; ++y)
      for (x = 0; x < WIDTH; ++x) wrong_wide += out[y * PADDED + x] != (row32(&ids, y)[x] != 0 ? 255 : 0);
    CHECK(wrong_wide == 0);
  }

  /* Default policy: widened by 2 pixels. */
  CHECK(dot_exclusion_mask(tracker, NULL, out, WIDTH, HEIGHT, PADDED) == DOT_OK);
  CHECK(out[65 * PADDED + person.box[0]] == 255);
  CHECK(out[65 * PADDED + person.box[0] - 2] == 255);
  CHECK(out[65 * PADDED + person.box[0] - 4] == 0);

  /* Ids are not used again after a reset. */
  CHECK(dot_reset(tracker) == DOT_OK);
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(find_instance(tracker, PERSON, &person));
  CHECK(person.id != person_id && person.id != car_id);
  dot_destroy(tracker);
  free(out);
  free(s);
}

/* Formats with other element sizes, instances with masks of their own, no masks, a camera motion of the host. */
static void test_other_inputs(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  uint8_t* bgra = (uint8_t*)malloc((size_t)WIDTH * HEIGHT * 4);
  uint16_t* depth = (uint16_t*)malloc((size_t)WIDTH * HEIGHT * 2);
  uint8_t patch[50 * 30];
  dot_image patch_view;
  dot_instance instances[2];
  dot_camera_motion motion;
  dot_camera_result camera;
  dot_object object;
  uint32_t count = 0;
  int x, y;
  if (s == NULL || bgra == NULL || depth == NULL) exit(1);
  make_scene(s);
  for (y = 0; y < HEIGHT; ++y)
    for (x = 0; x < WIDTH; ++x) {
      memset(bgra + 4 * (y * WIDTH + x), s->grey[y][x], 4);
      depth[y * WIDTH + x] = (uint16_t)(s->depth[y][x] * 256);
    }
  s->grey_view = view_of(bgra, DOT_FORMAT_BGRA8, 4 * WIDTH);
  s->depth_view = view_of(depth, DOT_FORMAT_DEPTH_U16, 2 * WIDTH);
  s->depth_view.depth_units_per_metre = 256;

  memset(patch, 1, sizeof patch);
  patch_view = view_of(patch, DOT_FORMAT_ID8, 30);
  patch_view.width = 30;
  patch_view.height = 50;
  memset(instances, 0, sizeof instances);
  instances[0].struct_size = sizeof instances[0];
  instances[0].id = 3;
  instances[0].mask = &patch_view;
  instances[0].x = 100;
  instances[0].y = 40;
  instances[0].class_id = 5;
  instances[1] = instances[0];
  instances[1].id = 4;
  instances[1].x = 30;
  instances[1].class_id = 6;
  s->masks.ids = NULL;
  s->masks.instances = instances;
  s->masks.instance_count = 2;
  CHECK(track_next(tracker, s) == DOT_OK);
  CHECK(find_instance(tracker, 4, &object) && object.class_id == 6);
  CHECK(abs(object.box[0] - 30) <= 1 && abs(object.box[1] - 40) <= 1 && abs(object.box[2] - 30) <= 2);
  CHECK(find_instance(tracker, 3, &object) && object.class_id == 5);
  CHECK(abs(object.box[0] - 100) <= 1);

  instances[1].flags = 8;
  s->frame.timestamp += 0.1;
  CHECK_INVALID(tracker, dot_track(tracker, &s->frame), "frame.masks.instances[1].flags");
  s->frame.timestamp -= 0.1;
  instances[1].flags = 0;

  memset(&motion, 0, sizeof motion);
  motion.struct_size = sizeof motion;
  motion.T_cur_prev[0] = motion.T_cur_prev[5] = motion.T_cur_prev[10] = 1;
  motion.T_cur_prev[3] = 1e-5;
  for (x = 0; x < 6; ++x) motion.covariance[7 * x] = 1e-8;
  s->frame.camera_motion = &motion;
  s->frame.masks = NULL;
  CHECK(track_next(tracker, s) == DOT_OK);
  camera.struct_size = sizeof camera;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.status == DOT_CAMERA_FROM_HOST);
  CHECK(fabs(camera.T_cur_prev[3] - 1e-5) < 1e-9 && fabs(camera.covariance[35] - 1e-8) < 1e-12);
  CHECK(dot_object_count(tracker, &count) == DOT_OK);
  CHECK(count == 2);

  /* The network ran and saw nothing. */
  s->masks.instance_count = 0;
  s->masks.instances = NULL;
  s->frame.masks = &s->masks;
  s->frame.camera_motion = NULL;
  CHECK(track_next(tracker, s) == DOT_OK);
  dot_destroy(tracker);
  free(depth);
  free(bgra);
  free(s);
}

static void test_independence(void) {
  dot_tracker* a = make_tracker();
  dot_tracker* b = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  uint32_t count;
  if (s == NULL) exit(1);
  make_scene(s);
  CHECK(track_next(a, s) == DOT_OK);
  CHECK(dot_object_count(b, &count) == DOT_NO_RESULT);
  CHECK(strcmp(dot_last_error(a), "") == 0);
  CHECK(strlen(dot_last_error(b)) > 0);
  dot_destroy(b);
  CHECK(dot_object_count(a, &count) == DOT_OK);
  dot_destroy(a);
  free(s);
}

int main(void) {
  test_version_and_strings();
  test_create_errors();
  test_null_tracker();
  test_no_result();
  test_frame_errors();
  test_late_masks();
  test_camera_prior();
  test_getter_errors();
  test_result();
  test_other_inputs();
  test_independence();
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
