// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "dot/dot.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Tracks one frame as a program in C does. NULL `ids`: no segmentation. `labels` and `track_ids` are dense.
/// @return 0, or 1 with the library's text on stderr.
int track_through_c(dot_tracker* tracker, const dot_camera* camera, uint64_t number, double seconds, const uint8_t* bgr,
                    const uint16_t* depth, const uint8_t* ids, uint8_t* labels, uint32_t* track_ids);

#ifdef __cplusplus
}
#endif
