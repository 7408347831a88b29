// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/valid_position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/foundation/random.hpp"
#include "skein/interaction/placed_constraint.hpp"
#include "skein/world/segment.hpp"

namespace skein::interaction {

namespace {

using Quantity = SpatialConstraint::Quantity;
constexpr double kNever = std::numeric_limits<double>::infinity();
/// What a place to stay at is farther from closed air than a way there has to be [m].
constexpr double kBeside = 1;

/// By how much a constraint is missed, from 0: quotients of distances, gaps of angles.
double violation(const PlacedConstraint& one, const Position& at) {
  const auto value = one.value_of(at);
  if (!value) return kNever;
  const double slack = one.slack(*value);
  if (one.holds_by(slack)) return 0;
  const double scale = one.quantity == Quantity::kDistance ? std::max(one.reference, 1.0) : 1;
  return std::max(-slack / scale, std::numeric_limits<double>::min());
}

double distance_between(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A box of positions.
struct Box {
  Position low, high;

  bool empty() const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (low[i] > high[i]) return true;
    }
    return false;
  }
  double side() const { return distance_between(low, high) / std::numbers::sqrt3; }
};

/// What the upper bounds of distances leave of the air.
Box box_of(const FreeAir& air, const std::vector<PlacedConstraint>& constraints) {
  Box box{air.low, air.high};
  for (const PlacedConstraint& one : constraints) {
    const bool above = one.relation == Relation::kGreater || one.relation == Relation::kAtLeast;
    if (one.quantity != Quantity::kDistance || above) continue;
    const double most = one.reference + one.tolerance;
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::max(box.low[i], one.origin[i] - most);
      box.high[i] = std::min(box.high[i], one.origin[i] + most);
    }
  }
  return box;
}

class Search {
 public:
  Search(const ValidPositionQuery& query, std::vector<PlacedConstraint> constraints)
      : query_(query),
        constraints_(std::move(constraints)),
        random_(query.seed),
        box_(box_of(query.air, constraints_)) {}

  std::optional<ValidPosition> run() {
    if (box_.empty()) return std::nullopt;
    std::optional<Position> found = settle(nearest_to(query_.from));
    while (!found && tried_ < query_.budget) found = settle(anywhere());
    if (!found) return std::nullopt;
    refine(*found);
    return ValidPosition{*found, margin_of(*found) >= 1, tried_};
  }

 private:
  static constexpr int kNeighbours = 12;
  static constexpr std::uint64_t kRefining = 2'000;

  Position nearest_to(Position at) const {
    for (std::size_t i = 0; i < 3; ++i) at[i] = std::clamp(at[i], box_.low[i], box_.high[i]);
    return at;
  }
  Position anywhere() {
    Position at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = random_.uniform(box_.low[i], box_.high[i]);
    return at;
  }
  Position near(const Position& at, double reach) {
    Position next = at;
    for (double& x : next) x += random_.uniform(-reach, reach);
    return nearest_to(next);
  }
  bool in_air(const Position& at) {
    ++tried_;
    return query_.air.holds(at);
  }
  bool hold_up_to(std::size_t count, const Position& at) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (!constraints_[i].holds(at)) return false;
    }
    return true;
  }

  /// From a start, one constraint after the other. The air is the first of all.
  std::optional<Position> settle(Position at) {
    if (!in_air(at)) return std::nullopt;
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      if (!satisfy(i, at)) return std::nullopt;
    }
    return at;
  }

  bool satisfy(std::size_t index, Position& at) {
    double missed = violation(constraints_[index], at);
    double reach = box_.side() / 4;
    const double least = std::max(0.05, box_.side() * 1e-4);
    while (missed > 0 && reach > least && tried_ < query_.budget) {
      Position best = at;
      for (int i = 0; i < kNeighbours; ++i) {
        const Position next = near(at, reach);
        const double its = violation(constraints_[index], next);
        if (its < missed && hold_up_to(index, next) && in_air(next)) {
          missed = its;
          best = next;
        } else {
          ++tried_;
        }
      }
      if (best == at) {
        reach /= 2;
      } else {
        at = best;
      }
    }
    return missed == 0;
  }

  /// How many margins all constraints hold by, at most one.
  double margin_of(const Position& at) const {
    double least = 1;
    for (const PlacedConstraint& one : constraints_) {
      const auto value = one.value_of(at);
      if (!value) return 0;
      const bool distance = one.quantity == Quantity::kDistance;
      double wanted = distance ? query_.limits.distance : query_.limits.angle;
      if (one.relation == Relation::kEqual) wanted = std::min(wanted, one.tolerance);
      const double slack = one.slack(*value);
      if (!one.holds_by(slack)) return 0;
      if (wanted > 0) least = std::min(least, slack / wanted);
    }
    return least;
  }

  void refine(Position& at) {
    double margin = margin_of(at), away = distance_between(at, query_.from);
    double reach = box_.side() / 8;
    const std::uint64_t end = tried_ + kRefining;
    for (int missed = 0; tried_ < end && reach > 0.1;) {
      Position next = near(at, reach);
      const double its = margin_of(next), far = distance_between(next, query_.from);
      const bool better = its > margin || (its == margin && far < away);
      if (its > 0 && better && in_air(next)) {
        at = next;
        margin = its;
        away = far;
        missed = 0;
      } else {
        ++tried_;
        if (++missed % 24 == 0) reach /= 2;
      }
    }
  }

  const ValidPositionQuery& query_;
  std::vector<PlacedConstraint> constraints_;
  Random random_;
  Box box_;
  std::uint64_t tried_ = 0;
};

tl::unexpected<NoValidPosition> none(NoPosition kind, std::string why) {
  return tl::unexpected<NoValidPosition>({kind, std::move(why)});
}

}  // namespace

FreeAir free_air_of(const world::World& world, const world::VehicleModel& vehicle, double clearance,
                    MissionTime at) {
  const world::AirspaceGrid& grid = world.airspace;
  FreeAir air;
  for (std::size_t i = 0; i < 3; ++i) {
    air.low[i] = grid.origin[static_cast<Eigen::Index>(i)];
    air.high[i] = air.low[i] + grid.voxel * grid.size[i];
  }
  air.holds = [&world, clearance, ceiling = vehicle.ceiling, beside = vehicle.body_radius + kBeside,
               window = world::TimeWindow{at}](const Position& p) {
    if (!world.terrain.contains(p[0], p[1])) return false;
    const double height = p[2] - world.terrain.elevation(p[0], p[1]);
    if (height < clearance || height > ceiling) return false;
    return std::none_of(world.volumes.begin(), world.volumes.end(), [&](const world::Volume& one) {
      return one.when.overlaps(window) && p[2] >= one.floor - beside &&
             p[2] <= one.ceiling + beside && world::to_polygon({p[0], p[1]}, one.polygon) <= beside;
    });
  };
  return air;
}

Result<ValidPosition, NoValidPosition> valid_position(const ValidPositionQuery& query,
                                                      const Observer& observer, MissionTime now) {
  const Whereabouts whereabouts = known_by(observer, now, query.limits);
  std::vector<PlacedConstraint> constraints;
  for (const ActiveScm& active : query.scms) {
    for (auto& one : placed(active.scm, active.binding, whereabouts)) {
      if (!one) return none(NoPosition::kUnknownPlace, "a place of " + active.id + " is unknown");
      constraints.push_back(std::move(*one));
    }
  }
  const auto found = Search(query, std::move(constraints)).run();
  if (found) return *found;
  return none(NoPosition::kNoneFound, "no position in free air where all constraints hold, of " +
                                          std::to_string(query.budget) + " tried");
}

}  // namespace skein::interaction
