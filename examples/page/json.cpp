// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace page {
namespace {

void write_text(std::ostream& out, const std::string& text) {
  out << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out << '\\' << c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == '<') {  // "</script>" would end the element it stands in
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out << code;
    } else {
      out << c;
    }
  }
  out << '"';
}

void write_number(std::ostream& out, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  out << (std::isfinite(value) ? text : "null");
}

/// For a member or an item.
void new_line(std::ostream& out, int indent) {
  if (indent != Json::one_line) out << '\n' << std::string(static_cast<std::size_t>(indent), ' ');
}

}  // namespace

void Json::set(const std::string& name, Json value) {
  std::get<std::vector<Member>>(value_).emplace_back(name, std::move(value));
}

void Json::push(Json value) { std::get<std::vector<Json>>(value_).push_back(std::move(value)); }

void Json::write(std::ostream& out, int indent) const {
  const bool spaced = indent != one_line;
  const int inner = spaced ? indent + 1 : one_line;
  if (const auto* flag = std::get_if<bool>(&value_)) {
    out << (*flag ? "true" : "false");
  } else if (const auto* whole = std::get_if<long>(&value_)) {
    out << *whole;
  } else if (const auto* number = std::get_if<double>(&value_)) {
    write_number(out, *number);
  } else if (const auto* text = std::get_if<std::string>(&value_)) {
    write_text(out, *text);
  } else if (const auto* items = std::get_if<std::vector<Json>>(&value_)) {
    // Lists of plain values on one line, others with a line for each.
    const bool flat = std::none_of(items->begin(), items->end(), [](const Json& item) {
      return std::holds_alternative<std::vector<Member>>(item.value_) ||
             std::holds_alternative<std::vector<Json>>(item.value_);
    });
    out << '[';
    for (std::size_t i = 0; i < items->size(); ++i) {
      if (i > 0) out << (flat && spaced ? ", " : ",");
      if (!flat) new_line(out, inner);
      (*items)[i].write(out, inner);
    }
    out << ']';
  } else if (const auto* members = std::get_if<std::vector<Member>>(&value_)) {
    out << '{';
    for (std::size_t i = 0; i < members->size(); ++i) {
      if (i > 0) out << ',';
      new_line(out, inner);
      write_text(out, (*members)[i].first);
      out << (spaced ? ": " : ":");
      (*members)[i].second.write(out, inner);
    }
    out << '}';
  } else {
    out << "null";
  }
}

}  // namespace page
