// SPDX-License-Identifier: Apache-2.0
// A drawn mission as its text says it: read back with a parser of YAML.
#pragma once

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab::test {

using Names = std::set<std::string>;

/// The generators, with the bounds of the team that their header declares.
struct Generator {
  std::string name;
  Mission (*draw)(std::uint64_t, const Kinds&);
  std::size_t least = 1, most = 8;  ///< vehicles
};

inline std::vector<Generator> generators() {
  return {{"Alone", generate, 1, 4},
          {"Team", generate_team, 1, 8},
          {"Crossing", generate_crossing, 2, 8},
          {"Sweeps", generate_sweeps, 2, 6},
          {"Meetings", generate_meetings, 2, 5},
          {"Robots", generate_robots, 2, 6},
          {"Relays", generate_relays, 2, 6},
          {"Partners", generate_partners, 2, 3},
          {"Sharing", generate_sharing, 2, 4},
          {"Escorts", generate_escorts, 2, 4},
          {"Closures", generate_closures, 1, 4},
          {"Fires", generate_fires, 1, 4},
          {"Orders", generate_orders, 1, 4},
          {"Mixed", generate_mixed, 3, 7},
          {"Anything", generate_anything, 2, 6}};
}

inline Names keys(const YAML::Node& map) {
  Names names;
  for (const auto& entry : map) names.insert(entry.first.as<std::string>());
  return names;
}

/// Calls `visit` with the node and all that is inside it.
template <class Visit>
void walk(const YAML::Node& node, const Visit& visit) {
  if (!node.IsDefined()) return;
  visit(node);
  if (node.IsMap())
    for (const auto& entry : node) walk(entry.second, visit);
  if (node.IsSequence())
    for (const auto& item : node) walk(item, visit);
}

/// All numbers of a text, in order.
inline std::vector<double> numbers(const std::string& text) {
  static const std::regex kNumber("-?[0-9]+(\\.[0-9]+)?");
  std::vector<double> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kNumber), end; at != end; ++at)
    found.push_back(std::stod(at->str()));
  return found;
}

struct DrawnMission {
  Mission mission;
  YAML::Node yaml;

  explicit DrawnMission(Mission drawn)
      : mission(std::move(drawn)), yaml(YAML::Load(to_yaml(mission, ".."))) {}

  Names uavs() const { return keys(yaml["uavs"]); }
  Names places() const { return keys(yaml["world"]["places"]); }
  Names zones() const { return keys(yaml["world"]["zones"]); }
  YAML::Node script() const { return yaml["ground"]["script"]; }
  Names steps() const {
    Names names;
    for (const auto& step : script()) names.insert(step["step"].as<std::string>());
    return names;
  }
  /// The missions that steps give, in the order of the script.
  std::vector<YAML::Node> missions() const {
    std::vector<YAML::Node> found;
    for (const auto& step : script())
      for (const auto& action : step["do"])
        if (action["mission"]) found.push_back(action["mission"]);
    return found;
  }
  std::vector<YAML::Node> tasks() const {
    std::vector<YAML::Node> found;
    for (const YAML::Node& given : missions())
      for (const auto& task : given["tasks"]) found.push_back(task);
    return found;
  }
};

}  // namespace skein::mission_lab::test
