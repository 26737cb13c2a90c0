// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/* Sizes, numbers and initial values: what a program compiled long ago relies on. */

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dot/dot.h"
#include "scene.h"

/* On machines with 64-bit pointers. A struct may get longer; none of these offsets may change. */
static void test_layout(void) {
  if (sizeof(void*) != 8) return;
  CHECK(sizeof(dot_image) == 40 && offsetof(dot_image, data) == 24);
  CHECK(sizeof(dot_camera) == 56 && offsetof(dot_camera, fx) == 16);
  CHECK(sizeof(dot_setting) == 16);
  CHECK(sizeof(dot_options) == 48 && offsetof(dot_options, settings) == 24 && offsetof(dot_options, v0) == 32);
  CHECK(sizeof(dot_instance) == 40 && offsetof(dot_instance, mask) == 8 && offsetof(dot_instance, flags) == 32);
  CHECK(sizeof(dot_masks) == 24 && offsetof(dot_masks, ids) == 8);
  CHECK(sizeof(dot_camera_motion) == 392 && offsetof(dot_camera_motion, covariance) == 104);
  CHECK(sizeof(dot_frame) == 64 && offsetof(dot_frame, image) == 24 && offsetof(dot_frame, masks) == 40);
  CHECK(offsetof(dot_frame, camera_prior) == 56);
  CHECK(sizeof(dot_camera_result) == 496 && offsetof(dot_camera_result, masked_share) == 464 &&
        offsetof(dot_camera_result, T_cur_prev) == 40 && offsetof(dot_camera_result, small_instances) == 472 &&
        offsetof(dot_camera_result, suspicion_figure) == 480 && offsetof(dot_camera_result, suspicion) == 488);
  CHECK(sizeof(dot_camera_revision) == 408 && offsetof(dot_camera_revision, frame_id) == 8 &&
        offsetof(dot_camera_revision, timestamp) == 16 && offsetof(dot_camera_revision, T_cur_prev) == 24 &&
        offsetof(dot_camera_revision, covariance) == 120);
  CHECK(sizeof(dot_object) == 816 && offsetof(dot_object, p_moving) == 64 && offsetof(dot_object, T_o) == 72);
  CHECK(offsetof(dot_object, fused_velocity) == 608 && offsetof(dot_object, angular_velocity) == 704);
  CHECK(sizeof(dot_exclusion_policy) == 16);
}

/* Numbers that hosts have compiled in, and hand on to other languages. */
static void test_pinned_values(void) {
  CHECK(DOT_OK == 0 && DOT_INVALID_ARGUMENT == -1 && DOT_NO_RESULT == -2 && DOT_OUT_OF_MEMORY == -3);
  CHECK(DOT_INTERNAL == -4 && DOT_BUSY == -5);
  CHECK(DOT_FORMAT_GREY8 == 1 && DOT_FORMAT_BGR8 == 2 && DOT_FORMAT_RGB8 == 3 && DOT_FORMAT_BGRA8 == 4);
  CHECK(DOT_FORMAT_DEPTH_F32 == 5 && DOT_FORMAT_DEPTH_U16 == 6 && DOT_FORMAT_ID8 == 7 && DOT_FORMAT_ID16 == 8);
  CHECK(DOT_FORMAT_ID32 == 9 && DOT_FORMAT_LABEL8 == 10);
  CHECK(DOT_STATE_BACKGROUND == 0 && DOT_STATE_STATIC == 1 && DOT_STATE_MOVING == 2 && DOT_STATE_NOT_OBSERVABLE == 3);
  CHECK(DOT_REASON_NONE == 0 && DOT_REASON_NEW == 1 && DOT_REASON_LEAVES_IMAGE == 6 && DOT_REASON_LOST == 15);
  CHECK(DOT_REASON_TOO_MANY_OBJECTS == 16);
  CHECK(DOT_CAMERA_FIRST_FRAME == 0 && DOT_CAMERA_TRACKED == 1 && DOT_CAMERA_FROM_HOST == 2);
  CHECK(DOT_CAMERA_TOO_LITTLE_DEPTH == 3 && DOT_CAMERA_LOST == 4);
  CHECK(DOT_CLASSIFIER_VELOCITY == 0 && DOT_CLASSIFIER_ENTROPY == 1 && DOT_CLASSIFIER_ENTROPY_LITERAL == 2);
  CHECK(DOT_DEPTH_UNKNOWN == 0 && DOT_DEPTH_STEREO == 1 && DOT_DEPTH_RGBD == 2 && DOT_DEPTH_LIDAR == 3);
  CHECK(DOT_INSTANCE_ALWAYS_DYNAMIC == 1);
  CHECK(DOT_OBJECT_ALWAYS_DYNAMIC == 1 && DOT_OBJECT_SEGMENTED == 2 && DOT_OBJECT_DISCOVERED == 4);
  CHECK(DOT_EXCLUDE_NOT_OBSERVABLE == 1 && DOT_EXCLUDE_STATIC == 2 && DOT_EXCLUDE_INVERTED == 4);
  CHECK(DOT_LOG_ERROR == 1 && DOT_LOG_WARNING == 2 && DOT_LOG_INFO == 3);
}

static void test_options_init(void) {
  dot_options options;
  unsigned char before[sizeof options];
  memset(&options, 0xab, sizeof options);
  memcpy(before, &options, sizeof options);
  CHECK_CREATE_INVALID(dot_options_init(NULL, sizeof options), "options is NULL");
  CHECK_CREATE_INVALID(dot_options_init(&options, 0), "options.struct_size");
  CHECK_CREATE_INVALID(dot_options_init(&options, sizeof options - 1), "options.struct_size");
  CHECK_CREATE_INVALID(dot_options_init(&options, sizeof options + 8), "newer");
  CHECK(memcmp(&options, before, sizeof options) == 0);
  CHECK(dot_options_init(&options, sizeof options) == DOT_OK);
  CHECK(strcmp(dot_create_error(), "") == 0);
  CHECK(options.struct_size == sizeof options);
  CHECK(options.classifier == DOT_CLASSIFIER_VELOCITY);
  CHECK(options.depth_source == DOT_DEPTH_UNKNOWN);
  CHECK(options.v0 == 0.5);
  CHECK(options.background_points > 0 && options.object_points > 0);
  CHECK(options.stereo_sigma_px > 0);
  CHECK(options.setting_count == 0 && options.settings == NULL);
}

static void test_policy_init(void) {
  dot_exclusion_policy policy;
  memset(&policy, 0xab, sizeof policy);
  CHECK_CREATE_INVALID(dot_exclusion_policy_init(NULL, sizeof policy), "policy is NULL");
  CHECK_CREATE_INVALID(dot_exclusion_policy_init(&policy, sizeof policy + 8), "policy.struct_size");
  CHECK(policy.dilation != 2);
  CHECK(dot_exclusion_policy_init(&policy, sizeof policy) == DOT_OK);
  CHECK(policy.struct_size == sizeof policy && policy.flags == DOT_EXCLUDE_NOT_OBSERVABLE && policy.dilation == 2);
}

/* The macros are the init functions, and, where there is none, struct_size and zeros but for what they state. */
static void test_init_macros(void) {
  const dot_options options = DOT_OPTIONS_INIT;
  const dot_exclusion_policy policy = DOT_EXCLUSION_POLICY_INIT;
  dot_options options_made;
  dot_exclusion_policy policy_made;
  memset(&options_made, 0, sizeof options_made);
  memset(&policy_made, 0, sizeof policy_made);
  CHECK(dot_options_init(&options_made, sizeof options_made) == DOT_OK);
  CHECK(memcmp(&options, &options_made, sizeof options) == 0);
  CHECK(dot_exclusion_policy_init(&policy_made, sizeof policy_made) == DOT_OK);
  CHECK(memcmp(&policy, &policy_made, sizeof policy) == 0);

#define CHECK_INIT(type, macro, differs)            \
  do {                                              \
    type made = macro, plain;                       \
    memset(&plain, 0, sizeof plain);                \
    plain.struct_size = sizeof plain;               \
    differs;                                        \
    CHECK(memcmp(&made, &plain, sizeof made) == 0); \
  } while (0)
  CHECK_INIT(dot_image, DOT_IMAGE_INIT, (void)0);
  CHECK_INIT(dot_camera, DOT_CAMERA_INIT, (void)0);
  CHECK_INIT(dot_instance, DOT_INSTANCE_INIT, (plain.class_id = -1, plain.score = 1));
  CHECK_INIT(dot_masks, DOT_MASKS_INIT, (void)0);
  CHECK_INIT(dot_camera_motion, DOT_CAMERA_MOTION_INIT,
             plain.T_cur_prev[0] = plain.T_cur_prev[5] = plain.T_cur_prev[10] = 1);
  CHECK_INIT(dot_frame, DOT_FRAME_INIT, (void)0);
  CHECK_INIT(dot_camera_result, DOT_CAMERA_RESULT_INIT, (void)0);
  CHECK_INIT(dot_camera_revision, DOT_CAMERA_REVISION_INIT, (void)0);
  CHECK_INIT(dot_object, DOT_OBJECT_INIT, (void)0);
#undef CHECK_INIT
}

/* A program that was compiled when a struct was shorter gets what it knows, and its memory behind that is left alone.
 */
static void test_older_struct(void) {
  dot_tracker* tracker = make_tracker();
  scene* s = (scene*)malloc(sizeof *s);
  dot_camera_result camera = DOT_CAMERA_RESULT_INIT;
  if (s == NULL) exit(1);
  make_scene(s);
  CHECK(track_next(tracker, s) == DOT_OK);
  camera.struct_size = offsetof(dot_camera_result, masked_share);
  camera.masked_share = 77;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.frame_id == s->frame.id && camera.masked_share == 77);
  CHECK(camera.struct_size == offsetof(dot_camera_result, masked_share));
  {
    uint32_t size, accepted = 0;
    for (size = 0; size <= sizeof camera + 16; ++size) {
      dot_camera_result at_size = DOT_CAMERA_RESULT_INIT;
      at_size.struct_size = size;
      accepted += dot_get_camera(tracker, &at_size) == DOT_OK;
    }
    CHECK(accepted == 4); /* the sizes that were published, and none between */
  }
  {
    uint32_t size, accepted = 0, objects = 0;
    CHECK(dot_object_count(tracker, &objects) == DOT_OK && objects > 0);
    for (size = 0; size <= sizeof(dot_object) + 16; ++size) {
      dot_object object = DOT_OBJECT_INIT;
      object.struct_size = size;
      object.point_speed = 77;
      if (dot_get_object(tracker, 0, &object) != DOT_OK) continue;
      ++accepted;
      CHECK((object.point_speed == 77) == (size < sizeof(dot_object)));
    }
    CHECK(accepted == 2);
  }
  camera.struct_size = offsetof(dot_camera_result, small_instances);
  camera.small_instances = 77;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.small_instances == 77);
  camera.struct_size -= 1;
  CHECK_INVALID(tracker, dot_get_camera(tracker, &camera), "out.struct_size");
  camera.struct_size = offsetof(dot_camera_result, suspicion_figure);
  camera.suspicion_figure = 77;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.suspicion_figure == 77 && camera.reserved == 0);
  camera.struct_size = sizeof camera;
  CHECK(dot_get_camera(tracker, &camera) == DOT_OK);
  CHECK(camera.masked_share > 0 && camera.masked_share < 1);

  s->frame.struct_size = offsetof(dot_frame, camera_prior);
  s->frame.camera_prior = (const double*)&camera; /* not its memory: must not be read */
  CHECK(track_next(tracker, s) == DOT_OK);
  s->frame.struct_size -= 1;
  CHECK_INVALID(tracker, dot_track(tracker, &s->frame), "frame.struct_size");
  free(s);
  dot_destroy(tracker);
}

int main(void) {
  test_layout();
  test_pinned_values();
  test_options_init();
  test_policy_init();
  test_init_macros();
  test_older_struct();
  if (failures != 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}
