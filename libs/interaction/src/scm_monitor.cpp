// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/scm_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/contract.hpp"
#include "skein/interaction/placed_constraint.hpp"

namespace skein::interaction {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double level_between(const Position& a, const Position& b) {
  return std::max(1.0, std::hypot(a[0] - b[0], a[1] - b[1]));
}

/// What an angle is off when the place of what sensors follow is off by as much as it may be.
double doubt(const PlacedConstraint& one, const Position& own, const Observer& observer,
             const ScmLimits& limits) {
  using Quantity = SpatialConstraint::Quantity;
  if (limits.seen == 0 || one.quantity == Quantity::kDistance) return 0;
  const auto sighting = observer(one.place);
  if (!sighting || !sighting->by_sensors) return 0;
  const double at_it = limits.seen / level_between(own, one.origin);
  if (one.quantity == Quantity::kAltitude) return at_it;
  return at_it + limits.seen / level_between(one.toward, one.origin);
}

}  // namespace

std::optional<double> azimuth_in(const Position& origin, const Position& toward,
                                 const Position& place) {
  const double zero_x = toward[0] - origin[0], zero_y = toward[1] - origin[1];
  const double x = place[0] - origin[0], y = place[1] - origin[1];
  if ((zero_x == 0 && zero_y == 0) || (x == 0 && y == 0)) return std::nullopt;
  const double angle = std::atan2(zero_x * y - zero_y * x, zero_x * x + zero_y * y);
  return angle < 0 ? angle + kTurn : angle;
}

std::optional<double> altitude_in(const Position& origin, const Position& place) {
  const double level = std::hypot(place[0] - origin[0], place[1] - origin[1]);
  const double up = place[2] - origin[2];
  if (level == 0 && up == 0) return std::nullopt;
  return std::atan2(up, level);
}

ScmMonitor::ScmMonitor(std::string id, Scm scm, ScmBinding binding, ScmLimits limits)
    : id_(std::move(id)), scm_(std::move(scm)), binding_(std::move(binding)), limits_(limits) {
  for (const Scm::Formal& formal : scm_.parameters) {
    SKEIN_EXPECTS(formal.place ? binding_.places.count(formal.name) > 0
                               : binding_.numbers.count(formal.name) > 0);
  }
}

std::optional<ScmFound> ScmMonitor::update(const Position& own, const Observer& observer,
                                           MissionTime now) {
  using Finding = ScmReport::Finding;
  const Round round = measure(own, observer, now);
  Finding found = Finding::kSatisfied;
  if (round.missed) {
    found = Finding::kViolated;
  } else if (round.unknown) {
    found = Finding::kUndetermined;
  } else if (finding_ == Finding::kViolated && !round.clear) {
    found = Finding::kViolated;  // not by the margin yet
  }
  if (found == finding_) return std::nullopt;
  finding_ = found;
  return ScmFound{{id_, found}, round.missed};
}

ScmMonitor::Round ScmMonitor::measure(const Position& own, const Observer& observer,
                                      MissionTime now) const {
  const Whereabouts whereabouts = known_by(observer, now, limits_);
  Round round;
  double least = 0;
  for (const auto& one : placed(scm_, binding_, whereabouts)) {
    const auto value = one ? one->value_of(own) : std::nullopt;
    if (!value) {
      round.unknown = true;
      continue;
    }
    const double slack = one->slack(*value);
    const bool distance = one->quantity == SpatialConstraint::Quantity::kDistance;
    const double margin = distance ? limits_.distance : limits_.angle;
    // What is equal within a tolerance cannot hold by more than that.
    const double wanted =
        one->relation == Relation::kEqual ? std::min(margin, one->tolerance) : margin;
    round.clear = round.clear && slack >= wanted;
    if (one->holds_by(slack + doubt(*one, own, observer, limits_)) ||
        (round.missed && slack >= least))
      continue;
    least = slack;
    round.missed = Measured{one->index, one->place, one->relation, *value, one->reference};
  }
  return round;
}

}  // namespace skein::interaction
