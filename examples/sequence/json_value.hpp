// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace runner {

/// A value of a JSON document (RFC 8259), as it was read.
struct JsonValue {
  enum class Type { Null, Boolean, Number, String, Array, Object };
  Type type = Type::Null;
  double number = 0;  ///< of a boolean 0 or 1
  std::string string;
  std::vector<JsonValue> array;
  std::vector<std::pair<std::string, JsonValue>> object;

  bool is(Type t) const { return type == t; }
  /// The member of an object, or null.
  const JsonValue* find(const std::string& name) const;
};

/// @throws FileError "path:line: what is wrong".
JsonValue read_json(const std::filesystem::path& path);

}  // namespace runner
