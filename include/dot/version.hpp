// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Version of the headers; the build checks that it equals the project's.

#define DOT_VERSION_MAJOR 0
#define DOT_VERSION_MINOR 1
#define DOT_VERSION_PATCH 0
#define DOT_VERSION_STRING "0.1.0"
