/* SPDX-FileCopyrightText: 2026 The dot authors */
/* SPDX-License-Identifier: MIT */

#include "dot_h.c"
