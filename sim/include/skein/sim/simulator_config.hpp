// SPDX-License-Identifier: Apache-2.0
// Configuration of a simulation.
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
  /// Factor on the speeds of its model at takeoff, landing and along ways, > 0; its limits stay.
  double speed_factor = 1;
  /// False: another node simulates it, and this one is told its position (VehicleElsewhere).
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

/// Scripted properties of a radio link while it is up, in [from, until). Of several that apply at
/// once, the last one in the list that gives a property determines it.
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
  /// Whether this simulator reports objects and the radio. False: another node does, and this one
  /// simulates vehicles only.
  bool tells_world = true;
  /// How long tasks continue while their decision node is silent, since it may come back.
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

/// All problems of a configuration, in sentences: a start outside the terrain, two nodes of one
/// name, a cut between unknown nodes, a period that is not positive, …; empty if it is valid.
std::vector<std::string> problems_of(const SimulatorConfig& config);

}  // namespace skein::sim
