// SPDX-License-Identifier: Apache-2.0
// How long the energy of a vehicle that waits in the air lasts.
#pragma once

#include "merging/airways.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::decision_node {

/// By what would be flown, not by the straight way home: who got out of the way upwards comes down
/// at the end of a level way, which takes more. Lifetime: refers to its arguments. Source:
/// docs/decisions/0119-what-is-flown-unasked.md.
class ShortEnergy {
 public:
  ShortEnergy(const supervisor::Knowledge& knowledge, const world::World& world, MissionTime now)
      : knowledge_(knowledge), world_(world), now_(now) {}

  /// After one of these ways it still comes home. Cost: that of one cheap bound while there is
  /// plenty, else that of simulating each flight.
  bool lasts_longer(const Airways& ways, const world::VehicleState& seen) const;
  /// Precondition: there is a way.
  const Airway& least_costly(const Airways& ways) const;
  /// It comes home after getting out of the way along it, with half of the margin.
  bool lasts_after(const Airway& aside, double energy) const;

 private:
  const supervisor::Knowledge& knowledge_;
  const world::World& world_;
  MissionTime now_;
};

}  // namespace skein::decision_node
