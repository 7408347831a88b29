// SPDX-License-Identifier: Apache-2.0
#include "skein/report/distributions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "markup.hpp"
#include "plot.hpp"

namespace skein::report {

namespace {

constexpr double kWidth = 960, kLeft = 250, kRight = 60;
constexpr double kTop = 48, kHead = 26, kRow = 30, kFoot = 38;
constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                              "#56b4e9", "#e69f00", "#6b6b6b"};

/// Between the two nearest of the series.
double interpolated_quantile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// A little more than all figures of a panel, never of no length.
Axis axis_of(const DistributionPanel& panel) {
  double low = INFINITY, high = -INFINITY;
  for (const DistributionRow& row : panel.rows) {
    for (const double value : row.values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) low = 0, high = 1;
  const double margin = high > low ? (high - low) * 0.04 : std::max(std::abs(low) * 0.05, 0.5);
  return {low - margin, high + margin, kLeft, kWidth - kRight};
}

int decimals_for(double step) {
  return step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
}

void draw_axis(Markup& svg, const Axis& axis, double top, double bottom, const std::string& unit) {
  const double step = round_step((axis.to - axis.from) / 8);
  for (const double at : ticks(axis.from, axis.to, step)) {
    const double x = axis(at);
    svg.leaf("line", {{"class", "grid"}, {"x1", x}, {"x2", x}, {"y1", top}, {"y2", bottom}});
    svg.element("text", {{"class", "tick"}, {"x", x}, {"y", bottom + 14}},
                short_number(at, decimals_for(step)));
  }
  svg.element("text", {{"class", "unit"}, {"x", kWidth - kRight + 10}, {"y", bottom + 14}}, unit);
}

/// Every figure where it is, side by side by a sequence that never clusters (the golden section).
void draw_dots(Markup& svg, const Axis& axis, const std::vector<double>& values, double middle,
               const char* colour) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double aside = std::fmod(static_cast<double>(i + 1) * 0.6180339887, 1.0) - 0.5;
    svg.leaf("circle", {{"cx", axis(values[i])},
                        {"cy", middle + aside * 0.62 * kRow},
                        {"r", 2.2},
                        {"fill", colour},
                        {"fill-opacity", 0.45}});
  }
}

void draw_box(Markup& svg, const Axis& axis, const Spread& spread, double middle,
              const char* colour) {
  const double half = 0.3 * kRow, left = axis(spread.lower_quartile);
  svg.leaf("rect", {{"x", left},
                    {"y", middle - half},
                    {"width", std::max(axis(spread.upper_quartile) - left, 0.5)},
                    {"height", 2 * half},
                    {"fill", "none"},
                    {"stroke", colour},
                    {"stroke-width", 1.4}});
  const double median = axis(spread.median), mean = axis(spread.mean);
  svg.leaf("line", {{"x1", median},
                    {"x2", median},
                    {"y1", middle - half},
                    {"y2", middle + half},
                    {"stroke", "#1b2430"},
                    {"stroke-width", 2}});
  const std::vector<Point> rhombus{
      {mean, middle - 5}, {mean + 5, middle}, {mean, middle + 5}, {mean - 5, middle}};
  svg.leaf("path", {{"d", path_data(rhombus) + "Z"},
                    {"fill", "#ffffff"},
                    {"stroke", "#1b2430"},
                    {"stroke-width", 1.2}});
}

void draw_row(Markup& svg, const Axis& axis, const DistributionRow& row, double middle,
              const char* colour) {
  svg.element("text", {{"class", "label"}, {"x", kLeft - 12}, {"y", middle + 4}},
              shortened(row.label, 36));
  svg.element("text", {{"class", "count"}, {"x", kWidth - kRight + 10}, {"y", middle + 4}},
              "n " + std::to_string(row.values.size()));
  if (row.values.empty()) return;
  const Spread spread = spread_of(row.values);
  svg.open("g").title(row.label + ": mean " + short_number(spread.mean, 3) + ", median " +
                      short_number(spread.median, 3) + ", 95 % below " +
                      short_number(spread.p95, 3));
  draw_dots(svg, axis, row.values, middle, colour);
  draw_box(svg, axis, spread, middle, colour);
  svg.close();
}

double height_of(const DistributionPanel& panel) {
  return kHead + kRow * static_cast<double>(panel.rows.size()) + kFoot;
}

void draw_panel(Markup& svg, const DistributionPanel& panel, double top) {
  const Axis axis = axis_of(panel);
  const double first = top + kHead;
  const double bottom = first + kRow * static_cast<double>(panel.rows.size());
  svg.element("text", {{"class", "name"}, {"x", 16}, {"y", top + 16}}, panel.name);
  draw_axis(svg, axis, first, bottom, panel.unit);
  for (std::size_t i = 0; i < panel.rows.size(); ++i) {
    draw_row(svg, axis, panel.rows[i], first + kRow * (static_cast<double>(i) + 0.5),
             kColours[i % kColours.size()]);
  }
}

constexpr const char* kStyle =
    "text{font:12px 'DejaVu "
    "Sans',Verdana,sans-serif;fill:#1b2430}.title{font-size:16px;font-weight:"
    "bold}.name{font-weight:bold}.label{text-anchor:end}.tick{text-anchor:middle;fill:#5c6675}."
    "count,"
    ".unit{fill:#5c6675}.grid{stroke:#d9dde3;stroke-width:1}";

}  // namespace

Spread spread_of(std::vector<double> values) {
  Spread spread;
  spread.count = values.size();
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0;
  spread.minimum = values.front();
  spread.lower_quartile = interpolated_quantile(values, 0.25);
  spread.median = interpolated_quantile(values, 0.5);
  spread.upper_quartile = interpolated_quantile(values, 0.75);
  spread.p95 = interpolated_quantile(values, 0.95);
  spread.maximum = values.back();
  return spread;
}

std::string distributions_svg(const std::string& title,
                              const std::vector<DistributionPanel>& panels) {
  double height = kTop;
  for (const DistributionPanel& panel : panels) height += height_of(panel);
  Markup svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + short_number(kWidth) + " " + short_number(height)},
                   {"width", kWidth},
                   {"height", height}});
  svg.element("style", {}, kStyle);
  svg.leaf("rect", {{"width", kWidth}, {"height", height}, {"fill", "#ffffff"}});
  svg.element("text", {{"class", "title"}, {"x", 16}, {"y", 28}}, title);
  double top = kTop;
  for (const DistributionPanel& panel : panels) {
    draw_panel(svg, panel, top);
    top += height_of(panel);
    svg.line_break();
  }
  return svg.close().take() + "\n";
}

}  // namespace skein::report
