// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/scenario.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "reading.hpp"
#include "skein/config/parse.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::scenario {

namespace {

using config::Reader;

/// Of the antenna; on the ground at the origin if nothing is said. In the ground it hears nobody:
/// measured ground is seldom at height 0.
world::Vector3 read_antenna(const Reader& reader, const world::TerrainSpec& terrain) {
  world::Vector3 at = read_point(reader);
  if (!world::problems_of(terrain).empty()) return at;
  const double ground = world::Terrain(terrain).elevation(at.x(), at.y());
  if (!reader.present()) at.z() = ground;
  if (at.z() > ground - 0.5) return at;
  std::ostringstream message, expected;
  message << std::fixed << std::setprecision(1) << "the antenna is " << ground - at.z()
          << " m below the ground";
  expected << std::fixed << std::setprecision(1) << "a height over " << ground << " m there";
  reader.error(message.str(), expected.str());
  return at;
}

void read_ground(const Reader& reader, Scenario& scenario) {
  reader.keys({"position", "pps", "objects", "script", "operator", "command_lifetime"});
  scenario.ground.position = read_antenna(reader.optional("position"), scenario.world.terrain);
  read_pps(reader.optional("pps"), scenario.ground.pps);
  scenario.ground.objects = read_objects(reader.optional("objects"), scenario.world);
  read_script(reader, scenario, scenario.ground);
}

/// What a UAV plans on board gets numbers beyond those of the script, unless the scenario says
/// which.
void number_planned_tasks(const std::map<std::string, executive::TaskId>& last_of_script,
                          std::map<std::string, executive::TaskId>& first_planned) {
  for (const auto& [uav, last] : last_of_script)
    first_planned.emplace(uav, executive::TaskId(last.value() + 1));
}

/// What the looks of each device are worth; a device of which nobody says it is an error, since its
/// perceptions would come to nothing in silence.
void weigh_devices(const Reader& uavs, Scenario& scenario) {
  ground_station::PpsConfig& pps = scenario.ground.pps;
  for (const UavSpec& uav : scenario.uavs) {
    for (const world::SensorModel& sensor : uav.model.sensors) {
      if (sensor.evidence) {
        pps.models[{uav.name, sensor.device}] = *sensor.evidence;
      } else if (!pps.devices.contains(sensor.device)) {
        uavs.optional(uav.name).optional("model").error(
            "what the looks of '" + sensor.device + "' are worth is not said",
            "evidence: {reports: {fire: [0.8, 0.1]}} in the sensor's model, or evidence: {reports: "
            "{}}");
      }
    }
  }
}

/// Sensors see nothing of kinds that are misspelt, here or at the object. A model has kinds of
/// other missions too: of those that are like no object's nothing is said.
void warn_of_kinds(const Reader& uavs, const Scenario& scenario) {
  std::vector<std::string> kinds;
  for (const world::WorldObject& object : scenario.world.objects) kinds.push_back(object.kind);
  for (const UavSpec& uav : scenario.uavs) {
    for (const world::SensorModel& sensor : uav.model.sensors) {
      for (const auto& [kind, response] : sensor.responses) {
        if (std::ranges::find(kinds, kind) != kinds.end()) continue;
        const std::string nearest = nearest_name(kind, kinds);
        if (nearest.empty() || sensor.responses.contains(nearest)) continue;
        uavs.optional(uav.name).optional("model").error(
            "'" + sensor.device + "' sees '" + kind +
                "', of which kind no object is, and none of '" + nearest + "'",
            "", nearest);
      }
    }
  }
}

// ISO 8601 in UTC, to the second: 2005-05-19T09:00:00Z.
void read_epoch(const Reader& reader, std::string& epoch) {
  epoch = reader.text();
  std::istringstream text(epoch);
  std::tm parts{};
  text >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%SZ");
  const std::chrono::year_month_day date{
      std::chrono::year(parts.tm_year + 1900),
      std::chrono::month(static_cast<unsigned>(parts.tm_mon + 1)),
      std::chrono::day(static_cast<unsigned>(parts.tm_mday))};
  if (epoch.empty() || (text && epoch.size() == 20 && date.ok() && parts.tm_sec < 60)) return;
  reader.error("'" + epoch + "'", "an instant in UTC such as 2005-05-19T09:00:00Z");
}

void check_starts(const Reader& uavs, const Scenario& scenario) {
  for (const UavSpec& uav : scenario.uavs)
    check_over_ground(uavs.optional(uav.name).optional("start"), uav.start, scenario.world.terrain);
}

void check_degrees(const Reader& uavs, const Scenario& scenario) {
  for (const UavSpec& uav : scenario.uavs) {
    if (uav.degree < 4 || scenario.planning) continue;
    uavs.optional(uav.name).optional("degree").error(kNoPlanning, kPlanningWanted);
  }
  for (const UavSpec& uav : scenario.uavs) {
    if (!mission::allocates(uav.degree) || in_team(scenario, uav.name)) continue;
    uavs.optional(uav.name).optional("degree").error(kNoTeam, kTeamWanted);
  }
}

std::optional<SeparationSpec> read_separation(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  reader.keys({"merge"});
  return SeparationSpec{reader.optional("merge").boolean(true)};
}

std::optional<config::Value> slots_of(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  config::Value document;
  document.kind = config::Value::Kind::kMap;
  document.line = reader.line();
  document.entries.push_back({"slots", reader.value()});
  return document;
}

void read_all(const Reader& reader, const std::string& folder, Diagnostics& diagnostics,
              Scenario& scenario) {
  if (!reader.present()) reader.error("nothing", "a scenario");
  if (!reader.keys({"scenario", "epoch", "duration_limit", "rate", "seed", "world", "uavs", "radio",
                    "slots", "ground", "planning", "interaction", "team", "separation", "faults",
                    "dds", "variations", "expect"})) {
    return;
  }
  scenario.name = reader.required("scenario").text();
  read_epoch(reader.required("epoch"), scenario.epoch);
  scenario.duration_limit = read_instant(reader.required("duration_limit"));
  scenario.rate = reader.optional("rate").number(1, {0.01, 1000, "mission seconds per second"});
  scenario.seed = reader.optional("seed").natural(1);
  read_world(reader.required("world"), diagnostics, scenario.world);
  read_uavs(reader.required("uavs"), folder, diagnostics, scenario.uavs);
  const Names names = names_of(scenario);
  read_dds(reader.optional("dds"), names, scenario);
  read_radio(reader.optional("radio"), names, scenario.radio);
  scenario.slots = slots_of(reader.optional("slots"));
  scenario.planning = read_planning(reader.optional("planning"), folder, names);
  scenario.interaction = read_interaction(reader.optional("interaction"), folder, diagnostics);
  scenario.team = read_team(reader.optional("team"), names, scenario.radio, scenario.seed);
  scenario.separation = read_separation(reader.optional("separation"));
  check_starts(reader.required("uavs"), scenario);
  check_degrees(reader.required("uavs"), scenario);
  read_ground(reader.required("ground"), scenario);
  if (scenario.planning)
    number_planned_tasks(scenario.ground.last_ids, scenario.planning->first_ids);
  weigh_devices(reader.required("uavs"), scenario);
  read_faults(reader.optional("faults"), names, scenario.faults);
  read_variations(reader.optional("variations"), scenario.variations);
  read_expectations(reader.optional("expect"), names, closed_air_of(scenario),
                    scenario.expectations);
}

}  // namespace

std::vector<std::string> Scenario::uav_names() const {
  std::vector<std::string> names;
  for (const UavSpec& uav : uavs) names.push_back(uav.name);
  return names;
}

std::map<std::string, std::string> Scenario::functional_layers() const {
  std::map<std::string, std::string> layers;
  for (const UavSpec& uav : uavs) {
    if (!uav.functional.empty()) layers.emplace(uav.name, uav.functional);
  }
  return layers;
}

const std::string& Scenario::dds_of(const std::string& node) const {
  const auto found = dds_by_node.find(node);
  return found == dds_by_node.end() ? dds : found->second;
}

const UavSpec* Scenario::find_uav(const std::string& wanted) const {
  const auto found = std::find_if(uavs.begin(), uavs.end(),
                                  [&](const UavSpec& uav) { return uav.name == wanted; });
  return found == uavs.end() ? nullptr : &*found;
}

Names names_of(const Scenario& scenario) {
  Names names;
  names.uavs = scenario.uav_names();
  names.nodes = names.uavs;
  names.nodes.emplace_back("ground");
  names.daemons = names.nodes;
  names.daemons.emplace_back("sim");
  for (const auto& [uav, layer] : scenario.functional_layers()) names.daemons.push_back(layer);
  for (const world::Zone& zone : scenario.world.zones) names.zones.push_back(zone.name);
  for (const auto& [name, place] : scenario.world.places) names.places.push_back(name);
  for (const world::Volume& volume : scenario.world.volumes) names.volumes.push_back(volume.name);
  return names;
}

namespace {

Result<Scenario, Diagnostics> read_document(const Result<config::Value, Diagnostics>& document,
                                            const std::string& path) {
  if (!document) return tl::unexpected(document.error());
  Diagnostics diagnostics;
  Scenario scenario;
  scenario.file = path;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  read_all(Reader(*document, path, diagnostics), folder, diagnostics, scenario);
  if (!diagnostics.empty()) return tl::unexpected(std::move(diagnostics));
  warn_of_kinds(Reader(*document, path, scenario.warnings).optional("uavs"), scenario);
  return scenario;
}

}  // namespace

Result<Scenario, Diagnostics> read_scenario(const std::string& path) {
  return read_document(config::parse_yaml_file(path), path);
}

Result<Scenario, Diagnostics> read_scenario_text(std::string_view text, const std::string& file) {
  return read_document(config::parse_yaml(text, file), file);
}

}  // namespace skein::scenario
