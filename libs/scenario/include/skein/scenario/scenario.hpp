// SPDX-License-Identifier: Apache-2.0
// A scenario: the complete description of a run, read from a file.
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

/// Policy of a UAV after it has heard nothing from the ground for the time `after`. Source: T
/// II.1.2, spec 1.2.
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
  /// The node that serves as its functional layer; empty: the simulator.
  std::string functional;
  double speed_factor = 1;  ///< true speed as a fraction of the model's; see Variations
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

/// Properties of one radio link in [from, until); an absent one is that of the radio model.
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
  std::vector<LinkSpec> links;                ///< if several apply, the last one counts
  Duration heartbeat = Duration::seconds(1);  ///< period, of every node on each of its channels
  std::vector<std::string> relays;            ///< nodes that forward samples for others
  /// Nodes are not told which links are up; the transport itself drops samples, as in flight. In
  /// virtual time the memory transport does so; over DDS the simulator's links have no effect, and
  /// the network has to be cut from outside (scripts/radio-lab).
  bool silent = false;
};

/// Positions of high-level tasks in the file, by UAV and number, for errors found after reading.
using TaskMarks = std::map<std::pair<std::string, mission::GoalId>, world::Mark>;

struct GroundSpec {
  world::Vector3 position = world::Vector3::Zero();  ///< of its antenna [m] ENU
  ground_station::PpsConfig pps;
  std::vector<ground_station::ObjectSpec> objects;  ///< tracked by the ground station from percepts
  ground_station::Script script;
  TaskMarks asked;   ///< of missions for UAVs
  TaskMarks played;  ///< of joint tasks in which the ground station plays for UAVs
  /// By UAV: the greatest id of a task that the script gives it.
  std::map<std::string, executive::TaskId> last_ids = {};
};

/// The daemon of a node is killed and, with `restart_after`, started again.
struct KillSpec {
  MissionTime at;
  std::string node;
  std::optional<Duration> restart_after;
  bool forgets = false;  ///< it restarts without its stored state
};

/// A device of a UAV fails for the rest of the run.
struct BreakSpec {
  MissionTime at;
  std::string uav;
  std::string device;  ///< empty: the engine
};

/// A UAV flies takeoffs, landings and paths at 1/`factor` of their speed for the time `lasts`.
struct SlowSpec {
  MissionTime at;
  std::string uav;
  double factor = 1;  ///< >= 1
  Duration lasts;
};

/// The functional layer of a UAV aborts its running task of this type, or else the next one.
struct AbortSpec {
  MissionTime at;
  std::string uav;
  std::string type;
  Duration lasts = {};  ///< not zero: also all tasks of the type that would begin within this time
};

/// The energy of a UAV drops to `left`.
struct EnergySpec {
  MissionTime at;
  std::string uav;
  double left = 0;  ///< [0, 1]
};

/// Faults drawn from the seed, in addition to those written down.
struct RandomFaults {
  double cuts_per_hour = 0;   ///< of each radio link
  double mean_cut = 20;       ///< [s]
  double kills_per_hour = 0;  ///< of each node, which then restarts with its stored state
  double mean_dead = 5;       ///< mean time until the restart [s]
};

struct FaultSpec {
  std::vector<KillSpec> kills;
  std::vector<BreakSpec> breaks;
  std::vector<SlowSpec> slows;
  std::vector<AbortSpec> aborts;
  std::vector<EnergySpec> energies;
  RandomFaults random;
};

/// Settings of onboard deliberation. Source: spec 1.2, 3.3, 6.1.
struct PlanningSpec {
  std::string domain_file;                  ///< as written
  std::string domain_path;                  ///< path it was read from, for messages
  std::string domain;                       ///< its text
  double altitude = 40;                     ///< of flights, over the ground [m]
  std::map<std::string, double> altitudes;  ///< of single UAVs, instead of `altitude` [m]
  double voxel = 10;                        ///< of the airspace [m]
  std::optional<double> ceiling;  ///< of the airspace [m] ENU z; absent: as in world files
  world::GroundRequest ground;    ///< the risk of the ground
  Duration horizon = Duration::seconds(15);  ///< of commitment
  /// Algorithm that keeps the plans of the UAVs temporally consistent; absent: none.
  std::optional<temporal::Algorithm> consistency = temporal::Algorithm::kDipM;
  /// Silence after which a partner of a meeting or joint task is not waited for any more.
  Duration partner_lease = Duration::seconds(600);
  /// In virtual time: how long a job of planning takes, drawn for each from the seed. Over DDS it
  /// takes as long as the machine needs. takes_least <= takes_most.
  Duration takes_least = Duration::milliseconds(50), takes_most = Duration::milliseconds(50);
  /// First number of the elementary tasks that a UAV plans: as the scenario says, or else beyond
  /// the tasks that its script gives the UAV; 1 for UAVs that are not listed.
  std::map<std::string, executive::TaskId> first_ids;
};

/// Separation of paths. If present, the separation of UAVs is judged; with `merge` they also
/// reserve the air of their paths before they fly them. Source: spec 6.4.
struct SeparationSpec {
  bool merge = true;
};

/// Ranges of quantities drawn from the seed for each run; an absent one stays as written.
struct Variations {
  struct Range {
    double low = 0, high = 0;
  };
  std::optional<Range> wind_speed;    ///< [m/s]
  std::optional<Range> wind_toward;   ///< [rad]
  std::optional<Range> speed_factor;  ///< of each UAV, drawn for each
  std::optional<Range> latency;       ///< of the radio [s]
  std::optional<Range> loss;          ///< of the radio, [0, 0.99]
  /// Delay [s] added to every instant that the script waits for; drawn once for all.
  std::optional<Range> start_delay;
};

/// The vendors of DDS that daemons can use; the first is the default.
inline constexpr std::array<const char*, 2> kDdsNames{"fastdds", "cyclonedds"};

/// A scenario file with the models it names. Source: spec 8.1. Format: docs/scenario-format.md.
struct Scenario {
  std::string name;
  std::string file;
  std::string epoch;  ///< ISO 8601, UTC: mission time zero
  MissionTime duration_limit;
  double rate = 1;  ///< mission seconds per second
  /// DDS vendor of the daemons, one of kDdsNames: the default, and exceptions by node.
  std::string dds{kDdsNames.front()};
  std::map<std::string, std::string> dds_by_node;
  std::uint64_t seed = 1;
  WorldSpec world;
  std::vector<UavSpec> uavs;  ///< in the order written
  RadioSpec radio;
  /// Slots that differ from the shipped ones: a map with the key `slots`, as in the file; absent:
  /// none. Interpreted and checked by the blackboard (read_slot_table).
  std::optional<config::Value> slots;
  GroundSpec ground;
  FaultSpec faults;
  std::optional<PlanningSpec> planning;
  /// Models of joint tasks; null: there are none.
  std::shared_ptr<const interaction::Library> interaction;
  std::optional<team::Config> team;          ///< allocates global missions; absent: no team
  std::optional<SeparationSpec> separation;  ///< absent: neither judged nor enforced
  Variations variations;
  std::vector<Expectation> expectations;
  /// What is no error and yet hardly meant, for who wrote the file; not a part of what it says.
  Diagnostics warnings = {};

  std::vector<std::string> uav_names() const;
  /// Node of the functional layer, by UAV, for UAVs that do not use the simulator.
  std::map<std::string, std::string> functional_layers() const;
  /// The DDS vendor of this node's daemon.
  const std::string& dds_of(const std::string& node) const;
  const UavSpec* find_uav(const std::string& name) const;
};

/// Reads a scenario file and the model files it names (relative to its folder). All errors at once.
Result<Scenario, Diagnostics> read_scenario(const std::string& path);
/// The same from text; `file` is used in messages, and model files are relative to its folder.
Result<Scenario, Diagnostics> read_scenario_text(std::string_view text, const std::string& file);

/// Draws the random faults from the scenario's seed: they become cuts and kills beside those
/// written down. Precondition: called once.
void draw_random_faults(Scenario& scenario);

/// Draws the variations from the scenario's seed, each from its own random sequence, so that adding
/// one does not change the others. Precondition: called once.
void draw_variations(Scenario& scenario);

}  // namespace skein::scenario
