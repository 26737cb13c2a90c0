// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// DOT_EXPORT marks the interface of the compiled tier (libdot_core).
///
/// It works for a static and a shared library, with and without CMake; a user defines nothing. Windows needs no
/// dllimport for classes without data members. Functions are found through the import library.

/// @def DOT_EXPORT
/// Before a class or function: part of that interface.
#if defined(_WIN32)
#if defined(DOT_CORE_EXPORTS)
#define DOT_EXPORT __declspec(dllexport)
#else
#define DOT_EXPORT
#endif
#elif defined(__GNUC__)
#define DOT_EXPORT __attribute__((visibility("default")))
#else
#define DOT_EXPORT
#endif
