// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// The median of inverse depths about one distance, by sort_nth and by the standard library: range(0) values. Both sort
// a copy, whose time is counted.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "dot/statistics/nth.hpp"

namespace {

using Values = std::vector<float>;

/// So many sets of values, in turn, that the processor cannot learn their branches.
std::array<Values, 64> values_of(int count) {
  std::minstd_rand bits(5);
  std::normal_distribution<float> inverse_depth(0.2f, 0.01f);
  std::array<Values, 64> out;
  for (Values& values : out) {
    values.resize(static_cast<std::size_t>(count));
    for (float& value : values) value = inverse_depth(bits);
  }
  return out;
}

template <typename SortNth>
void find_median(benchmark::State& state, SortNth&& sort_nth) {
  const auto sets = values_of(static_cast<int>(state.range(0)));
  Values values;
  std::size_t next = 0;
  for (auto _ : state) {
    values = sets[next++ % sets.size()];
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    sort_nth(values.begin(), middle, values.end());
    benchmark::DoNotOptimize(*middle);
  }
}

void BM_MedianBySortNth(benchmark::State& state) {
  find_median(state, [](auto first, auto nth, auto last) { dot::sort_nth(first, nth, last); });
}
BENCHMARK(BM_MedianBySortNth)->Arg(200)->Arg(1000)->Arg(4000);

void BM_MedianByStandardLibrary(benchmark::State& state) {
  find_median(state, [](auto first, auto nth, auto last) { std::nth_element(first, nth, last); });
}
BENCHMARK(BM_MedianByStandardLibrary)->Arg(200)->Arg(1000)->Arg(4000);

}  // namespace
