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
  const char* field;
  const char* member = "";
  std::ptrdiff_t instance = -1;  ///< < 0: none

  FieldName(const char* name) : field(name) {}  // NOLINT(google-explicit-constructor): as std::string has it
  FieldName(const char* name, const char* its_member, std::ptrdiff_t its_instance = -1)
      : field(name), member(its_member), instance(its_instance) {}

  operator std::string() const {  // NOLINT(google-explicit-constructor)
    return field + (instance < 0 ? std::string() : ".instances[" + std::to_string(instance) + "]") + member;
  }
};

inline std::string operator+(const FieldName& name, const char* more) { return std::string(name) + more; }

DOT_END_NAMESPACE
