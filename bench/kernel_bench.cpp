// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// One Gauss-Newton iteration of the photometric reduction, in nanoseconds a point: each kernel of this machine, for the
// pose alone (for each source of gradients) and with gain and offset, beside a bare loop that does no more than any
// such kernel must. 640x480, the 5 % of the pixels with the strongest gradient, full resolution.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bare_loop.hpp"
#include "dot/align/kernel_reduction.hpp"
#include "dot/kernel/dispatch.hpp"

namespace {

struct Problem {
  dot::Image<std::uint8_t> image{640, 480};
  dot::Image<float> inverse_depth{640, 480};
  dot::PointSet points;
  dot::Pinhole camera{{520, 520, 319.5, 239.5, 640, 480, 0}};
  dot::AlignState state{dot::SE3d::exp((dot::Vector6<double>() << 0.01, -0.005, 0.02, 0.004, -0.006, 0.01).finished()),
                        1.05, -3};
  dot::ResidualNoise noise{5, 0.06f, 1.345f, 4.685f};

  Problem() {
    std::minstd_rand bits(7);
    const int w = image.width(), h = image.height();
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        const double grey = 120 + 50 * std::sin(0.11 * x + 0.02 * y) * std::cos(0.13 * y) +
                            30 * std::sin(0.0007 * x * y) + static_cast<double>(bits() % 8);
        image(x, y) = static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0));
        inverse_depth(x, y) = static_cast<float>(1 / (2 + std::sin(0.01 * x)));
      }
    std::vector<std::pair<int, int>> pixels;  // strength of the gradient, index
    for (int y = 2; y < h - 2; ++y)
      for (int x = 2; x < w - 2; ++x) {
        const int gx = image(x + 1, y) - image(x - 1, y), gy = image(x, y + 1) - image(x, y - 1);
        pixels.emplace_back(-(gx * gx + gy * gy), y * w + x);
      }
    const auto kept = pixels.begin() + w * h / 20;
    std::nth_element(pixels.begin(), kept, pixels.end());
    std::sort(pixels.begin(), kept, [](const auto& a, const auto& b) { return a.second < b.second; });
    points.levels = 1;
    for (auto p = pixels.begin(); p != kept; ++p) {
      const int u = p->second % w, v = p->second / w;
      const auto ray = camera.unproject(dot::Vector2<float>(static_cast<float>(u), static_cast<float>(v)));
      points.push(static_cast<float>(u), static_cast<float>(v), ray.x(), ray.y(), inverse_depth(u, v), 0.005f);
      const dot::Sample s = dot::sample(image, static_cast<float>(u), static_cast<float>(v));
      points.intensity[0].push_back(s.value), points.gu[0].push_back(s.gx), points.gv[0].push_back(s.gy);
    }
  }
};

const Problem& problem() {
  static const Problem built;
  return built;
}

void report(benchmark::State& state, int points) {
  using benchmark::Counter;
  state.counters["ns_per_point"] = Counter(1e-9 * points, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// @param depth with the depth term.
void linearize(benchmark::State& state, const dot::kernel::Kernels* k, bool depth,
               dot::GradientSource gradient = dot::GradientSource::Image) {
  const Problem& p = problem();
  dot::DepthTerm term;
  if (depth) {
    term.inverse_depth = p.inverse_depth.view();
    term.sigma = 0.01f, term.weight = 0.3f;
  }
  dot::kernel::Depth measured;
  dot::kernel::Input in =
      dot::KernelReduction::input(p.points, 0, p.camera, p.image, p.state, p.noise, term, nullptr, measured);
  in.gradient = gradient;
  dot::kernel::Sums sums;
  for (auto _ : state) {
    k->linearize(in, sums);
    benchmark::DoNotOptimize(sums);
    benchmark::ClobberMemory();
  }
  report(state, in.points.n);
}

void residuals(benchmark::State& state, const dot::kernel::Kernels* k) {
  const Problem& p = problem();
  dot::KernelReduction reduction{k};
  dot::PointResiduals out;
  for (auto _ : state) {
    reduction.residuals(p.points, 0, p.camera, p.image, p.state, p.noise, {}, out);
    benchmark::ClobberMemory();
  }
  report(state, p.points.size());
}

/// Costs, as a search compares places. @param on_quads from quads instead of the image.
void costs(benchmark::State& state, const dot::kernel::Kernels* k, bool on_quads) {
  const Problem& p = problem();
  dot::Pyramid pyramid;
  pyramid.levels.push_back(p.image);
  dot::Quads quads;
  quads.copy_level(pyramid, 0);
  dot::KernelReduction reduction{k};
  dot::PointResiduals scratch;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        reduction.costs(p.points, 0, p.camera, p.image, on_quads ? &quads : nullptr, p.state, p.noise, {}, scratch));
  report(state, p.points.size());
}

void serial(benchmark::State& state) {
  const Problem& p = problem();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        dot::SerialReduction::linearize(p.points, 0, p.camera, p.image, p.state, p.noise, {}, nullptr));
  report(state, p.points.size());
}

void bare(benchmark::State& state, dot::bench::BareLoop loop) {
  const Problem& p = problem();
  dot::kernel::Depth none;
  const dot::kernel::Input in =
      dot::KernelReduction::input(p.points, 0, p.camera, p.image, p.state, p.noise, {}, nullptr, none);
  float sums[27];
  for (auto _ : state) {
    loop(in, sums);
    benchmark::ClobberMemory();
  }
  report(state, in.points.n);
}

void add(const std::string& name, dot::KernelVariant variant, dot::bench::BareLoop loop) {
  const dot::kernel::Kernels* k = dot::find_kernels(variant);
  if (!k) return;
  const auto one = [&](const std::string& what, auto run) {
    benchmark::RegisterBenchmark(("BM_Kernel/" + name + "/" + what).c_str(), run)->Unit(benchmark::kMicrosecond);
  };
  if (loop) one("bare_loop", [=](benchmark::State& s) { bare(s, loop); });
  one("pose_gain_offset", [=](benchmark::State& s) { linearize(s, k, false); });
  one("mean_gradient", [=](benchmark::State& s) { linearize(s, k, false, dot::GradientSource::Mean); });
  one("reference_gradient", [=](benchmark::State& s) { linearize(s, k, false, dot::GradientSource::Reference); });
  one("with_depth", [=](benchmark::State& s) { linearize(s, k, true); });
  one("residuals", [=](benchmark::State& s) { residuals(s, k); });
  one("costs", [=](benchmark::State& s) { costs(s, k, false); });
  one("costs_on_quads", [=](benchmark::State& s) { costs(s, k, true); });
}

const bool registered = [] {
  benchmark::RegisterBenchmark("BM_Kernel/serial/pose_gain_offset", serial)->Unit(benchmark::kMicrosecond);
  add("portable", dot::KernelVariant::Portable, nullptr);
  add("avx2", dot::KernelVariant::Avx2, dot::bench::bare_avx2);
  add("avx512", dot::KernelVariant::Avx512, dot::bench::bare_avx512);
  add("neon", dot::KernelVariant::Neon, nullptr);
  return true;
}();

}  // namespace
