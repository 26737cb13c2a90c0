// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// One call of each kernel that prepares images and points, in nanoseconds a result: 24 rows of 640 pixels, as many
// sampled points, or 960 planes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "dot/kernel/dispatch.hpp"

namespace {

using dot::KernelVariant;
using dot::kernel::Kernels;

constexpr int kWidth = 640, kRows = 24, kPixels = kWidth * kRows, kPlanes = 960;

/// Rows of grey values and of depth of a wall with steps, twice as wide and high as the results, for those that halve.
struct Images {
  static constexpr int kStride = 2 * kWidth;
  std::vector<std::uint8_t> grey = std::vector<std::uint8_t>(4 * kPixels), out = grey;
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(4 * kPixels, 255);
  std::vector<std::uint16_t> words = std::vector<std::uint16_t>(4 * kPixels);
  std::vector<float> metres = std::vector<float>(4 * kPixels), inverse = metres, result = metres, slope = metres;
  std::vector<float> u = std::vector<float>(kPixels), v = u, gu = u, gv = u;
  std::vector<dot::kernel::PlaneSeed> seeds;
  std::vector<dot::kernel::Plane> planes = std::vector<dot::kernel::Plane>(kPlanes);
  std::vector<int> keys = std::vector<int>(kWidth);
  std::vector<short> edges_x = std::vector<short>(kPixels), edges_y = edges_x, edges_length = edges_x;
  std::vector<unsigned short> part = std::vector<unsigned short>(kWidth), all = part;

  Images() {
    std::minstd_rand bits(3);
    for (int i = 0; i < 4 * kPixels; ++i) {
      const int x = i % kStride, y = i / kStride;
      const auto at = static_cast<std::size_t>(i);
      grey[at] = static_cast<std::uint8_t>(120 + 60 * std::sin(0.1 * x + 0.2 * y) + static_cast<int>(bits() % 8));
      metres[at] = bits() % 10 ? static_cast<float>(3 + 0.002 * x + (x / 200 % 2)) : 0;
      words[at] = static_cast<std::uint16_t>(256 * metres[at]);
      inverse[at] = metres[at] > 0 ? 1 / metres[at] : 0;
      slope[at] = 0.001f;
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = static_cast<float>(bits() % (kWidth * 16)) / 16, v[i] = static_cast<float>(bits() % (kRows * 16)) / 16;
    }
    for (int i = 0; i < kPlanes; ++i) {
      const int x = 20 + i % (kWidth - 40), y = 8 + i / (kWidth - 40) * 4;
      seeds.push_back({x, y, inverse[static_cast<std::size_t>(y * kStride + x)], 0.02f});
    }
  }
  const std::uint8_t* row(int y) const { return grey.data() + y * kStride; }
  dot::kernel::ThreeRows rows(int y) const { return {row(y) + 1, row(y + 1) + 1, row(y + 2) + 1}; }
};

/// Calls one kernel, for all rows.
using Call = void (*)(const Kernels& k, Images& in);

struct Bench {
  const char* name;
  int results;
  Call call;
};

template <typename Row>
void each_row(Row&& row) {
  for (int y = 0; y < kRows; ++y) row(y, static_cast<std::size_t>(y) * kWidth);
}

constexpr dot::kernel::DepthUnits in_words{256, 0.1f * 256, 80 * 256}, in_metres{1, 0.1f, 80};

constexpr Bench benches[] = {
    {"sample", kPixels,
     [](const Kernels& k, Images& in) {
       k.sample({in.grey.data(), kWidth, kRows, Images::kStride}, 1, in.u.data(), in.v.data(), kPixels,
                {in.result.data(), in.gu.data(), in.gv.data()});
     }},
    {"fit_planes", kPlanes,
     [](const Kernels& k, Images& in) {
       k.fit_planes({in.inverse.data(), kWidth, kRows, 4 * Images::kStride}, {5, 1, 9}, in.seeds.data(), kPlanes,
                    in.planes.data());
     }},
    {"strongest_gradients", kPixels,
     [](const Kernels& k, Images& in) {
       k.strongest_gradients({in.row(1) + 1, Images::kStride, in.mask.data(), Images::kStride, in.inverse.data(),
                              4 * Images::kStride, kWidth, kRows},
                             400, in.keys.data());
     }},
    {"invert_words", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int, std::size_t at) { k.invert_words(&in.words[at], kWidth, in_words, &in.result[at]); });
     }},
    {"invert_floats", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int, std::size_t at) { k.invert_floats(&in.metres[at], kWidth, in_metres, &in.result[at]); });
     }},
    {"take_bias", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int, std::size_t at) {
         k.take_bias(&in.inverse[at], kWidth, {in.slope.data(), in.slope.data(), 0.5f, 0.01f}, &in.result[at]);
       });
     }},
    {"halve_depth", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int y, std::size_t at) {
         const float* upper = in.inverse.data() + 2 * y * Images::kStride;
         k.halve_depth(upper, upper + Images::kStride, kWidth, &in.result[at]);
       });
     }},
    {"blur", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int y, std::size_t at) {
         const std::uint8_t* const rows[] = {in.row(y), in.row(y + 1), in.row(y + 2), in.row(y + 3), in.row(y + 4)};
         k.blur(rows, kWidth, {128, 58, 6}, &in.out[at]);
       });
     }},
    {"halve", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int y, std::size_t at) { k.halve(in.row(2 * y), in.row(2 * y + 1), kWidth, &in.out[at]); });
     }},
    {"compare_edges", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int y, std::size_t) {
         k.compare_edges(in.rows(y), in.rows(y + kRows), kWidth, {in.part.data(), in.all.data()});
       });
     }},
    {"sum_edges", kPixels,
     [](const Kernels& k, Images& in) {
       each_row([&](int y, std::size_t at) {
         k.sum_edges(in.rows(y), kWidth, {&in.edges_x[at], &in.edges_y[at], &in.edges_length[at], 10100, 60},
                     {in.part.data(), in.all.data()}, &in.out[at]);
       });
     }},
};

void run(benchmark::State& state, const Kernels& k, const Bench& bench) {
  Images in;
  for (auto _ : state) {
    bench.call(k, in);
    benchmark::ClobberMemory();
  }
  using benchmark::Counter;
  state.counters["ns_per_result"] =
      Counter(1e-9 * bench.results, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

const bool registered = [] {
  for (const KernelVariant variant :
       {KernelVariant::Portable, KernelVariant::Avx2, KernelVariant::Avx512, KernelVariant::Neon})
    if (const Kernels* k = dot::find_kernels(variant))
      for (const Bench& bench : benches)
        benchmark::RegisterBenchmark((std::string("BM_Kernel/") + k->name + "/" + bench.name).c_str(),
                                     [k, &bench](benchmark::State& s) { run(s, *k, bench); })
            ->Unit(benchmark::kMicrosecond);
  return true;
}();

}  // namespace
