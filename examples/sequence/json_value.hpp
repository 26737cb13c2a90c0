// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace runner {

/// A value of a JSON document (RFC 8259), as it was read. Files have millions of numbers, so one takes 40 bytes.
class JsonValue {
 public:
  enum class Type { Null, Boolean, Number, String, Array, Object };
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;

  JsonValue() = default;
  /// @param value of one of the types.
  template <typename T, typename = std::enable_if_t<!std::is_same_v<std::decay_t<T>, JsonValue>>>
  explicit JsonValue(T&& value) : value_(std::forward<T>(value)) {}

  Type type() const { return static_cast<Type>(value_.index()); }
  bool is(Type t) const { return type() == t; }
  /// Of a boolean 0 or 1; 0 of other types. The functions below give nothing of other types than theirs, too.
  double number() const { return is(Type::Boolean) ? std::get<bool>(value_) : get<double>(); }
  const std::string& string() const { return get<std::string>(); }
  const Array& array() const { return get<Array>(); }
  const Object& object() const { return get<Object>(); }
  /// The member of an object, or null.
  const JsonValue* find(const std::string& name) const;

 private:
  template <typename T>
  const T& get() const {
    static const T nothing{};
    const T* found = std::get_if<T>(&value_);
    return found != nullptr ? *found : nothing;
  }

  std::variant<std::monostate, bool, double, std::string, Array, Object> value_;  ///< in the order of Type
};

/// @throws FileError "path:line: what is wrong".
JsonValue read_json(const std::filesystem::path& path);

}  // namespace runner
