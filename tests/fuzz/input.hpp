// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

/// @file
/// How an input of a fuzzer becomes choices, and how what it finds is reported.

namespace fuzz {

/// Ends the process with a finding that names the place.
[[noreturn]] inline void violated(const char* file, int line, const char* what, const char* detail = "") {
  std::fprintf(stderr, "%s:%d: violated: %s %s\n", file, line, what, detail);
  std::abort();
}
#define FUZZ_DEMAND(condition) ((condition) ? void() : ::fuzz::violated(__FILE__, __LINE__, #condition))
#define FUZZ_DEMAND_FOR(condition, detail) \
  ((condition) ? void() : ::fuzz::violated(__FILE__, __LINE__, #condition, detail))

/// Bytes, one choice each. Behind the end come zeros, which mean the ordinary case everywhere.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }
  int byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  /// The next `size` bytes as an input of their own: however many of them are read, the next record starts behind them.
  Input record(std::size_t size) {
    size = std::min(size, size_);
    const Input out(data_, size);
    data_ += size;
    size_ -= size;
    return out;
  }
  /// 0 to count - 1.
  int choice(int count) { return byte() % count; }
  /// 0 gives `low`; the steps are even up to `high`.
  double between(double low, double high) { return low + (high - low) * byte() / 255; }
  /// -reach to reach, 0 for the byte 0.
  double about_zero(double reach) { return reach * static_cast<std::int8_t>(byte()) / 127; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/// Numbers at which something ends or begins.
inline double odd_number(int choice) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double numbers[] = {0,
                                -0.0,
                                1,
                                -1,
                                0.5,
                                2,
                                1e-3,
                                1e-6,
                                1e-12,
                                1e-38,
                                1e-300,
                                std::numeric_limits<double>::denorm_min(),
                                3,
                                10,
                                100,
                                255,
                                256,
                                1e3,
                                65536,
                                1e6,
                                1e9,
                                2147483647.0,
                                2147483648.0,
                                -2147483648.0,
                                4294967296.0,
                                1e20,
                                3.5e38,
                                1e154,
                                1e300,
                                -1e300,
                                1.7e308,
                                infinity,
                                -infinity,
                                std::numeric_limits<double>::quiet_NaN()};
  constexpr int count = sizeof numbers / sizeof *numbers;
  return numbers[choice % count];
}

inline std::int32_t odd_integer(int choice) {
  const double number = odd_number(choice);
  return std::isnan(number) ? 0 : static_cast<std::int32_t>(std::clamp(number, -2147483648.0, 2147483647.0));
}

}  // namespace fuzz
