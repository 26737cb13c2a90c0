// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "dot/dot.h"
#include "dot/frame/field_name.hpp"

/// @file
/// Checks the sizes of structs of dot.h and copies them in and out.

namespace dot_c {

using dot::FieldName;

[[noreturn]] inline void invalid(const std::string& message) { throw std::invalid_argument(message); }

/// Sizes of a struct in all published versions. If a struct grows, add the offset of its first new field here. Any size
/// in between would cut a field in half.
template <typename T>
constexpr std::array<std::uint32_t, 1> published_sizes{sizeof(T)};
template <>
inline constexpr std::array<std::uint32_t, 4> published_sizes<dot_camera_result>{
    offsetof(dot_camera_result, masked_share), offsetof(dot_camera_result, small_instances),
    offsetof(dot_camera_result, suspicion_figure), sizeof(dot_camera_result)};
template <>
inline constexpr std::array<std::uint32_t, 2> published_sizes<dot_frame>{offsetof(dot_frame, camera_prior),
                                                                         sizeof(dot_frame)};
template <>
inline constexpr std::array<std::uint32_t, 2> published_sizes<dot_object>{offsetof(dot_object, angular_velocity),
                                                                          sizeof(dot_object)};

template <typename T>
void check_size(std::uint32_t size, const FieldName& name) {
  for (const std::uint32_t published : published_sizes<T>)
    if (size == published) return;
  invalid(name + ".struct_size is " + std::to_string(size) + ", must be sizeof, " + std::to_string(sizeof(T)) +
          (size > sizeof(T) ? " in this library: is the header newer?" : ""));
}

/// Copies a struct of the caller; fields that its header did not have are zero.
template <typename T>
T read(const T* in, const FieldName& name) {
  static_assert(std::is_trivial_v<T>);
  if (in == nullptr) invalid(name + " is NULL");
  check_size<T>(in->struct_size, name);
  T out{};
  std::memcpy(&out, in, in->struct_size);
  return out;
}

/// Fills in a struct of the caller, up to the size in the caller's header.
template <typename T>
void write(const T& value, T* out, const char* name) {
  if (out == nullptr) invalid(std::string(name) + " is NULL");
  check_size<T>(out->struct_size, name);
  const std::uint32_t size = out->struct_size;
  std::memcpy(out, &value, size);
  out->struct_size = size;
}

inline void check_reserved(std::uint32_t value, const FieldName& name) {
  if (value != 0) invalid(name + ".reserved is " + std::to_string(value) + ", must be 0");
}

inline void check_flags(std::uint32_t flags, std::uint32_t known, const FieldName& name) {
  if ((flags & ~known) != 0) invalid(name + ".flags is " + std::to_string(flags) + ", has unknown bits");
}

}  // namespace dot_c
