// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#pragma once

#include <stdio.h>
#include <string.h>

#include "dot/dot.h"

/* Of this program; its main ends with 1 when it is not 0. */
static int failures = 0;

#define CHECK(condition)                                                     \
  do {                                                                       \
    if (!(condition)) {                                                      \
      fprintf(stderr, "%s:%d: CHECK(%s)\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                            \
    }                                                                        \
  } while (0)

/* A call that must fail on its arguments, with a text that contains `field`. */
#define CHECK_INVALID(tracker, call, field)                           \
  do {                                                                \
    const dot_status status_ = (call);                                \
    check_invalid(status_, dot_last_error(tracker), field, __LINE__); \
  } while (0)
#define CHECK_CREATE_INVALID(call, field)                        \
  do {                                                           \
    const dot_status status_ = (call);                           \
    check_invalid(status_, dot_create_error(), field, __LINE__); \
  } while (0)

static inline void check_invalid(dot_status status, const char* text, const char* field, int line) {
  if (status == DOT_INVALID_ARGUMENT && strstr(text, field) != NULL) return;
  fprintf(stderr, "%s:%d: status %d, text \"%s\"; expected an invalid argument, text with \"%s\"\n", __FILE__, line,
          (int)status, text, field);
  ++failures;
}
