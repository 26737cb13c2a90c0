// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "json_value.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>

#include "errors.hpp"
#include "fields.hpp"
#include "text.hpp"

namespace runner {
namespace {

class Parser {
 public:
  Parser(const std::filesystem::path& path, const std::string& text) : path_(path), text_(text) {}

  JsonValue document() {
    JsonValue value = parse(0);
    skip_white();
    if (at_ < text_.size()) fail("something follows the document");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    runner::fail({path_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n'))}, what);
  }

  void skip_white() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  /// The next character that is not white space.
  char peek() {
    skip_white();
    if (at_ >= text_.size()) fail("the file is cut short");
    return text_[at_];
  }

  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(std::string("'") + c + "' is missing");
  }

  JsonValue parse(int depth) {
    constexpr int deepest = 64;
    if (depth > deepest) fail("is nested too deep");
    const char c = peek();
    if (c == '{') {
      JsonValue::Object object;
      list('{', '}', [&] {
        if (peek() != '"') fail("a name is missing");
        std::string name = string();
        expect(':');
        object.emplace_back(std::move(name), parse(depth + 1));
      });
      object.shrink_to_fit();
      return JsonValue(std::move(object));
    }
    if (c == '[') {
      JsonValue::Array array;
      list('[', ']', [&] { array.push_back(parse(depth + 1)); });
      array.shrink_to_fit();
      return JsonValue(std::move(array));
    }
    if (c == '"') return JsonValue(string());
    if (word("true") || word("false")) return JsonValue(c == 't');
    if (word("null")) return {};
    return JsonValue(number());
  }

  template <typename Item>
  void list(char open, char close, const Item& item) {
    expect(open);
    if (take(close)) return;
    do item();
    while (take(','));
    expect(close);
  }

  bool word(const std::string& word) {
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }

  double number() {
    const std::size_t end = std::min(text_.find_first_not_of("0123456789+-.eE", at_), text_.size());
    const std::optional<double> value = parse_number(text_.substr(at_, end - at_));
    if (!value) fail("a value is missing, or is not a number");
    at_ = end;
    return *value;
  }

  std::string string() {
    std::string value;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] != '\\')
        value += text_[at_];
      else
        escape(value);
    }
    if (at_ >= text_.size()) fail("the file is cut short");
    ++at_;
    return value;
  }

  void escape(std::string& value) {
    const std::string from = "\"\\/bfnrt", to = "\"\\/\b\f\n\r\t";
    if (++at_ >= text_.size()) fail("the file is cut short");
    const std::size_t simple = from.find(text_[at_]);
    if (simple != std::string::npos) {
      value += to[simple];
      return;
    }
    if (text_[at_] != 'u') fail("has an unknown escape");
    std::uint32_t code = hexadecimal();
    if (code >= 0xD800 && code < 0xDC00) {  // the first half of a pair
      if (text_.compare(at_ + 1, 2, "\\u") != 0) fail("has half of a surrogate pair");
      at_ += 2;
      code = 0x10000 + ((code - 0xD800) << 10) + (hexadecimal() - 0xDC00);
    }
    append_utf8(value, code);
  }

  /// The four digits after the present place, which moves to the last one.
  std::uint32_t hexadecimal() {
    std::uint32_t code = 0;
    for (int i = 0; i < 4; ++i) {
      if (++at_ >= text_.size()) fail("the file is cut short");
      const std::size_t digit = std::string("0123456789abcdefABCDEF").find(text_[at_]);
      if (digit == std::string::npos) fail("has an unknown escape");
      code = 16 * code + static_cast<std::uint32_t>(digit < 16 ? digit : digit - 6);
    }
    return code;
  }

  static void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    const auto rest = [&](int shift) { put(0x80 | ((code >> shift) & 0x3F)); };
    if (code < 0x80) {
      put(code);
    } else if (code < 0x800) {
      put(0xC0 | (code >> 6)), rest(0);
    } else if (code < 0x10000) {
      put(0xE0 | (code >> 12)), rest(6), rest(0);
    } else {
      put(0xF0 | ((code >> 18) & 7)), rest(12), rest(6), rest(0);
    }
  }

  const std::filesystem::path& path_;
  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(const std::string& name) const {
  for (const auto& [key, value] : object())
    if (key == name) return &value;
  return nullptr;
}

JsonValue read_json(const std::filesystem::path& path) {
  std::string text;
  try {
    std::ifstream stream(path, std::ios::binary);
    stream.exceptions(std::ios::badbit);
    if (!stream) throw FileError(path.string() + ": cannot be read");
    text.assign(std::istreambuf_iterator<char>(stream), {});
  } catch (const std::ios_base::failure&) {
    throw FileError(path.string() + ": cannot be read");
  }
  drop_byte_order_mark(path, text);
  return Parser(path, text).document();
}

}  // namespace runner
