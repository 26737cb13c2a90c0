// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <cstdio>

namespace slam {

namespace {

constexpr PerMasks<const char*> names = {"no masks", "DOT masks", "all masks"};
constexpr auto dot_masks = static_cast<std::size_t>(Masks::Dot);

template <typename T>
double median(const std::vector<T>& ascending) {
  return 0.5 * (ascending[(ascending.size() - 1) / 2] + ascending[ascending.size() / 2]);
}

double ratio(double value, double reference) { return value == reference ? 1 : value / reference; }

}  // namespace

Table::Table(int seeds) {
  std::printf("%-16s %6s %7s | ATE in metres: median of %d, least to greatest%*s | %-17s | excluded %%\n", "", "", "",
              seeds, seeds < 10 ? 21 : 20, "", "ATE / best");
  std::printf("%-16s %6s %7s |", "sequence", "frames", "path m");
  for (const char* name : names) std::printf("   %-20s", name);
  std::printf("| %5s %5s %5s | %5s %4s\n", "no", "DOT", "all", "DOT", "all");
  std::fflush(stdout);
}

void Table::add(const Experiment& e) {
  PerMasks<double> ate{};
  for (std::size_t m = 0; m < ate.size(); ++m) ate[m] = median(e.ate[m]);
  const double best = *std::min_element(ate.begin(), ate.end());

  std::printf("%-16s %6d %7.1f |", e.name.c_str(), e.frames, e.path);
  for (std::size_t m = 0; m < ate.size(); ++m)
    std::printf(" %7.3f %6.3f-%-7.3f", ate[m], e.ate[m].front(), e.ate[m].back());
  std::printf("|");
  for (std::size_t m = 0; m < ate.size(); ++m) {
    std::printf(" %5.2f", ratio(ate[m], best));
    over_best_[m] += ratio(ate[m], best);
    over_dot_[m] += ratio(ate[m], ate[dot_masks]);
  }
  std::printf(" | %5.1f %4.1f\n", 100 * e.excluded[dot_masks], 100 * e.excluded.back());
  for (std::size_t m = 0; m < ate.size(); ++m) {
    if (const double lost = median(e.lost[m]); lost > 0)
      std::printf("%-16s %s: no pose in %g of %d frames\n", "", names[m], lost, e.frames);
  }
  std::fflush(stdout);
  ++rows_;
}

void Table::finish() const {
  std::printf("%-102s|", "mean of ATE / best");
  for (const double sum : over_best_) std::printf(" %5.2f", sum / rows_);
  std::printf(" |\n%-102s|", "mean of ATE / ATE with DOT masks");
  for (const double sum : over_dot_) std::printf(" %5.2f", sum / rows_);
  std::printf(" |\n");
}

}  // namespace slam
