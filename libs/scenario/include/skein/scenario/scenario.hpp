// SPDX-License-Identifier: Apache-2.0
// A scenario: everything that one run is made of, read from a file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/ground_station/perception_processing.hpp"
#include "skein/ground_station/script.hpp"
#include "skein/scenario/expectation.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/object.hpp"
#include "skein/world/radio_model.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"
#include "skein/world/zone.hpp"

namespace skein::scenario {

/// What a UAV does by itself once it has not heard the ground for a while. Source: T II.1.2,
/// spec 1.2.
struct ContactLoss {
  enum class Policy { kContinue, kHold, kReturn };
  Policy policy = Policy::kContinue;
  Duration after = Duration::seconds(60);
};

struct UavSpec {
  std::string name;
  std::string model_file;
  world::VehicleModel model;
  world::Vector2 start = world::Vector2::Zero();
  double heading = 0;  ///< [rad]
  double energy = 1;   ///< [0, 1]
  int degree = 3;      ///< of decisional autonomy at the start, 1 to 3
  ContactLoss contact_loss;
};

struct WorldSpec {
  world::GeodeticOrigin origin;
  world::TerrainSpec terrain;
  world::Wind wind;
  std::vector<world::Zone> zones;
  std::map<std::string, world::Vector3> places;  ///< [m] ENU
  std::vector<world::WorldObject> objects;
};

/// The radio between two nodes is cut, both ways, in [from, until).
struct CutSpec {
  std::string a;
  std::string b;
  MissionTime from;
  MissionTime until;
};

struct RadioSpec {
  world::RadioModel model;
  std::vector<CutSpec> cuts;
};

struct GroundSpec {
  world::Vector3 position = world::Vector3::Zero();  ///< of its antenna [m] ENU
  ground_station::PpsConfig pps;
  ground_station::Script script;
};

/// The daemon of a node dies and, if told so, is started again.
struct KillSpec {
  MissionTime at;
  std::string node;
  std::optional<Duration> restart_after;
};

/// Something on board a UAV breaks, for good.
struct BreakSpec {
  MissionTime at;
  std::string uav;
  std::string device;  ///< empty: the engine
};

/// Faults drawn from the seed, in addition to those written down.
struct RandomFaults {
  double cuts_per_hour = 0;   ///< of each radio link
  double mean_cut = 20;       ///< [s]
  double kills_per_hour = 0;  ///< of each UAV's decision node, restarted after `mean_dead`
  double mean_dead = 5;       ///< [s]
};

struct FaultSpec {
  std::vector<KillSpec> kills;
  std::vector<BreakSpec> breaks;
  RandomFaults random;
};

/// Source: spec 8.1. The format by example: docs/scenario-format.md.
struct Scenario {
  std::string name;
  std::string file;
  std::string epoch;  ///< ISO 8601, UTC: mission time zero
  MissionTime duration_limit;
  double rate = 1;  ///< mission seconds per second
  std::uint64_t seed = 1;
  WorldSpec world;
  std::vector<UavSpec> uavs;  ///< in the order written
  RadioSpec radio;
  GroundSpec ground;
  FaultSpec faults;
  std::vector<Expectation> expectations;

  std::vector<std::string> uav_names() const;
  const UavSpec* find_uav(const std::string& name) const;
};

/// Reads a scenario file and the model files it names (relative to it). Every error at once.
Result<Scenario, Diagnostics> read_scenario(const std::string& path);
/// The same of text; `file` is what messages say and what model files are relative to.
Result<Scenario, Diagnostics> read_scenario_text(std::string_view text, const std::string& file);

/// Draws the random faults from the scenario's seed: they become cuts and kills beside those
/// written down. Precondition: called once.
void draw_random_faults(Scenario& scenario);

}  // namespace skein::scenario
