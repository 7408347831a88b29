// SPDX-License-Identifier: Apache-2.0
// A spatial constraint with known places, to be evaluated at a position.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/interaction/scm_monitor.hpp"

namespace skein::interaction {

/// The position of a named object, point or UAV; absent: unknown, or too old.
using Whereabouts = std::function<std::optional<Position>(const std::string& name)>;

/// The positions known to an observer that are not older than the limits. Observer and limits must
/// outlive the result.
Whereabouts known_by(const Observer& observer, MissionTime now, const ScmLimits& limits);

/// One constraint, for one of the names that its first place stands for.
class PlacedConstraint {
 public:
  std::size_t index = 0;  ///< of the constraint in its SCM
  std::string place;
  SpatialConstraint::Quantity quantity = SpatialConstraint::Quantity::kDistance;
  Relation relation = Relation::kLess;
  Position origin{}, toward{};  ///< `toward` of an azimuth
  double reference = 0;         ///< [m] or [rad]
  double tolerance = 0;

  /// Distance [m], azimuth or altitude [rad] of a position; absent: the direction is undefined
  /// there.
  std::optional<double> value_of(const Position& at) const;
  /// Margin by which the relation holds for a value; negative if it does not [m] or [rad].
  double slack(double value) const;
  bool holds_by(double slack) const;
  bool holds(const Position& at) const;
  bool operator==(const PlacedConstraint&) const = default;
};

/// The constraints of an SCM under a binding; an element is absent if some place of it is unknown
/// or its reference direction is undefined.
std::vector<std::optional<PlacedConstraint>> placed(const Scm& scm, const ScmBinding& binding,
                                                    const Whereabouts& whereabouts);

}  // namespace skein::interaction
