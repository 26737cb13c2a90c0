// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Version of the headers; the build checks that it equals the project's.

/// Raised when the interface changes.
#define DOT_VERSION_MAJOR 0
/// Raised when the interface grows; before 1.0 it may also change.
#define DOT_VERSION_MINOR 1
/// Raised when something is mended.
#define DOT_VERSION_PATCH 0
/// The three as text.
#define DOT_VERSION_STRING "0.1.0"
