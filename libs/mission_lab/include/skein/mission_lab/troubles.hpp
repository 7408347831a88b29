// SPDX-License-Identifier: Apache-2.0
// Draws what goes wrong in a mission that somebody else wrote.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skein::mission_lab {

/// Whom things may happen to, and how long.
struct Stage {
  struct Vehicle {
    std::string name;
    std::vector<std::string> devices;
  };
  std::vector<Vehicle> vehicles;     ///< at least one
  std::vector<std::string> daemons;  ///< that may die; the ground station, "sim", UAVs, …
  double until = 600;                ///< [s] it lasts when nothing goes wrong
};

/// In the words of a scenario file.
struct Troubles {
  std::vector<std::string> faults;  ///< "{at: 100, kill: sim, restart_after: 5}"
  std::vector<std::string> cuts;    ///< "{between: [marvin, ground], from: 10, until: 40}"
  std::optional<double> loss;       ///< of samples of streams, (0, 0.3]
};

/// At least one. One seed and one stage give the same.
Troubles draw_troubles(std::uint64_t seed, const Stage& stage);

}  // namespace skein::mission_lab
