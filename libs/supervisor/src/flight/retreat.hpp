// SPDX-License-Identifier: Apache-2.0
// What it takes to come home: the energy that every plan leaves for it.
#pragma once

#include <optional>
#include <vector>

#include "flight/whereabouts.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Kept free by every plan beside the reserve, for what flights take beyond what is expected; in
/// flight a plan is given up when less than half of it is left. Fraction of what is held when full.
inline constexpr double kSpareEnergy = 0.02;

/// Where tasks leave it, in their order.
Whereabouts after(Whereabouts start, const std::vector<mission::ElementaryTask>& tasks);

/// Energies are fractions of what is held when full, as expected against the wind as believed, with
/// a tenth on top for what is not foreseen of a way that nobody has planned: straight over the
/// highest ground between, round closed air by half of its border, never less than the vehicle
/// itself asks for (way_energy.hpp); then down to the ground. Zero for a vehicle whose model has no
/// capacity or speed; infinite against a wind that it cannot fly against. Lifetime: refers to its
/// arguments. Cost: O(terrain cells on the way + volumes).
class Retreat {
 public:
  Retreat(const Knowledge& knowledge, const world::World& world, MissionTime now)
      : knowledge_(knowledge), world_(world), now_(now) {}
  /// One whose sums are no less than these and cost next to nothing, since nothing is flown in
  /// thought: for who asks often, and mostly has plenty.
  Retreat at_most() const {
    Retreat result = *this;
    result.at_most_ = true;
    return result;
  }

  /// From a place in the air, to fly to a place on the ground and land there.
  double energy(const world::Vector3& from, const world::Vector3& to) const;
  double home(const world::Vector3& from) const { return energy(from, knowledge_.home); }
  /// What is to be left where a plan ends: nothing on the ground.
  double after(const Whereabouts& end) const { return end.airborne ? home(end.position) : 0; }
  /// To fly straight on, without margin.
  double flight(const std::vector<world::Vector3>& way) const;
  /// To go down to the ground from there.
  double descent(const world::Vector3& from) const;

  /// Where to land coming from there with so much above the reserve: nothing: at home; else the
  /// nearest ground that serves.
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
