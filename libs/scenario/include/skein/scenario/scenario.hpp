// SPDX-License-Identifier: Apache-2.0
// A scenario: everything that one run is made of, read from a file.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/ground_orders/object_spec.hpp"
#include "skein/ground_orders/pps_config.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/interaction/model.hpp"
#include "skein/scenario/expectation.hpp"
#include "skein/team/roster.hpp"
#include "skein/temporal/algorithm.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/object.hpp"
#include "skein/world/radio_model.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/wind.hpp"
#include "skein/world/world_file.hpp"
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
  int degree = 3;      ///< of decisional autonomy at the start, 1 to 5
  ContactLoss contact_loss;
  /// The node that is its functional layer; empty: the simulator.
  std::string functional;
  double speed_factor = 1;  ///< it flies at this part of what its model promises; see Variations
};

struct WorldSpec {
  world::GeodeticOrigin origin;
  world::TerrainSpec terrain;
  world::Wind wind;
  std::vector<world::Zone> zones;
  std::vector<world::Volume> volumes;            ///< no-fly, known from the start
  std::map<std::string, world::Vector3> places;  ///< [m] ENU
  std::vector<world::WorldObject> objects;
};

/// The radio between two nodes is cut in [from, until).
struct CutSpec {
  std::string a;
  std::string b;
  MissionTime from;
  MissionTime until;
  bool one_way = false;  ///< only from a to b; else both ways
};

/// A radio link that is unlike the others in [from, until). What is absent is as of the others.
struct LinkSpec {
  std::string a;
  std::string b;
  bool one_way = false;
  MissionTime from;
  MissionTime until = MissionTime::max();
  std::optional<Duration> latency;
  std::optional<double> loss;      ///< [0, 0.99]
  std::optional<double> capacity;  ///< [bit/s]
};

struct RadioSpec {
  world::RadioModel model;
  std::vector<CutSpec> cuts;
  std::vector<LinkSpec> links;                ///< of several that hold at once the later one counts
  Duration heartbeat = Duration::seconds(1);  ///< of every node on each of its channels
  std::vector<std::string> relays;            ///< who passes on what is for others
  /// Nobody is told which links are up: what carries the samples cuts, as in flight. In virtual
  /// time the memory transport does; over DDS nothing the simulator says of links counts, and
  /// somebody else must cut (scripts/radio-lab).
  bool silent = false;
};

/// Where high-level tasks are written, by UAV and number: for errors found only later.
using TaskMarks = std::map<std::pair<std::string, mission::GoalId>, world::Mark>;

struct GroundSpec {
  world::Vector3 position = world::Vector3::Zero();  ///< of its antenna [m] ENU
  ground_station::PpsConfig pps;
  std::vector<ground_station::ObjectSpec> objects;  ///< that it follows by what sensors tell
  ground_station::Script script;
  TaskMarks asked;   ///< of missions for UAVs
  TaskMarks played;  ///< of joint tasks in which the ground station plays for UAVs
};

/// The daemon of a node dies and, if told so, is started again.
struct KillSpec {
  MissionTime at;
  std::string node;
  std::optional<Duration> restart_after;
  bool forgets = false;  ///< it comes back with nothing it knew
};

/// Something on board a UAV breaks, for good.
struct BreakSpec {
  MissionTime at;
  std::string uav;
  std::string device;  ///< empty: the engine
};

/// Takeoffs, landings and ways of a UAV are flown at 1/`factor` of their speed.
struct SlowSpec {
  MissionTime at;
  std::string uav;
  double factor = 1;  ///< >= 1
  Duration lasts;
};

/// The functional layer of a UAV aborts the task of the type that runs, or else the next one.
struct AbortSpec {
  MissionTime at;
  std::string uav;
  std::string type;
  Duration lasts = {};  ///< if not zero: it, and every one that is to begin within that time
};

/// A UAV finds that it has less energy than it believed.
struct EnergySpec {
  MissionTime at;
  std::string uav;
  double left = 0;  ///< [0, 1]
};

/// Faults drawn from the seed, in addition to those written down.
struct RandomFaults {
  double cuts_per_hour = 0;   ///< of each radio link
  double mean_cut = 20;       ///< [s]
  double kills_per_hour = 0;  ///< of each node, restarted after `mean_dead` with what it knew
  double mean_dead = 5;       ///< [s]
};

struct FaultSpec {
  std::vector<KillSpec> kills;
  std::vector<BreakSpec> breaks;
  std::vector<SlowSpec> slows;
  std::vector<AbortSpec> aborts;
  std::vector<EnergySpec> energies;
  RandomFaults random;
};

/// What deliberation on board goes by. Source: spec 1.2, 3.3, 6.1.
struct PlanningSpec {
  std::string domain_file;                  ///< as written
  std::string domain_path;                  ///< where it was read: for messages
  std::string domain;                       ///< its text
  double altitude = 40;                     ///< of flights, over the ground [m]
  std::map<std::string, double> altitudes;  ///< of single UAVs, instead of `altitude` [m]
  double voxel = 10;                        ///< of the airspace [m]
  std::optional<double> ceiling;  ///< of the airspace [m] ENU z; absent: as in world files
  world::GroundRequest ground;    ///< the risk of the ground
  Duration horizon = Duration::seconds(15);  ///< of commitment
  /// How UAVs keep their plans consistent in time with each other's; absent: they do not.
  std::optional<temporal::Algorithm> consistency = temporal::Algorithm::kDipM;
  /// The elementary tasks that a UAV plans are numbered from here on; 1 where nothing is said.
  std::map<std::string, executive::TaskId> first_ids;
};

/// Ways that do not cross. That the key is there asks for separation to be judged; `merge`, that
/// UAVs reserve the air of their ways before they fly them. Source: spec 6.4.
struct SeparationSpec {
  bool merge = true;
};

/// Bounds of what is drawn from the seed at each run; what is absent stays as written.
struct Variations {
  struct Range {
    double low = 0, high = 0;
  };
  std::optional<Range> wind_speed;    ///< [m/s]
  std::optional<Range> wind_toward;   ///< [rad]
  std::optional<Range> speed_factor;  ///< of each UAV, drawn for each
  std::optional<Range> latency;       ///< of the radio [s]
  std::optional<Range> loss;          ///< of the radio, [0, 0.99]
  /// So much later [s] comes every instant that the script waits for, the same for all.
  std::optional<Range> start_delay;
};

/// The vendors of DDS that daemons can use; the first is the default.
inline constexpr std::array<const char*, 2> kDdsNames{"fastdds", "cyclonedds"};

/// Source: spec 8.1. The format by example: docs/scenario-format.md.
struct Scenario {
  std::string name;
  std::string file;
  std::string epoch;  ///< ISO 8601, UTC: mission time zero
  MissionTime duration_limit;
  double rate = 1;  ///< mission seconds per second
  /// Whose DDS daemons use, one of kDdsNames: all, and what is said of single nodes.
  std::string dds{kDdsNames.front()};
  std::map<std::string, std::string> dds_by_node;
  std::uint64_t seed = 1;
  WorldSpec world;
  std::vector<UavSpec> uavs;  ///< in the order written
  RadioSpec radio;
  /// Which slots are unlike those that ship: a map with the key `slots`, as it stands in the file;
  /// absent: none. What it means, and whether it is right, the blackboard says (read_slot_table).
  std::optional<config::Value> slots;
  GroundSpec ground;
  FaultSpec faults;
  std::optional<PlanningSpec> planning;
  /// Models of joint tasks; null: there are none.
  std::shared_ptr<const interaction::Library> interaction;
  std::optional<team::Config> team;          ///< who shares out global missions; absent: nobody
  std::optional<SeparationSpec> separation;  ///< absent: nobody asks for it
  Variations variations;
  std::vector<Expectation> expectations;

  std::vector<std::string> uav_names() const;
  /// By UAV, of those that have a functional layer of their own.
  std::map<std::string, std::string> functional_layers() const;
  /// Whose DDS the daemon of this node uses.
  const std::string& dds_of(const std::string& node) const;
  const UavSpec* find_uav(const std::string& name) const;
};

/// Reads a scenario file and the model files it names (relative to it). Every error at once.
Result<Scenario, Diagnostics> read_scenario(const std::string& path);
/// The same of text; `file` is what messages say and what model files are relative to.
Result<Scenario, Diagnostics> read_scenario_text(std::string_view text, const std::string& file);

/// Draws the random faults from the scenario's seed: they become cuts and kills beside those
/// written down. Precondition: called once.
void draw_random_faults(Scenario& scenario);

/// Draws the variations from the scenario's seed, each from a sequence of its own: one more does
/// not change what the others come to. Precondition: called once.
void draw_variations(Scenario& scenario);

}  // namespace skein::scenario
