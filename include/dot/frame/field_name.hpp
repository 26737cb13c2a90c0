// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Name of a field in an error message: `field`, `field.instances[i]`, or a member of either. The string is built only
/// for an error, so that valid input needs no allocation.
struct FieldName {
  const char* field;             ///< such as "masks"
  const char* member = "";       ///< with its dot, such as ".width"
  std::ptrdiff_t instance = -1;  ///< < 0: none

  /// A field.
  FieldName(const char* name) : field(name) {}  // NOLINT(google-explicit-constructor): as std::string has it
  /// A member of a field, or of its i-th instance.
  FieldName(const char* name, const char* its_member, std::ptrdiff_t its_instance = -1)
      : field(name), member(its_member), instance(its_instance) {}

  /// The whole name, as in the message.
  operator std::string() const {  // NOLINT(google-explicit-constructor)
    return field + (instance < 0 ? std::string() : ".instances[" + std::to_string(instance) + "]") + member;
  }
};

/// The name with more text behind it.
inline std::string operator+(const FieldName& name, const char* more) { return std::string(name) + more; }

DOT_END_NAMESPACE
