// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace page {

/// A JSON value to be written; members keep their order. Numbers that are not finite become null.
class Json {
 public:
  using Member = std::pair<std::string, Json>;

  Json() = default;  ///< null
  Json(bool value) : value_(value) {}
  Json(int value) : value_(static_cast<long>(value)) {}
  Json(long value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}

  static Json object(std::vector<Member> members) { return Json(Value(std::move(members))); }
  static Json array(std::vector<Json> items = {}) { return Json(Value(std::move(items))); }

  /// Appends to an object.
  void set(const std::string& name, Json value);
  /// Appends to an array.
  void push(Json value);

  static constexpr int one_line = -1;

  /// @param indent of the value's own lines, or `one_line`: nothing but the value, without spaces and new lines.
  void write(std::ostream& out, int indent = 0) const;

 private:
  using Value = std::variant<std::monostate, bool, long, double, std::string, std::vector<Json>, std::vector<Member>>;
  explicit Json(Value value) : value_(std::move(value)) {}

  Value value_;
};

}  // namespace page
