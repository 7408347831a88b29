// SPDX-License-Identifier: Apache-2.0
// Readers of the parts of a scenario file. Each adds its errors to the reader's diagnostics and
// leaves harmless values in place of wrong ones.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "skein/config/reader.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/world/environment_reader.hpp"

namespace skein::scenario {

/// Names that the parts may refer to; complete after world and UAVs are read.
struct Names {
  std::vector<std::string> uavs;
  std::vector<std::string> nodes;    ///< the UAVs and "ground"
  std::vector<std::string> daemons;  ///< the nodes, "sim" and the other functional layers
  std::vector<std::string> zones;
  std::vector<std::string> places;
  std::vector<std::string> volumes;  ///< known from the start or closed by the script
  std::vector<std::string> steps;    ///< of the ground's script
};

Names names_of(const Scenario& scenario);

// Texts of the error for an action that needs onboard planning, in a scenario without it.
inline constexpr const char* kNoPlanning = "nothing is said of planning on board";
inline constexpr const char* kPlanningWanted = "planning: {domain: FILE}";

// Likewise for an action that needs a team.
inline constexpr const char* kNoTeam = "it is in no team";
inline constexpr const char* kTeamWanted = "team: {members: [UAV...]}";
bool in_team(const Scenario& scenario, const std::string& uav);

void read_world(const config::Reader& reader, Diagnostics& diagnostics, WorldSpec& world);
/// An error at `reader` if `point` is not over the ground of the world.
void check_over_ground(const config::Reader& reader, const world::Vector2& point,
                       const world::TerrainSpec& terrain);
void read_uavs(const config::Reader& reader, const std::string& folder, Diagnostics& diagnostics,
               std::vector<UavSpec>& uavs);
/// The DDS vendor of the nodes: one for all, or one for each named node.
void read_dds(const config::Reader& reader, const Names& names, Scenario& scenario);
void read_radio(const config::Reader& reader, const Names& names, RadioSpec& radio);
void read_faults(const config::Reader& reader, const Names& names, FaultSpec& faults);
/// Nothing: the scenario has no onboard planning.
std::optional<PlanningSpec> read_planning(const config::Reader& reader, const std::string& folder,
                                          const Names& names);
/// Null: there are no models of joint tasks, or they have errors, which are added to `problems`.
std::shared_ptr<const interaction::Library> read_interaction(const config::Reader& reader,
                                                             const std::string& folder,
                                                             Diagnostics& problems);
/// Absent: the scenario has no team.
std::optional<team::Config> read_team(const config::Reader& reader, const Names& names,
                                      const RadioSpec& radio, std::uint64_t seed);
void read_variations(const config::Reader& reader, Variations& variations);
void read_pps(const config::Reader& reader, ground_station::PpsConfig& pps);
/// The objects that the ground station tracks; each is assumed at the place of the same name.
std::vector<ground_station::ObjectSpec> read_objects(const config::Reader& reader,
                                                     const WorldSpec& world);
/// The script, and the positions of its high-level tasks in the file.
void read_script(const config::Reader& ground, const Scenario& scenario, GroundSpec& spec);
void read_expectations(const config::Reader& reader, const Names& names,
                       const std::vector<ClosedAir>& air, std::vector<Expectation>& expectations);
/// The volumes that are closed from the start or by the script, with their times.
std::vector<ClosedAir> closed_air_of(const Scenario& scenario);

/// The text of a file; reports an unreadable file.
std::optional<std::string> read_text_of(const config::Reader& reader, const char* what,
                                        const std::string& path);

// Readers shared with world files.
using world::entries_of;
using world::items_of;
using world::read_instant;
using world::read_point;
using world::read_point_2d;

/// Reports a map with more than one of these keys, which exclude each other.
void at_most_one_of(const config::Reader& reader, std::initializer_list<const char*> keys);

/// Seconds of mission time, not negative.
Duration read_seconds(const config::Reader& reader, Duration otherwise = {});

}  // namespace skein::scenario
