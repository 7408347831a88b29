// SPDX-License-Identifier: Apache-2.0
// Draws faults and radio cuts for a given mission.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/mission_lab/mission.hpp"

namespace skein::mission_lab {

/// One or two of its UAVs' decision nodes die in the first 700 s, for 60 to 600 s, and come back
/// with what they knew. Drawn from the mission's seed by a separate sequence, so that the rest of
/// the mission is unchanged.
void let_die_for_long(Mission& mission);

/// The vehicles and daemons that faults may affect, and the duration of the mission.
struct Stage {
  struct Vehicle {
    std::string name;
    std::vector<std::string> devices;
  };
  std::vector<Vehicle> vehicles;     ///< at least one
  std::vector<std::string> daemons;  ///< that may die; the ground station, "sim", UAVs, …
  double until = 600;                ///< duration of the mission without faults [s]
  bool plans = false;                ///< there is planning, which may take time
};

/// Faults, radio properties and slow computers in the format of scenario files.
struct Troubles {
  std::vector<std::string> faults;       ///< "{at: 100, kill: sim, restart_after: 5}"
  std::vector<std::string> cuts;         ///< "{between: [marvin, ground], from: 10, until: 40}"
  std::optional<double> loss;            ///< of samples of streams, (0, 0.3]
  std::optional<double> planning_takes;  ///< at most, by slow computers in virtual time [s]
};

/// Draws at least one fault or cut. Deterministic for a seed and a stage.
Troubles draw_troubles(std::uint64_t seed, const Stage& stage);

}  // namespace skein::mission_lab
