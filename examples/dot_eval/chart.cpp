// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "page/escape.hpp"
#include "text_table.hpp"

namespace eval {
using page::escaped;

namespace {

std::string coordinate(double value) { return number("%.1f", value); }

std::string tick_text(double value) {
  return std::abs(value) < 10000 ? number("%.4g", value) : number("%.4gk", value / 1000);
}

std::string open_svg(const ChartSize& size) {
  return "<svg viewBox=\"0 0 " + std::to_string(size.width) + ' ' + std::to_string(size.height) + "\" role=\"img\">\n";
}

std::string text(double x, double y, const char* anchor, const std::string& words, const char* style = "tick") {
  return std::string("<text class=\"") + style + "\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) +
         "\" text-anchor=\"" + anchor + "\">" + escaped(words) + "</text>\n";
}

std::string segment(double x1, double y1, double x2, double y2, const char* style) {
  return std::string("<line class=\"") + style + "\" x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) +
         "\" x2=\"" + coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\"/>\n";
}

std::string box(double x, double y, double width, double height, const std::string& colour, const std::string& tip) {
  return "<rect class=\"" + colour + "\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" width=\"" +
         coordinate(width) + "\" height=\"" + coordinate(height) + "\"><title>" + escaped(tip) + "</title></rect>\n";
}

constexpr int ticks = 5;

/// Distance of about `count` ticks up to `top`: 1, 2 or 5 times a power of ten.
double tick_step(double top, int count) {
  const double rough = top / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough * 0.999) return factor * power;
  return 10 * power;
}

double largest(const std::vector<Series>& series) {
  double top = 0;
  for (const Series& s : series)
    for (const double value : s.values)
      if (std::isfinite(value)) top = std::max(top, value);
  return top;
}

/// The part of a plot that the data fills, and the y axis on its left.
struct Area {
  double left, right, top, bottom;  // user units
  double low, high;                 // values

  double y(double value) const { return bottom - (value - low) / (high - low) * (bottom - top); }

  std::string axis() const {
    const double step = tick_step(high - low, ticks);
    std::string svg;
    const int first = static_cast<int>(std::ceil(low / step - 1e-9));
    const int last = static_cast<int>(std::floor(high / step + 1e-9));
    for (int i = first; i <= last; ++i) {
      svg += segment(left, y(i * step), right, y(i * step), i == 0 ? "axis" : "tick");
      svg += text(left - 6, y(i * step) + 4, "end", tick_text(i * step));
    }
    return svg;
  }
};

double round_up(double value) {
  if (!(value > 0)) return 1;
  const double step = tick_step(value, ticks);
  return std::ceil(value / step - 1e-9) * step;
}

}  // namespace

std::string grouped_bars(const ChartSize& size, const std::vector<std::string>& categories,
                         const std::vector<Series>& series, double top, std::optional<double> reference) {
  const double high = top > 0 ? top : round_up(std::max(largest(series), reference.value_or(0)));
  const Area area{44, size.width - 8.0, 12, size.height - 26.0, 0, high};
  const double slot = (area.right - area.left) / static_cast<double>(categories.size());
  const double bar = std::min(34.0, 0.76 * slot / static_cast<double>(series.size()));
  std::string svg = open_svg(size) + area.axis();
  std::string values;  // on top of everything
  for (std::size_t i = 0; i < categories.size(); ++i) {
    const double centre = area.left + (static_cast<double>(i) + 0.5) * slot;
    const double first = centre - 0.5 * bar * static_cast<double>(series.size());
    for (std::size_t k = 0; k < series.size(); ++k) {
      const double value = series[k].values[i];
      const double x = first + bar * static_cast<double>(k);
      if (!std::isfinite(value)) {
        svg += text(x + bar / 2, area.bottom - 4, "middle", "-");
        continue;
      }
      const double y = area.y(std::min(value, high));
      svg += box(x + 0.06 * bar, y, 0.88 * bar, area.bottom - y, series[k].colour,
                 categories[i] + ", " + series[k].name + ": " + tick_text(value));
      if (bar >= 26) values += text(x + bar / 2, y - 3, "middle", number("%.2f", value), "value");
    }
    svg += text(centre, area.bottom + 17, "middle", categories[i]);
  }
  if (reference) svg += segment(area.left, area.y(*reference), area.right, area.y(*reference), "reference");
  return svg + values + "</svg>\n";
}

std::string stacked_rows(const ChartSize& size, const std::vector<std::string>& categories,
                         const std::vector<Series>& parts, const char* pattern) {
  std::vector<double> totals(categories.size());
  for (const Series& part : parts)
    for (std::size_t i = 0; i < totals.size(); ++i)
      if (std::isfinite(part.values[i])) totals[i] += part.values[i];
  const double longest = std::max(1e-9, totals.empty() ? 0 : *std::max_element(totals.begin(), totals.end()));
  const double left = 118;
  const double right = size.width - 62.0;
  const double slot = size.height / static_cast<double>(std::max<std::size_t>(1, categories.size()));
  std::string svg = open_svg(size);
  for (std::size_t i = 0; i < categories.size(); ++i) {
    const double y = static_cast<double>(i) * slot;
    double x = left;
    for (const Series& part : parts) {
      const double value = part.values[i];
      if (!std::isfinite(value) || value <= 0) continue;
      const double width = value / longest * (right - left);
      svg += box(x, y + 0.14 * slot, width, 0.72 * slot, part.colour,
                 categories[i] + ", " + part.name + ": " + number(pattern, value));
      x += width;
    }
    svg += text(left - 8, y + slot / 2 + 4, "end", categories[i]);
    svg += text(x + 6, y + slot / 2 + 4, "start", number(pattern, totals[i]), "value");
  }
  return svg + "</svg>\n";
}

std::string stacked_shares(const ChartSize& size, const std::vector<std::string>& categories,
                           const std::vector<Series>& parts) {
  const Area area{44, size.width - 8.0, 12, size.height - 40.0, 0, 1};
  const double slot = (area.right - area.left) / static_cast<double>(categories.size());
  std::string svg = open_svg(size) + area.axis();
  for (std::size_t i = 0; i < categories.size(); ++i) {
    double total = 0;
    for (const Series& part : parts) total += part.values[i];
    const double left = area.left + (static_cast<double>(i) + 0.14) * slot;
    double below = 0;
    for (const Series& part : parts) {
      if (!(part.values[i] > 0)) continue;
      const double share = part.values[i] / total;
      svg += box(left, area.y(below + share), 0.72 * slot, area.y(below) - area.y(below + share), part.colour,
                 categories[i] + " m/s, " + part.name + ": " + number("%.0f", part.values[i]) + " of " +
                     number("%.0f", total));
      below += share;
    }
    const double centre = left + 0.36 * slot;
    svg += text(centre, area.bottom + 16, "middle", categories[i]);
    svg += text(centre, area.bottom + 31, "middle", total > 0 ? number("%.0f", total) : "none", "count");
  }
  return svg + "</svg>\n";
}

std::string lines(const ChartSize& size, const std::vector<double>& x, const std::vector<Series>& series) {
  double low = 0;
  for (const Series& s : series)
    for (const double value : s.values)
      if (std::isfinite(value)) low = std::min(low, value);
  const Area area{
      54, size.width - 10.0, 10, size.height - 24.0, low < 0 ? -round_up(-low) : 0, round_up(largest(series))};
  std::string svg = open_svg(size) + area.axis();
  if (x.empty()) return svg + "</svg>\n";
  const double span = std::max(1.0, x.back() - x.front());
  const auto x_of = [&](double value) { return area.left + (value - x.front()) / span * (area.right - area.left); };
  const double step = std::max(1.0, tick_step(span, 5));
  const int last = static_cast<int>(x.back() / step);
  for (int i = static_cast<int>(std::ceil(x.front() / step)); i <= last; ++i)
    svg += text(x_of(i * step), area.bottom + 16, "middle", tick_text(i * step));

  for (auto s = series.rbegin(); s != series.rend(); ++s) {
    std::string points;
    const auto flush = [&] {
      if (!points.empty()) svg += "<polyline class=\"" + s->colour + "\" points=\"" + points + "\"/>\n";
      points.clear();
    };
    for (std::size_t i = 0; i < x.size() && i < s->values.size(); ++i) {
      if (std::isfinite(s->values[i]))
        points += (points.empty() ? "" : " ") + coordinate(x_of(x[i])) + ',' + coordinate(area.y(s->values[i]));
      else
        flush();
    }
    flush();
  }
  return svg + "</svg>\n";
}

}  // namespace eval
