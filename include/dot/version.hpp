// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Version of the headers; the build checks that it equals the project's.

#define DOT_VERSION_MAJOR 0         ///< changes the interface
#define DOT_VERSION_MINOR 1         ///< adds to the interface; before 1.0 it may change it
#define DOT_VERSION_PATCH 0         ///< mends only
#define DOT_VERSION_STRING "0.1.0"  ///< "major.minor.patch"
