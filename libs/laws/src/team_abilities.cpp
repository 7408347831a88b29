// SPDX-License-Identifier: Apache-2.0
// Who does a task of the team has what the operator said that it needs.
#include "checks.hpp"
#include "scripted.hpp"
#include "skein/interaction/capabilities.hpp"

namespace skein::laws {

namespace {

/// With the energy with which it began the flight: what is asked later of it is no more than that.
interaction::Capabilities at_best(const scenario::UavSpec& uav) {
  return interaction::capabilities_of(uav.model, uav.energy);
}

}  // namespace

std::vector<Violation> team_abilities_lacking(const History& history) {
  std::vector<Violation> result;
  const auto judge = [&](const team::GlobalTask& task) {
    const auto number = static_cast<std::int64_t>(task.task.id.value());
    const auto told = history.team.tasks.find(number);
    if (task.needs.empty() || told == history.team.tasks.end()) return;
    for (const TeamWork& work : told->second.works) {
      const scenario::UavSpec* uav = history.scenario->find_uav(work.uav);
      if (uav == nullptr) continue;
      const std::string lacks = interaction::lacking(task.needs, at_best(*uav));
      if (lacks.empty()) continue;
      result.push_back({"", work.begun, work.uav, work.goal,
                        "it began task " + std::to_string(number) + " of the team, and " + lacks});
    }
  };
  for_scripted<ground_station::SendGlobalMission>(*history.scenario, [&](const auto& send) {
    for (const team::GlobalTask& task : send.mission.tasks) judge(task);
  });
  return result;
}

}  // namespace skein::laws
