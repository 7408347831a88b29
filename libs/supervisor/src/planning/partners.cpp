// SPDX-License-Identifier: Apache-2.0
#include "planning/partners.hpp"

#include <algorithm>
#include <sstream>

#include "planning/terms.hpp"
#include "skein/foundation/fingerprint.hpp"

namespace skein::supervisor {

namespace {

// Places and zones, in the letters that the world has them in.
void spell_names(mission::ElementaryTask& task, const world::World& world) {
  std::vector<executive::Parameter> parameters = task.parameters.all();
  for (executive::Parameter& one : parameters) {
    const auto spell = [text = one.text, &one](const std::string& name) {
      if (same_name(name, text)) one.text = name;
    };
    for (const world::Zone& zone : world.zones) spell(zone.name);
    for (const auto& [name, at] : world.places) spell(name);
  }
  task.parameters = executive::Parameters(std::move(parameters));
}

// All that are UAVs of the team, in order; else none.
std::vector<std::string> uavs_in(const std::string& text, const std::vector<std::string>& team) {
  std::istringstream stream(text);
  std::vector<std::string> uavs;
  for (std::string word; stream >> word;) {
    if (std::count(team.begin(), team.end(), word) == 0) return {};
    uavs.push_back(word);
  }
  std::sort(uavs.begin(), uavs.end());
  return uavs;
}

// Cut to what is exact as a JSON number.
std::optional<mission::Gathering> gathering_of(const mission::ElementaryTask& task,
                                               const std::vector<std::string>& team) {
  mission::Gathering result;
  Fingerprint about;
  about.put(task.type);
  for (const executive::Parameter& one : task.parameters.all()) {
    const std::vector<std::string> uavs = uavs_in(one.text, team);
    if (uavs.size() > 1) {
      result.members = uavs;
      continue;
    }
    about.put(one.name).put(one.text);
    for (const double number : one.numbers) about.put(number);
  }
  if (result.members.empty()) return std::nullopt;
  for (const std::string& one : result.members) about.put(one);
  result.id = about.value() >> 12U;
  return result;
}

}  // namespace

void know_partners(mission::ElementaryPlan& plan, const world::World& world,
                   const std::vector<std::string>& team) {
  for (mission::ElementaryTask& task : plan.tasks) {
    if (!executive::is_joint(task.type)) continue;
    spell_names(task, world);
    task.gathering = gathering_of(task, team);
  }
}

}  // namespace skein::supervisor
