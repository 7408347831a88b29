// SPDX-License-Identifier: Apache-2.0
#include "skein/team/abilities.hpp"

#include "skein/foundation/joined.hpp"
#include "skein/interaction/capabilities.hpp"

namespace skein::team {

namespace {

/// Empty: it can.
std::string why_not(const GlobalTask& task, const std::string& uav,
                    const world::VehicleModel& vehicle) {
  if (task.by && task.members == 1 && *task.by != uav) return "it is pinned to " + *task.by;
  if (task.not_by.contains(uav)) return "it is forbidden";
  constexpr double kFull = 1;
  return interaction::lacking(task.needs, interaction::capabilities_of(vehicle, kFull));
}

}  // namespace

std::vector<Conflict> lacks_of(const GlobalMission& mission, const Roster& roster,
                               const Vehicles& vehicles) {
  std::vector<Conflict> conflicts;
  for (const GlobalTask& task : mission.tasks) {
    if (task.needs.empty()) continue;
    std::vector<std::string> reasons;
    std::size_t can = 0;
    bool is_pinned_there = !task.by;
    for (const auto& [uav, vehicle] : vehicles) {
      if (!roster.number_of(uav)) continue;
      const std::string why = why_not(task, uav, vehicle);
      if (!why.empty()) {
        reasons.push_back(uav + ": " + why);
        continue;
      }
      ++can;
      is_pinned_there = is_pinned_there || task.by == uav;
    }
    if (can >= task.members && is_pinned_there) continue;
    const std::string who =
        task.members == 1
            ? "nobody has what it needs"
            : std::to_string(can) + " UAVs have what it needs, not " + std::to_string(task.members);
    conflicts.push_back({task.task.id, "task " + to_text(task.task.id) + ": " + who + ": " +
                                           joined(reasons, "; ")});
  }
  return conflicts;
}

}  // namespace skein::team
