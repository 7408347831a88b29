// SPDX-License-Identifier: Apache-2.0
#include "skein/world/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::world {
namespace {

/// Grazing within a nanometre is no hit: what stands on the ground sees along level ground.
constexpr double kGrazing = 1e-9;
/// No ground is farther from the origin's level [m].
constexpr double kHighest = 1e5;

double hill_height(const HillSpec& hill, const Vector2& at) {
  const double distance = (at - hill.at).norm();
  if (distance >= hill.radius) return 0;
  return hill.height * (1 + std::cos(std::numbers::pi * distance / hill.radius)) / 2;
}

std::size_t cells_over(double extent, double cell) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(extent / cell - 1e-9)));
}

/// The first t in [from, until] with a t² + b t + c < 0.
std::optional<double> first_negative(double a, double b, double c, double from, double until) {
  const auto value = [&](double t) { return (a * t + b) * t + c; };
  if (value(from) < 0) return from;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  std::array<double, 2> roots = {a != 0 ? q / a : std::numeric_limits<double>::infinity(),
                                 q != 0 ? c / q : std::numeric_limits<double>::infinity()};
  std::sort(roots.begin(), roots.end());
  for (const double root : roots) {
    const bool falling = 2 * a * root + b < 0;
    if (root >= from && root < until && falling) return root;
  }
  return value(until) < 0 ? std::optional(until) : std::nullopt;
}

/// The part of [0, 1] where `from` + t `step` lies in [low, high].
std::pair<double, double> clipped(double from, double step, double low, double high,
                                  std::pair<double, double> span) {
  if (step == 0) return from >= low && from <= high ? span : std::pair{1.0, 0.0};
  const double a = (low - from) / step, b = (high - from) / step;
  return {std::max(span.first, std::min(a, b)), std::min(span.second, std::max(a, b))};
}

/// Walks one axis of the grid: at which t the next line is crossed.
class AxisWalk {
 public:
  /// Position along the axis is `from` + t `step`, in cells.
  AxisWalk(double from, double step, std::size_t index) : from_(from), step_(step) {
    line_ = static_cast<double>(index) + (step > 0 ? 1 : 0);
  }
  double next() const {
    return step_ == 0 ? std::numeric_limits<double>::infinity() : (line_ - from_) / step_;
  }
  void advance() { line_ += step_ > 0 ? 1 : -1; }

 private:
  double from_, step_, line_;
};

void check_extent(const TerrainSpec& spec, std::vector<std::string>& problems) {
  const double width = spec.east - spec.west, depth = spec.north - spec.south;
  if (!(width > 0)) problems.emplace_back("terrain: east must be greater than west");
  if (!(depth > 0)) problems.emplace_back("terrain: north must be greater than south");
  if (!(spec.cell > 0)) problems.emplace_back("terrain: the cell must be greater than 0");
  if (problems.empty() && !((width / spec.cell + 2) * (depth / spec.cell + 2) <= kMaxTerrainCells))
    problems.emplace_back("terrain: more than 4 million cells; use a larger cell");
}

void check_hills(const TerrainSpec& spec, std::vector<std::string>& problems) {
  if (spec.hills.size() > kMostHills) problems.emplace_back("terrain: more than 1000 hills");
  for (std::size_t i = 0; i < spec.hills.size(); ++i) {
    const HillSpec& hill = spec.hills[i];
    const std::string which = "terrain: hill " + std::to_string(i + 1);
    if (!(hill.radius > 0)) problems.push_back(which + ": the radius must be greater than 0");
    if (!hill.at.allFinite() || !std::isfinite(hill.height) || !std::isfinite(hill.radius))
      problems.push_back(which + ": every figure must be finite");
  }
}

/// The shape is right already.
void check_elevations(const TerrainSpec& spec, std::vector<std::string>& problems) {
  if (spec.elevations.empty()) return;
  const TerrainCorners corners = corners_of(spec);
  if (spec.elevations.size() != corners.count())
    problems.push_back("terrain: " + std::to_string(spec.elevations.size()) + " elevations for " +
                       std::to_string(corners.columns) + " × " + std::to_string(corners.rows) +
                       " corners");
  const auto wrong = std::find_if_not(spec.elevations.begin(), spec.elevations.end(),
                                      [](double z) { return std::abs(z) <= kHighest; });
  if (wrong != spec.elevations.end())
    problems.push_back("terrain: elevation " + std::to_string(wrong - spec.elevations.begin() + 1) +
                       " is not between -100 km and 100 km");
}

}  // namespace

std::vector<std::string> problems_of(const TerrainSpec& spec) {
  std::vector<std::string> problems;
  check_extent(spec, problems);
  const std::array<double, 6> figures = {spec.west,  spec.south, spec.east,
                                         spec.north, spec.cell,  spec.base};
  if (!std::all_of(figures.begin(), figures.end(), [](double x) { return std::isfinite(x); }))
    problems.emplace_back("terrain: every figure must be finite");
  const bool has_shape = problems.empty();
  check_hills(spec, problems);
  if (has_shape) check_elevations(spec, problems);
  return problems;
}

TerrainCorners corners_of(const TerrainSpec& spec) {
  return {cells_over(spec.east - spec.west, spec.cell) + 1,
          cells_over(spec.north - spec.south, spec.cell) + 1};
}

Terrain::Terrain(TerrainSpec spec) : spec_(std::move(spec)) {
  SKEIN_EXPECTS(problems_of(spec_).empty());
  const TerrainCorners corners = corners_of(spec_);
  columns_ = corners.columns;
  rows_ = corners.rows;
  nodes_ = std::exchange(spec_.elevations, {});
  if (nodes_.empty()) nodes_.assign(corners.count(), spec_.base);
  for (const HillSpec& hill : spec_.hills) add(hill);
  const auto [lowest, highest] = std::minmax_element(nodes_.begin(), nodes_.end());
  lowest_ = *lowest;
  highest_ = *highest;
}

void Terrain::add(const HillSpec& hill) {
  const auto first = [&](double from, double origin, std::size_t count) {
    const double along = std::floor((from - origin) / spec_.cell);
    return static_cast<std::size_t>(std::clamp(along, 0.0, static_cast<double>(count)));
  };
  const std::size_t west = first(hill.at.x() - hill.radius, spec_.west, columns_);
  const std::size_t east = first(hill.at.x() + hill.radius + 2 * spec_.cell, spec_.west, columns_);
  const std::size_t south = first(hill.at.y() - hill.radius, spec_.south, rows_);
  const std::size_t north = first(hill.at.y() + hill.radius + 2 * spec_.cell, spec_.south, rows_);
  for (std::size_t row = south; row < north; ++row)
    for (std::size_t column = west; column < east; ++column) {
      const Vector2 at(spec_.west + static_cast<double>(column) * spec_.cell,
                       spec_.south + static_cast<double>(row) * spec_.cell);
      nodes_[row * columns_ + column] += hill_height(hill, at);
    }
}

bool Terrain::contains(double x, double y) const {
  return x >= spec_.west && x <= spec_.east && y >= spec_.south && y <= spec_.north;
}

Terrain::Cell Terrain::cell_at(double u, double v) const {
  const auto index = [](double along, std::size_t count) {
    // In this order, NaN gives the first cell: what is read there is then NaN too.
    return static_cast<std::size_t>(std::min(std::max(0.0, along), static_cast<double>(count - 2)));
  };
  return {index(u, columns_), index(v, rows_)};
}

double Terrain::elevation(double x, double y) const {
  const double u = (std::clamp(x, spec_.west, spec_.east) - spec_.west) / spec_.cell;
  const double v = (std::clamp(y, spec_.south, spec_.north) - spec_.south) / spec_.cell;
  const auto [column, row] = cell_at(u, v);
  const double fu = u - static_cast<double>(column), fv = v - static_cast<double>(row);
  const double south = node(column, row) * (1 - fu) + node(column + 1, row) * fu;
  const double north = node(column, row + 1) * (1 - fu) + node(column + 1, row + 1) * fu;
  return south * (1 - fv) + north * fv;
}

double Terrain::slope(double x, double y) const {
  if (!contains(x, y)) return 0;
  const double u = (x - spec_.west) / spec_.cell, v = (y - spec_.south) / spec_.cell;
  const auto [column, row] = cell_at(u, v);
  const double fu = u - static_cast<double>(column), fv = v - static_cast<double>(row);
  const double sw = node(column, row), se = node(column + 1, row);
  const double nw = node(column, row + 1), ne = node(column + 1, row + 1);
  const double along_x = ((se - sw) * (1 - fv) + (ne - nw) * fv) / spec_.cell;
  const double along_y = ((nw - sw) * (1 - fu) + (ne - se) * fu) / spec_.cell;
  return std::atan(std::hypot(along_x, along_y));
}

bool Terrain::line_of_sight(const Vector3& a, const Vector3& b, double clearance) const {
  // One order of the ends, so that rounding cannot make the answer depend on who asks.
  const bool swap = std::lexicographical_compare(b.data(), b.data() + 3, a.data(), a.data() + 3);
  return !first_hit(swap ? b : a, swap ? a : b, clearance);
}

std::optional<double> Terrain::first_hit(const Vector3& a, const Vector3& b,
                                         double clearance) const {
  const Vector3 step = b - a;
  if (!step.allFinite()) return 0.0;
  if (std::min(a.z(), b.z()) - clearance >= highest_) return std::nullopt;
  std::pair<double, double> span = {0.0, 1.0};
  span = clipped(a.x(), step.x(), spec_.west, spec_.east, span);
  span = clipped(a.y(), step.y(), spec_.south, spec_.north, span);
  if (span.first > span.second) return std::nullopt;

  const double u = (a.x() - spec_.west) / spec_.cell, du = step.x() / spec_.cell;
  const double v = (a.y() - spec_.south) / spec_.cell, dv = step.y() / spec_.cell;
  const Cell first = cell_at(u + span.first * du, v + span.first * dv);
  AxisWalk columns(u, du, first.column), rows(v, dv, first.row);
  double from = span.first;
  while (true) {
    const double until = std::min({columns.next(), rows.next(), span.second});
    if (until >= from)
      if (const auto hit = hit_in_cell(a, step, from, until, clearance)) return hit;
    if (until >= span.second) return std::nullopt;
    (columns.next() <= rows.next() ? columns : rows).advance();
    from = std::max(from, until);
  }
}

/// Along a straight line the bilinear surface of one cell is a quadratic in t, so the height above
/// it is one too, and its first zero is known exactly.
std::optional<double> Terrain::hit_in_cell(const Vector3& a, const Vector3& step, double from,
                                           double until, double clearance) const {
  const double middle = (from + until) / 2;
  const double u = (a.x() - spec_.west) / spec_.cell, du = step.x() / spec_.cell;
  const double v = (a.y() - spec_.south) / spec_.cell, dv = step.y() / spec_.cell;
  const auto [column, row] = cell_at(u + middle * du, v + middle * dv);
  const double u0 = u - static_cast<double>(column), v0 = v - static_cast<double>(row);
  const double sw = node(column, row);
  const double eu = node(column + 1, row) - sw, ev = node(column, row + 1) - sw;
  const double euv = node(column + 1, row + 1) - node(column, row + 1) - eu;
  const double c = a.z() - clearance + kGrazing - (sw + eu * u0 + ev * v0 + euv * u0 * v0);
  const double b = step.z() - (eu * du + ev * dv + euv * (u0 * dv + v0 * du));
  return first_negative(-euv * du * dv, b, c, from, until);
}

}  // namespace skein::world
