/* SPDX-FileCopyrightText: 2026 The dot authors */
/* SPDX-License-Identifier: MIT */

/* The header before all others, twice, and all that it defines for initialisation: compiled as C99 and as C++98, never
 * run. */

#include "dot/dot.h"

extern const void* const dot_h_initial[];

static const dot_image image = DOT_IMAGE_INIT;
static const dot_camera camera = DOT_CAMERA_INIT;
static const dot_options options = DOT_OPTIONS_INIT;
static const dot_instance instance = DOT_INSTANCE_INIT;
static const dot_masks masks = DOT_MASKS_INIT;
static const dot_camera_motion camera_motion = DOT_CAMERA_MOTION_INIT;
static const dot_frame frame = DOT_FRAME_INIT;
static const dot_camera_result camera_result = DOT_CAMERA_RESULT_INIT;
static const dot_camera_revision camera_revision = DOT_CAMERA_REVISION_INIT;
static const dot_object object = DOT_OBJECT_INIT;
static const dot_exclusion_policy policy = DOT_EXCLUSION_POLICY_INIT;

const void* const dot_h_initial[] = {&image, &camera, &options,       &instance,        &masks, &camera_motion,
                                     &frame, &object, &camera_result, &camera_revision, &policy};

/* The second time. */
#include "dot/dot.h"
