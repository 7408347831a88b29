// SPDX-License-Identifier: Apache-2.0
// The functional simulator: vehicles, their sensors, the world and the radio.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/sim/messages.hpp"
#include "skein/sim/simulator_config.hpp"

namespace skein::sim {

/// A component without input/output: inputs and the present instant go in, effects come out.
///
/// Physics advances in fixed steps from config.start; a call at `now` first takes every step due up
/// to now, then applies its input. So the effects depend on the inputs and their instants only, not
/// on how often Tick comes, and one seed gives one exact run. Inputs that name an unknown UAV do
/// nothing. Cost: proportional to the time passed since the last call (about 1 µs per vehicle and
/// step). Thread rule: not safe to share. Source: spec 1.1, 1.5, 8.2.
class Simulator {
 public:
  /// Precondition: problems_of(config) is empty.
  explicit Simulator(SimulatorConfig config);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// `now` never decreases; an earlier instant counts as the last one.
  std::vector<Effect> handle(const Input& input, MissionTime now);
  /// The next step of the physics.
  std::optional<MissionTime> next_wakeup() const;

  /// The truth about a vehicle after the last step taken; null when there is none of that name.
  /// Valid until the next call of handle.
  const world::VehicleState* find_vehicle(std::string_view uav) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace skein::sim
