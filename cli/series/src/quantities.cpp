// SPDX-License-Identifier: Apache-2.0
#include "quantities.hpp"

#include <algorithm>
#include <cmath>

#include "skein/foundation/nearest.hpp"

namespace skein::series_tool {

namespace {

struct OfUav {
  const char *name, *unit, *says;
  double (*value)(const UavState&);
};

double speed_of(const UavState& uav) {
  return std::hypot(uav.velocity[0], uav.velocity[1], uav.velocity[2]);
}

const std::vector<OfUav>& of_each_uav() {
  static const std::vector<OfUav> all = {
      {"x", "m", "east of the origin", [](const UavState& u) { return u.position[0]; }},
      {"y", "m", "north of it", [](const UavState& u) { return u.position[1]; }},
      {"z", "m", "above it", [](const UavState& u) { return u.position[2]; }},
      {"vx", "m/s", "velocity east", [](const UavState& u) { return u.velocity[0]; }},
      {"vy", "m/s", "velocity north", [](const UavState& u) { return u.velocity[1]; }},
      {"vz", "m/s", "velocity up", [](const UavState& u) { return u.velocity[2]; }},
      {"speed", "m/s", "over the ground and up", speed_of},
      {"heading", "rad", "counter-clockwise from east",
       [](const UavState& u) { return u.heading; }},
      {"energy", "", "what is left, 0 to 1", [](const UavState& u) { return u.energy; }},
      {"airborne", "", "1 in the air, 0 on the ground",
       [](const UavState& u) { return u.airborne; }},
      {"degree", "", "of decisional autonomy", [](const UavState& u) { return u.degree; }},
      {"tasks", "", "elementary tasks under way",
       [](const UavState& u) { return static_cast<double>(u.running.size()); }},
      {"goals", "", "high-level tasks that are not settled",
       [](const UavState& u) { return static_cast<double>(u.open.size()); }},
      {"revision", "", "of its plan", [](const UavState& u) { return u.revision; }},
      {"decisions", "", "of its supervisor so far", [](const UavState& u) { return u.decisions; }},
      {"reachable", "", "1 if the ground station believes so",
       [](const UavState& u) { return u.reachable; }}};
  return all;
}

struct OfRun {
  const char *name, *unit, *says;
};

constexpr OfRun kOthers[] = {
    {"distance", "m", "between every two UAVs"},
    {"least-distance", "m", "between any two UAVs that are both in the air"},
    {"link-up", "", "1 if the radio carries from the UAV to the ground station"},
    {"link-down", "", "1 if it carries from the ground station to the UAV"},
    {"alarms", "", "raised or confirmed, not infirmed"},
    {"messages", "", "event samples sent over radio so far"}};

std::string line(const char* name, const char* unit, const std::string& says) {
  return std::string(name) + (*unit == 0 ? "" : std::string(" [") + unit + "]") + ": " + says +
         "\n";
}

double least_distance(const State& state, const std::vector<std::string>& uavs) {
  double least = kUnknown;
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    for (std::size_t j = i + 1; j < uavs.size(); ++j) {
      const UavState &a = state.uav(uavs[i]), &b = state.uav(uavs[j]);
      if (a.airborne == 1 && b.airborne == 1) least = std::fmin(least, distance(a, b));
    }
  }
  return least;
}

void add_distances(const std::vector<std::string>& uavs, std::vector<Column>& columns) {
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    for (std::size_t j = i + 1; j < uavs.size(); ++j) {
      columns.push_back(
          {"distance " + uavs[i] + " " + uavs[j], [a = uavs[i], b = uavs[j]](const State& state) {
             return distance(state.uav(a), state.uav(b));
           }});
    }
  }
}

/// False if it is no quantity of a run.
bool add_other(const std::string& name, const std::vector<std::string>& uavs,
               std::vector<Column>& columns) {
  if (name == "distance") {
    add_distances(uavs, columns);
  } else if (name == "least-distance") {
    columns.push_back({name, [uavs](const State& state) { return least_distance(state, uavs); }});
  } else if (name == "link-up") {
    for (const std::string& uav : uavs)
      columns.push_back(
          {"link-up " + uav, [uav](const State& state) { return state.link(uav, "ground"); }});
  } else if (name == "link-down") {
    for (const std::string& uav : uavs)
      columns.push_back(
          {"link-down " + uav, [uav](const State& state) { return state.link("ground", uav); }});
  } else if (name == "alarms") {
    columns.push_back({name, [](const State& state) { return state.alarms(); }});
  } else if (name == "messages") {
    columns.push_back({name, [](const State& state) { return state.messages(); }});
  } else {
    return false;
  }
  return true;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const OfUav& one : of_each_uav()) names.emplace_back(one.name);
  for (const OfRun& one : kOthers) names.emplace_back(one.name);
  return names;
}

}  // namespace

std::string list_of_quantities() {
  std::string list;
  for (const OfUav& one : of_each_uav())
    list += line(one.name, one.unit, std::string(one.says) + ", of each UAV");
  for (const OfRun& one : kOthers) list += line(one.name, one.unit, one.says);
  return list;
}

Result<std::vector<Column>, Diagnostics> columns_of(const std::vector<std::string>& quantities,
                                                    const std::vector<std::string>& uavs) {
  std::vector<Column> columns;
  Diagnostics wrong;
  for (const std::string& name : quantities) {
    const auto& known = of_each_uav();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const OfUav& one) { return one.name == name; });
    if (found != known.end()) {
      for (const std::string& uav : uavs)
        columns.push_back({name + " " + uav, [uav, value = found->value](const State& state) {
                             return value(state.uav(uav));
                           }});
    } else if (!add_other(name, uavs, columns)) {
      wrong.add({"", 0, 0, "--of", "no quantity '" + name + "'", "one of --list",
                 nearest_name(name, all_names())});
    }
  }
  if (!wrong.empty()) return tl::unexpected(std::move(wrong));
  return columns;
}

}  // namespace skein::series_tool
