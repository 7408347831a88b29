// SPDX-License-Identifier: Apache-2.0
// The seeds' patrol: idleness that fades under the vehicle, and the steepest way down.
#include <algorithm>
#include <cmath>
#include <optional>

#include "patrol_plan.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

/// Beyond as many footprints nothing fades: 1 - k is below 5e-6 there.
constexpr double kFadingReach = 3.5;

/// ΔT of every cell; kept with the instant up to which it is counted, since far from the vehicle it
/// only grows.
class FadingField {
 public:
  FadingField(const PatrolField& field, const PatrolSight& sight)
      : field_(field),
        sight_(sight),
        idleness_(field.cells.size(), 0),
        counted_(field.cells.size(), 0) {}

  double idleness(std::uint32_t cell) const { return idleness_[cell] + now_ - counted_[cell]; }

  /// `dt` seconds have gone by and the vehicle is over `at`.
  void advance(double dt, const Vector2& at) {
    sight_.for_each_near(
        at, at, kFadingReach * sight_.footprint(), [&](std::size_t index, double, double) {
          const std::uint32_t cell = field_.slot[index];
          if (cell == PatrolField::kNone || !sight_.is_unhidden(at, index)) return;
          const double distance = (sight_.grid().centre(index) - at).norm();
          idleness_[cell] = updated_idleness(idleness(cell), dt, distance, sight_.footprint());
          counted_[cell] = now_ + dt;
        });
    now_ += dt;
  }

 private:
  const PatrolField& field_;
  const PatrolSight& sight_;
  std::vector<double> idleness_, counted_;
  double now_ = 0;
};

/// The open cell next to `at` (a cell of the grid) where the potential falls most per metre.
class Descent {
 public:
  Descent(const PatrolField& field, const PatrolSpace& space, const PatrolSight& sight,
          const GradientRule& rule)
      : field_(field), space_(space), grid_(sight.grid()), rule_(rule) {}

  std::optional<std::size_t> next(std::size_t at, const FadingField& idleness) const {
    const Vector2 here = grid_.centre(at);
    std::optional<std::size_t> best;
    double steepest = 0;
    for (const int up : {-1, 0, 1})
      for (const int right : {-1, 0, 1}) {
        const auto to = grid_.at(here + grid_.cell * Vector2(right, up));
        if (!to || *to == at || !field_.open[*to] || !space_.is_open(here, grid_.centre(*to)))
          continue;
        const double fall = (potential_of(at, idleness) - potential_of(*to, idleness)) /
                            (grid_.centre(*to) - here).norm();
        if (best && fall <= steepest) continue;
        steepest = fall;
        best = to;
      }
    return best;
  }

 private:
  double potential_of(std::size_t index, const FadingField& idleness) const {
    const std::uint32_t cell = field_.slot[index];
    if (cell == PatrolField::kNone) return 1;
    return potential(field_.risk[cell], idleness.idleness(cell), rule_.time_scale);
  }

  const PatrolField& field_;
  const PatrolSpace& space_;
  const world::Grid& grid_;
  const GradientRule& rule_;
};

std::optional<std::size_t> nearest_open(const PatrolField& field, const PatrolSpace& space,
                                        const world::Grid& grid, const Vector2& start) {
  std::optional<std::size_t> best;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (!field.open[cell] || field.slot[cell] == PatrolField::kNone) continue;
    if (best && (grid.centre(cell) - start).norm() >= (grid.centre(*best) - start).norm()) continue;
    if (space.is_clear(start, grid.centre(cell))) best = cell;
  }
  return best;
}

}  // namespace

PlanePatrol fly_gradient(const PatrolField& field, const PatrolSpace& space,
                         const PatrolSight& sight, const PatrolTask& task, const GradientRule& rule,
                         Countdown& countdown) {
  const world::Grid& grid = sight.grid();
  PlanePatrol patrol;
  patrol.way = {task.start};
  FadingField idleness(field, sight);
  const Descent descent(field, space, sight, rule);
  auto to = nearest_open(field, space, grid, task.start);
  for (double now = 0; to && now < task.duration;) {
    if (!countdown.step()) {
      patrol.complete = false;
      return patrol;
    }
    const Vector2 at = grid.centre(*to);
    const double dt = (at - patrol.way.back()).norm() / task.speed;
    idleness.advance(dt, at);
    patrol.way.push_back(at);
    now += dt;
    to = descent.next(*to, idleness);
  }
  return patrol;
}

std::vector<double> fading_idleness(const PatrolField& field, const PatrolSight& sight,
                                    const std::vector<Vector2>& way, double speed) {
  FadingField idleness(field, sight);
  const double pace = std::max(sight.grid().cell, sight.footprint() / 2);
  double since = 0;  // flown since the last update [m]
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = (way[i] - way[i - 1]).norm();
    double along = pace - since;
    for (; along <= length; along += pace)
      idleness.advance(pace / speed, way[i - 1] + along / length * (way[i] - way[i - 1]));
    since = length - (along - pace);
  }
  if (!way.empty()) idleness.advance(since / speed, way.back());
  std::vector<double> at_end(field.cells.size());
  for (std::uint32_t i = 0; i < at_end.size(); ++i) at_end[i] = idleness.idleness(i);
  return at_end;
}

}  // namespace skein::refiners
