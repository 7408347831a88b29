// SPDX-License-Identifier: Apache-2.0
#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "text.hpp"

namespace skein::report {

namespace {

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along =
      squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

std::vector<Point> simplify_once(const std::vector<Point>& line, double tolerance) {
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_segment(line[i], line[first], line[last]);
      if (d > farthest) std::tie(farthest, split) = std::pair(d, i);
    }
    if (split == first) continue;
    kept[split] = true;
    open.emplace_back(first, split);
    open.emplace_back(split, last);
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) result.push_back(line[i]);
  }
  return result;
}

}  // namespace

double round_step(double least) {
  if (!(least > 0) || !std::isfinite(least)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least) return factor * decade;
  }
  return 10.0 * decade;
}

double round_time_step(double least) {
  constexpr std::array<double, 19> kSteps{1,     2,     5,     10,    15,    30,   60,
                                          120,   300,   600,   900,   1800,  3600, 7200,
                                          10800, 21600, 43200, 86400, 172800};
  const auto it = std::find_if(kSteps.begin(), kSteps.end(), [&](double s) { return s >= least; });
  return it != kSteps.end() ? *it : round_step(least / 86400.0) * 86400.0;
}

std::vector<double> ticks(double from, double to, double step) {
  std::vector<double> values;
  if (!(step > 0) || !((to - from) / step < 1000.0)) return values;
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + step * 1e-9; k += 1.0) {
    values.push_back(k * step);
  }
  return values;
}

std::vector<Point> simplified(const std::vector<Point>& line, double tolerance, std::size_t most) {
  if (line.size() < 3) return line;
  std::vector<Point> result = simplify_once(line, tolerance);
  while (result.size() > std::max<std::size_t>(most, 2)) {
    tolerance *= 2.0;
    result = simplify_once(result, tolerance);
  }
  return result;
}

double text_width(std::string_view text, double font_size) {
  return 0.61 * font_size * static_cast<double>(character_count(text));
}

bool LabelPlacer::is_free(const Box& box) const {
  const bool inside = box.left >= area_.left && box.right <= area_.right && box.top >= area_.top &&
                      box.bottom <= area_.bottom;
  return inside && std::none_of(taken_.begin(), taken_.end(),
                                [&](const Box& other) { return other.overlaps(box); });
}

std::size_t LabelPlacer::covered(const Box& box) const {
  return static_cast<std::size_t>(
      std::count_if(avoided_.begin(), avoided_.end(), [&](const Point& p) {
        return p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
      }));
}

std::optional<LabelPlacer::Placed> LabelPlacer::place(Point at, double radius,
                                                      std::string_view text, double font_size) {
  const double width = text_width(text, font_size), height = font_size;
  struct Side {
    double dx, dy;
    const char* anchor;
  };
  const double r = radius + 3.0;
  const std::array<Side, 8> sides{{{r, 0.35 * height, "start"},
                                   {-r, 0.35 * height, "end"},
                                   {0, -r, "middle"},
                                   {0, r + 0.75 * height, "middle"},
                                   {0.7 * r, -0.7 * r, "start"},
                                   {0.7 * r, 0.7 * r + 0.75 * height, "start"},
                                   {-0.7 * r, -0.7 * r, "end"},
                                   {-0.7 * r, 0.7 * r + 0.75 * height, "end"}}};
  std::optional<Placed> best;
  Box best_box;
  std::size_t least = 0;
  for (const Side& side : sides) {
    const Placed placed{at.x + side.dx, at.y + side.dy, side.anchor};
    const double shift = std::string_view(side.anchor) == "start" ? 0.0
                         : std::string_view(side.anchor) == "end" ? width
                                                                  : width / 2.0;
    const Box box{placed.x - shift - 1, placed.y - 0.8 * height, placed.x - shift + width + 1,
                  placed.y + 0.25 * height};
    if (!is_free(box)) continue;
    const std::size_t cost = covered(box);
    if (best && cost >= least) continue;
    best = placed;
    best_box = box;
    least = cost;
  }
  if (best) block(best_box);
  return best;
}

}  // namespace skein::report
