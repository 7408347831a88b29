// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/placed_constraint.hpp"

#include <cmath>
#include <numbers>

namespace skein::interaction {

namespace {

using Quantity = SpatialConstraint::Quantity;

double distance_between(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Puts one constraint in its places.
class Placing {
 public:
  Placing(const ScmBinding& binding, const Whereabouts& whereabouts)
      : binding_(binding), whereabouts_(whereabouts) {}

  std::optional<PlacedConstraint> place(const SpatialConstraint& one, std::size_t index,
                                        const std::string& name) const {
    PlacedConstraint placed;
    placed.index = index;
    placed.place = name;
    placed.quantity = one.quantity;
    placed.relation = one.relation;
    placed.tolerance = one.tolerance;
    const auto origin = whereabouts_(name);
    if (!origin) return std::nullopt;
    placed.origin = *origin;
    if (one.quantity == Quantity::kAzimuth) {
      const auto toward = first_of(one.of[1]);
      if (!toward) return std::nullopt;
      placed.toward = *toward;
    }
    const auto reference = reference_of(one, placed);
    if (!reference) return std::nullopt;
    placed.reference = *reference;
    return placed;
  }

 private:
  std::optional<Position> first_of(const std::string& place) const {
    const auto& names = binding_.places.at(place);
    return names.empty() ? std::nullopt : whereabouts_(names.front());
  }

  std::optional<double> reference_of(const SpatialConstraint& one,
                                     const PlacedConstraint& placed) const {
    if (const auto* term = std::get_if<Term>(&one.than)) {
      if (const double* number = std::get_if<double>(term)) return *number;
      return binding_.numbers.at(std::get<std::string>(*term));
    }
    const auto& places = std::get<std::vector<std::string>>(one.than);
    const auto first = first_of(places[0]);
    if (!first) return std::nullopt;
    if (one.quantity != Quantity::kDistance) return placed.value_of(*first);
    const auto second = first_of(places[1]);
    if (!second) return std::nullopt;
    return distance_between(*first, *second);
  }

  const ScmBinding& binding_;
  const Whereabouts& whereabouts_;
};

}  // namespace

Whereabouts known_by(const Observer& observer, MissionTime now, const ScmLimits& limits) {
  return [&observer, now, &limits](const std::string& name) -> std::optional<Position> {
    const std::optional<Sighting> seen = observer(name);
    if (!seen) return std::nullopt;
    if (now - seen->at > (seen->by_sensors ? limits.oldest_seen : limits.oldest))
      return std::nullopt;
    return seen->position;
  };
}

std::optional<double> PlacedConstraint::value_of(const Position& at) const {
  if (quantity == Quantity::kDistance) return distance_between(at, origin);
  if (quantity == Quantity::kAltitude) return altitude_in(origin, at);
  return azimuth_in(origin, toward, at);
}

double PlacedConstraint::slack(double value) const {
  switch (relation) {
    case Relation::kLess:
    case Relation::kAtMost:
      return reference - value;
    case Relation::kGreater:
    case Relation::kAtLeast:
      return value - reference;
    case Relation::kEqual:
      break;
  }
  const double gap = value - reference;
  const bool turns = quantity == Quantity::kAzimuth;
  return tolerance - std::abs(turns ? std::remainder(gap, 2 * std::numbers::pi) : gap);
}

bool PlacedConstraint::holds_by(double slack) const {
  const bool strict = relation == Relation::kLess || relation == Relation::kGreater;
  return strict ? slack > 0 : slack >= 0;
}

bool PlacedConstraint::holds(const Position& at) const {
  const auto value = value_of(at);
  return value && holds_by(slack(*value));
}

std::vector<std::optional<PlacedConstraint>> placed(const Scm& scm, const ScmBinding& binding,
                                                    const Whereabouts& whereabouts) {
  std::vector<std::optional<PlacedConstraint>> all;
  const Placing placing(binding, whereabouts);
  for (std::size_t i = 0; i < scm.constraints.size(); ++i) {
    const SpatialConstraint& one = scm.constraints[i];
    for (const std::string& name : binding.places.at(one.of.front())) {
      all.push_back(placing.place(one, i, name));
    }
  }
  return all;
}

}  // namespace skein::interaction
