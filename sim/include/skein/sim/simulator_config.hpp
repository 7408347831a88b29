// SPDX-License-Identifier: Apache-2.0
// What a simulation is made of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/object.hpp"
#include "skein/world/radio_model.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::sim {

/// The name of the ground station among the nodes of the radio.
inline constexpr const char* kGroundNode = "ground";

struct SimulatedVehicle {
  std::string name;
  world::VehicleModel model;
  world::Vector2 start = world::Vector2::Zero();  ///< on the ground there
  double heading = 0;                             ///< [rad], ENU counter-clockwise from east
  double energy = 1;                              ///< at the start, [0, 1]
  /// Of the speeds that its model promises, what it flies takeoffs, landings and ways at, > 0; its
  /// limits stay.
  double speed_factor = 1;
  /// False: another node plays it, and this one is told where it is (VehicleElsewhere).
  bool played = true;
};

/// A scripted loss of the radio between two nodes in [from, until).
struct RadioCut {
  std::string a;
  std::string b;
  MissionTime from;
  MissionTime until;
  bool one_way = false;  ///< only from a to b; else both ways
};

/// A link that is unlike the others as long as it is up, in [from, until). Of several that hold at
/// once the later one counts.
struct RadioScript {
  std::string a;
  std::string b;
  bool one_way = false;
  MissionTime from;
  MissionTime until;
  std::optional<Duration> latency;
  std::optional<double> loss;      ///< [0, 1)
  std::optional<double> capacity;  ///< [bit/s], > 0
};

struct SimulatorConfig {
  world::Terrain terrain;
  world::Wind wind = {};
  std::vector<world::WorldObject> objects = {};
  std::vector<SimulatedVehicle> vehicles = {};
  world::RadioModel radio = {};
  world::Vector3 ground_station = world::Vector3::Zero();  ///< its antenna [m], ENU
  std::vector<RadioCut> cuts = {};
  std::vector<RadioScript> links = {};
  /// It tells of objects and of the radio. False: another node does, and this one only plays
  /// vehicles.
  bool tells_world = true;
  /// How long tasks go on while their decision node is silent: it may come back.
  Duration patience = Duration::seconds(120);
  std::uint64_t seed = 1;
  MissionTime start = {};                       ///< instant of the first step
  Duration step = Duration::milliseconds(100);  ///< of the physics, > 0
  Duration telemetry_period = Duration::milliseconds(1000);
  Duration radio_period =
      Duration::milliseconds(1000);  ///< between two looks at the geometry of links
  Duration object_period =
      Duration::milliseconds(30000);  ///< between two truths of an unchanged object
};

/// Why it cannot be simulated, in sentences, all at once: a start outside the terrain, two nodes of
/// one name, a cut between unknown nodes, a period that is not positive, …; empty when it can.
std::vector<std::string> problems_of(const SimulatorConfig& config);

}  // namespace skein::sim
