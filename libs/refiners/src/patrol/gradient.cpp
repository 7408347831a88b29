// SPDX-License-Identifier: Apache-2.0
// The seeds' patrol: idleness that fades under the vehicle, and the steepest way down.
#include <algorithm>
#include <cmath>
#include <optional>

#include "patrol/plan.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

/// Beyond as many footprints nothing fades: 1 - k is below 5e-6 there.
constexpr double kFadingReach = 3.5;
/// About what a step takes [ns].
constexpr std::uint32_t kStep = 20'000;
/// Parts of a patrol are told after as many steps, and then after twice as many each time.
constexpr std::size_t kFirstPart = 64;
/// Looks at cells after the time is up: some 20 ms.
constexpr std::uint64_t kLookedAtLate = 500'000;

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

/// The same, reckoned from the end of a flight back: what a cell's idleness was once weighs less
/// with every later look at it.
class PastIdleness {
 public:
  PastIdleness(const PatrolField& field, const PatrolSight& sight, double end)
      : field_(field),
        sight_(sight),
        idleness_(field.cells.size(), 0),
        weight_(field.cells.size(), 1),
        until_(field.cells.size(), end),
        open_(field.cells.size()) {}

  /// At that instant the vehicle was over `at`; instants are told from the last to the first.
  void go_back_to(double instant, const Vector2& at) {
    sight_.for_each_near(at, at, kFadingReach * sight_.footprint(),
                         [&](std::size_t index, double, double) {
                           const std::uint32_t cell = field_.slot[index];
                           if (cell == PatrolField::kNone || is_settled(cell)) return;
                           ++looked_at_;
                           if (!sight_.is_unhidden(at, index)) return;
                           const double distance = (sight_.grid().centre(index) - at).norm();
                           idleness_[cell] += weight_[cell] * (until_[cell] - instant);
                           until_[cell] = instant;
                           weight_[cell] *= updated_idleness(1, 0, distance, sight_.footprint());
                           if (is_settled(cell)) --open_;
                         });
  }
  bool is_settled() const { return open_ == 0; }
  std::uint64_t looked_at() const { return looked_at_; }

  std::vector<double> idleness() const {
    std::vector<double> all = idleness_;
    for (std::size_t cell = 0; cell < all.size(); ++cell) all[cell] += weight_[cell] * until_[cell];
    return all;
  }

 private:
  /// What was before weighs less than a millisecond.
  bool is_settled(std::uint32_t cell) const { return weight_[cell] * until_[cell] < 1e-3; }

  const PatrolField& field_;
  const PatrolSight& sight_;
  std::vector<double> idleness_, weight_, until_;
  std::size_t open_;
  std::uint64_t looked_at_ = 0;
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

void fly_gradient(const GradientGround& ground, const PatrolTask& task, const GradientRule& rule,
                  Countdown& countdown, const TakePatrol& take) {
  const auto& [field, space, sight] = ground;
  const world::Grid& grid = sight.grid();
  Deadline& deadline = sight.deadline();
  PlanePatrol patrol;
  patrol.way = {task.start};
  FadingField idleness(field, sight);
  const Descent descent(field, space, sight, rule);
  auto to = nearest_open(field, space, grid, task.start);
  std::size_t next_part = kFirstPart;
  for (double now = 0; to && now < task.duration;) {
    patrol.complete = countdown.step() && !deadline.passed_after(kStep);
    if (!patrol.complete) break;
    const Vector2 at = grid.centre(*to);
    const double dt = (at - patrol.way.back()).norm() / task.speed;
    idleness.advance(dt, at);
    patrol.way.push_back(at);
    now += dt;
    to = descent.next(*to, idleness);
    if (deadline.is_set() && patrol.way.size() == next_part) {
      take({patrol.way, false});
      next_part *= 2;
    }
  }
  take(patrol);
}

std::vector<double> fading_idleness(const PatrolField& field, const PatrolSight& sight,
                                    const std::vector<Vector2>& way, double speed) {
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < way.size(); ++i)
    along.push_back(along.back() + (way[i] - way[i - 1]).norm());
  const double pace = std::max(sight.grid().cell, sight.footprint() / 2);
  PastIdleness past(field, sight, along.back() / speed);
  if (!way.empty()) past.go_back_to(along.back() / speed, way.back());
  std::size_t leg = way.size() - 1;
  for (double updates = std::floor(along.back() / pace); updates > 0; --updates) {
    const double at = updates * pace;
    while (leg > 1 && along[leg - 1] > at) --leg;
    const double part = (at - along[leg - 1]) / (along[leg] - along[leg - 1]);
    past.go_back_to(at / speed, way[leg - 1] + part * (way[leg] - way[leg - 1]));
    if (past.is_settled()) break;
    if (past.looked_at() > kLookedAtLate && sight.deadline().passed()) return {};
  }
  return past.idleness();
}

}  // namespace skein::refiners
