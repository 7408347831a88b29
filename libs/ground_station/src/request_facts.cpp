// SPDX-License-Identifier: Apache-2.0
// One overload per kind of request.
#include "request_facts.hpp"

#include <type_traits>

#include "skein/functional/task_types.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;

std::string describe(const executive::Start& start) {
  return "START " + skein::to_text(start.task.id) + " " + start.task.type;
}
std::string describe(const executive::Abort& abort) { return "ABORT " + skein::to_text(abort.id); }
std::string describe(const executive::ProcessMessage& process) {
  return "PROCESS-MSG " + process.message;
}
std::string describe(const executive::UpdateConditions& update) {
  return "UPDATE-COND " + skein::to_text(update.id);
}
std::string describe(const executive::Suppress& suppress) {
  return "SUPPRESS " + skein::to_text(suppress.id);
}

std::string describe(const mission::UnitMission& mission) {
  const std::string count = std::to_string(mission.tasks.size());
  return "MISSION " + skein::to_text(mission.id) + " (" + count +
         (mission.tasks.size() == 1 ? " task)" : " tasks)");
}
std::string describe(const mission::CancelGoals& cancel) {
  std::string goals;
  for (const mission::GoalId goal : cancel.goals) goals += " " + skein::to_text(goal);
  const bool by_mission = cancel.mission != mission::MissionId();
  if (by_mission) goals += " mission " + skein::to_text(cancel.mission);
  return "CANCEL" + (goals.empty() ? " all" : goals);
}
std::string describe(const mission::ChangeDegree& change) {
  return "DEGREE " + std::to_string(change.degree);
}
std::string describe(const mission::ChangeWorld& change) {
  if (change.place) return "PLACE " + change.place->name;
  if (change.ground) return "GROUND " + change.ground->name;
  return (change.remove ? "OPEN " : "CLOSE ") + change.volume.name;
}

std::optional<TaskId> named(const executive::Start&) { return std::nullopt; }
std::optional<TaskId> named(const executive::Abort& abort) { return abort.id; }
std::optional<TaskId> named(const executive::ProcessMessage&) { return std::nullopt; }
std::optional<TaskId> named(const executive::UpdateConditions& update) { return update.id; }
std::optional<TaskId> named(const executive::Suppress& suppress) { return suppress.id; }
template <class OfDecisionNode>
std::optional<TaskId> named(const OfDecisionNode&) {
  return std::nullopt;
}

}  // namespace

std::string what_of(const Request& request) {
  return std::visit([](const auto& it) { return describe(it); }, request);
}

std::optional<TaskId> started_by(const Request& request) {
  const auto* start = std::get_if<executive::Start>(&request);
  return start == nullptr ? std::nullopt : std::optional(start->task.id);
}

std::optional<executive::Input> to_executive(const Request& request) {
  return std::visit(
      [](const auto& it) -> std::optional<executive::Input> {
        if constexpr (std::is_constructible_v<executive::Input, decltype(it)>) {
          return executive::Input(it);
        } else {
          return std::nullopt;
        }
      },
      request);
}

std::optional<TaskId> named_by(const Request& request) {
  return std::visit([](const auto& it) { return named(it); }, request);
}

bool is_functional(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).by == functional::CarriedOutBy::kFunctionalLayer;
}

}  // namespace skein::ground_station
