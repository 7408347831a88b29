// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_setup/overrides.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/node/roster.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::scenario_setup {

namespace {

// "marvin=1", or "2" for everybody.
struct Assignment {
  std::optional<std::string> uav;  ///< absent: all
  int degree = 0;                  ///< 0: it was none from 1 to 5
};

Assignment parsed(const std::string& text) {
  const std::size_t equals = text.find('=');
  Assignment result;
  if (equals != std::string::npos) result.uav = text.substr(0, equals);
  const std::string degree = equals == std::string::npos ? text : text.substr(equals + 1);
  const bool valid = degree.size() == 1 && degree[0] >= '1' && degree[0] <= '5';
  if (valid) result.degree = degree[0] - '0';
  return result;
}

void set_degree(const std::string& text, scenario::Scenario& scenario, Diagnostics& diagnostics) {
  const Assignment assignment = parsed(text);
  if (assignment.degree == 0) {
    diagnostics.add({"", 0, 0, "--degree", "'" + text + "'", "1, 2, 3, 4 or 5, or UAV=DEGREE", ""});
    return;
  }
  bool found = false;
  for (scenario::UavSpec& uav : scenario.uavs) {
    if (assignment.uav && uav.name != *assignment.uav) continue;
    found = true;
    if (mission::allocates(assignment.degree) &&
        !(scenario.team && scenario.team->roster.number_of(uav.name))) {
      diagnostics.add({"", 0, 0, "--degree", uav.name + " is in no team: '" + text + "'",
                       "team: {members: [UAV...]} in the scenario", ""});
      continue;
    }
    uav.degree = assignment.degree;
  }
  if (!found && assignment.uav) {
    diagnostics.add({"", 0, 0, "--degree", "no UAV '" + *assignment.uav + "'", "",
                     nearest_name(*assignment.uav, scenario.uav_names())});
  }
}

void set_dds(const std::string& text, scenario::Scenario& scenario, Diagnostics& diagnostics) {
  const std::size_t equals = text.find('=');
  const std::string vendor = equals == std::string::npos ? text : text.substr(equals + 1);
  if (!blackboard::dds_from_name(vendor)) {
    diagnostics.add({"", 0, 0, "--dds", "'" + text + "'",
                     joined(blackboard::dds_names(), " or ") + ", or NODE=WORD",
                     nearest_name(vendor, blackboard::dds_names())});
    return;
  }
  if (equals == std::string::npos) {
    scenario.dds = vendor;
    scenario.dds_by_node.clear();
    return;
  }
  const std::string node = text.substr(0, equals);
  std::vector<std::string> nodes;
  const node::Roster roster = roster_of(scenario);
  for (const node::Member& member : roster.members())
    if (member.role != wire::Role::kOperator) nodes.push_back(member.name);
  if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) {
    diagnostics.add({"", 0, 0, "--dds", "no node '" + node + "'", "", nearest_name(node, nodes)});
    return;
  }
  scenario.dds_by_node.insert_or_assign(node, vendor);
}

}  // namespace

std::vector<std::string> Overrides::as_options() const {
  std::vector<std::string> options;
  if (rate) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", *rate);
    options.insert(options.end(), {"--rate", text});
  }
  if (seed) options.insert(options.end(), {"--seed", std::to_string(*seed)});
  for (const std::string& degree : degrees) options.insert(options.end(), {"--degree", degree});
  return options;
}

Diagnostics apply(const Overrides& overrides, scenario::Scenario& scenario) {
  Diagnostics diagnostics;
  if (overrides.rate &&
      !(std::isfinite(*overrides.rate) && *overrides.rate >= 0.01 && *overrides.rate <= 1000)) {
    diagnostics.add({"", 0, 0, "--rate", "out of range", "a number from 0.01 to 1000", ""});
  }
  scenario.rate = overrides.rate.value_or(scenario.rate);
  scenario.seed = overrides.seed.value_or(scenario.seed);
  for (const std::string& degree : overrides.degrees) set_degree(degree, scenario, diagnostics);
  for (const std::string& dds : overrides.dds) set_dds(dds, scenario, diagnostics);
  scenario::draw_random_faults(scenario);
  scenario::draw_variations(scenario);
  return diagnostics;
}

Result<scenario::Scenario, Diagnostics> load_scenario(const std::string& path,
                                                      const Overrides& overrides,
                                                      const Check& check) {
  auto scenario = scenario::read_scenario(path);
  if (!scenario) return scenario;
  Diagnostics diagnostics = apply(overrides, *scenario);
  if (diagnostics.empty() && check) diagnostics = check(*scenario);
  if (!diagnostics.empty()) return tl::unexpected(std::move(diagnostics));
  return scenario;
}

}  // namespace skein::scenario_setup
