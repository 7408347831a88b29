// SPDX-License-Identifier: Apache-2.0
// A spatial constraint whose places are known: what it says of a position.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/interaction/scm_monitor.hpp"

namespace skein::interaction {

/// Where a name is, as far as that counts; absent: unknown, or too long ago.
using Whereabouts = std::function<std::optional<Position>(const std::string& name)>;

/// What an observer knows that is not older than the limits say. Both must outlive the result.
Whereabouts known_by(const Observer& observer, MissionTime now, const ScmLimits& limits);

/// One constraint on one of the names that its first place stands for.
class PlacedConstraint {
 public:
  std::size_t index = 0;  ///< in its SCM
  std::string place;
  SpatialConstraint::Quantity quantity = SpatialConstraint::Quantity::kDistance;
  Relation relation = Relation::kLess;
  Position origin{}, toward{};  ///< `toward` of an azimuth
  double reference = 0;         ///< [m] or [rad]
  double tolerance = 0;

  /// Distance, azimuth or altitude of a position; absent: it has no direction from there.
  std::optional<double> value_of(const Position& at) const;
  /// By how much the relation holds for a value; negative if it does not [m] or [rad].
  double slack(double value) const;
  bool holds_by(double slack) const;
  bool holds(const Position& at) const;
};

/// What an SCM says in a binding: absent where some place is unknown or gives no direction.
std::vector<std::optional<PlacedConstraint>> placed(const Scm& scm, const ScmBinding& binding,
                                                    const Whereabouts& whereabouts);

}  // namespace skein::interaction
