// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace eval {

/// A series of a plot. Colours are names of CSS classes ("rate0", "moving", ...) that the page defines.
struct Series {
  std::string name;
  std::string colour;
  std::vector<double> values;  ///< one for each category or x; not finite: nothing there
};

/// Plots as SVG elements, of `width` x `height` user units, drawn in the page's own colours.
struct ChartSize {
  int width = 560;
  int height = 230;
};

/// Bars side by side, a group for each category; values are >= 0.
/// @param top end of the axis; 0: a round number above the largest value.
/// @param reference level to compare with, a dashed line.
std::string grouped_bars(const ChartSize& size, const std::vector<std::string>& categories,
                         const std::vector<Series>& series, double top, std::optional<double> reference = {});

/// A horizontal bar for each category, its parts one after the other; totals at the end.
/// @param pattern of the totals, for printf with a double.
std::string stacked_rows(const ChartSize& size, const std::vector<std::string>& categories,
                         const std::vector<Series>& parts, const char* pattern);

/// A vertical bar for each category, filled to the top in the shares of its parts; the sum below.
std::string stacked_shares(const ChartSize& size, const std::vector<std::string>& categories,
                           const std::vector<Series>& parts);

/// A line for each series over common x, the first one on top.
std::string lines(const ChartSize& size, const std::vector<double>& x, const std::vector<Series>& series);

}  // namespace eval
