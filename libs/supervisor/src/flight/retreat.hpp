// SPDX-License-Identifier: Apache-2.0
// The energy that a vehicle needs in order to come home, which every plan leaves it.
#pragma once

#include <optional>
#include <vector>

#include "flight/whereabouts.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Margin that every plan leaves above the reserve, for flights that take more energy than
/// expected; in flight, a plan is given up when less than half of the margin is left. Fraction of
/// the full capacity.
inline constexpr double kSpareEnergy = 0.02;

/// Where the vehicle is after these tasks, carried out in order from `start`.
Whereabouts after(Whereabouts start, const std::vector<mission::ElementaryTask>& tasks);

/// Estimates the energy of unplanned ways to a landing place, as fractions of the full capacity. A
/// way goes straight over the highest ground between its ends, around closed air by half of its
/// border, and down to the ground; in the believed wind, with a margin of 12 % (50 % for ground
/// vehicles), but never less than the vehicle itself asks for (way_energy.hpp). Zero for a vehicle
/// whose model has no capacity or speed; infinite against a wind that it cannot fly against.
/// Lifetime: refers to its arguments. Cost: O(terrain cells on the way + volumes).
class Retreat {
 public:
  Retreat(const Knowledge& knowledge, const world::World& world, MissionTime now)
      : knowledge_(knowledge), world_(world), now_(now) {}
  /// A variant with cheap upper bounds instead of simulated flights, for frequent checks while
  /// there is plenty of energy.
  Retreat at_most() const {
    Retreat result = *this;
    result.at_most_ = true;
    return result;
  }

  /// Energy to fly from a place in the air to a place on the ground and land there.
  double energy(const world::Vector3& from, const world::Vector3& to) const;
  double home(const world::Vector3& from) const { return energy(from, knowledge_.home); }
  /// The same along `way` first, with the same margin, and then home from its end. Precondition: it
  /// has a point.
  double home_along(const std::vector<world::Vector3>& way) const;
  /// Energy to come home from the end of a plan: zero on the ground.
  double after(const Whereabouts& end) const { return end.airborne ? home(end.position) : 0; }
  /// Energy to fly along `way`, without margin.
  double flight(const std::vector<world::Vector3>& way) const;
  /// Energy to descend from `from` to the ground.
  double descent(const world::Vector3& from) const;

  /// The nearest suitable landing place, if the energy `left` above the reserve is not enough to
  /// come home from `from`; absent: it is enough, or there is no such place.
  std::optional<world::Vector3> instead_of_home(const world::Vector3& from, double left) const;

 private:
  double of_stay(double seconds) const;
  double lost_at_most(double seconds) const;
  double detour(const world::Vector3& from, const world::Vector3& to) const;
  double climb(const world::Vector3& from, const world::Vector3& to) const;
  double circling(const world::Vector3& from, const world::Vector3& to) const;

  const Knowledge& knowledge_;
  const world::World& world_;
  MissionTime now_;
  bool at_most_ = false;
};

/// "12.3 %".
std::string percent(double fraction);

}  // namespace skein::supervisor
