// SPDX-License-Identifier: Apache-2.0
// What each scripted action asks of the other components.
#include "skein/ground_station/mission_planning.hpp"
#include "skein/ground_station/target_resolution.hpp"

namespace skein::ground_station {
namespace {

executive::Parameter parameter_of(const std::string& name,
                                  const std::vector<world::Vector3>& points) {
  executive::Parameter parameter{name, {}, {}};
  for (const world::Vector3& point : points) {
    parameter.numbers.insert(parameter.numbers.end(), {point.x(), point.y(), point.z()});
  }
  return parameter;
}

}  // namespace

void MissionPlanning::Deed::issue(const std::string& uav, Request request) const {
  effects.emplace_back(IssueCommand{uav, std::move(request), expires, asked_by});
}

void MissionPlanning::perform(const SendPlan& plan, const Deed& deed) {
  for (const PlannedTask& planned : plan.tasks) {
    executive::Start start{planned.task, planned.mode};
    std::string problem;
    for (const Target& target : planned.targets) {
      const auto points = resolve(target, subject(), terrain_);
      if (points) {
        start.task.parameters.add(parameter_of(target.parameter, *points));
      } else {
        problem = points.error().why;
      }
    }
    if (problem.empty()) {
      deed.issue(plan.uav, std::move(start));
    } else {
      deed.effects.emplace_back(Anomaly{"task " + skein::to_text(planned.task.id) + " of " +
                                            plan.uav + " is not sent: " + problem,
                                        deed.asked_by});
    }
  }
}

void MissionPlanning::perform(const AbortTasks& action, const Deed& deed) {
  if (!action.tasks) {
    deed.effects.emplace_back(AbortEverything{action.uav, deed.expires, deed.asked_by});
    return;
  }
  for (const executive::TaskId id : *action.tasks) deed.issue(action.uav, executive::Abort{id});
}

void MissionPlanning::perform(const SendMessage& action, const Deed& deed) {
  deed.issue(action.uav, executive::ProcessMessage{action.text});
}

void MissionPlanning::perform(const UpdateConditions& action, const Deed& deed) {
  deed.issue(action.uav, action.update);
}

void MissionPlanning::perform(const SendMission& action, const Deed& deed) {
  mission::UnitMission mission = action.mission;
  if (mission.asked_by.empty()) mission.asked_by = deed.asked_by;
  std::vector<mission::HighLevelTask*> tasks;
  for (mission::HighLevelTask& task : mission.tasks) tasks.push_back(&task);
  if (const std::string why = put_targets(action.targets, tasks); !why.empty()) {
    deed.effects.emplace_back(Anomaly{
        "mission " + skein::to_text(mission.id) + " of " + action.uav + " is not sent: " + why,
        deed.asked_by});
    return;
  }
  deed.issue(action.uav, std::move(mission));
}

void MissionPlanning::perform(const SendGlobalMission& action, const Deed& deed) {
  team::GlobalMission mission = action.mission;
  if (mission.asked_by.empty()) mission.asked_by = deed.asked_by;
  std::vector<mission::HighLevelTask*> tasks;
  for (team::GlobalTask& task : mission.tasks) tasks.push_back(&task.task);
  if (const std::string why = put_targets(action.targets, tasks); !why.empty()) {
    deed.effects.emplace_back(Anomaly{
        "global mission " + skein::to_text(mission.id) + " is not given: " + why, deed.asked_by});
    return;
  }
  for (const ArgumentTarget& target : action.targets) {
    team::GlobalTask& task = mission.tasks[target.task];
    const auto& at = std::get<world::Vector3>(task.task.arguments[target.argument]);
    task.at = {at.x(), at.y()};
  }
  deed.effects.emplace_back(GiveGlobalMission{std::move(mission)});
}

template <class Declared>
void MissionPlanning::perform(const Declared& action, const Deed& deed) {
  deed.effects.emplace_back(action);
}
template void MissionPlanning::perform(const DeclareLost& action, const Deed& deed);
template void MissionPlanning::perform(const DeclareFound& action, const Deed& deed);

void MissionPlanning::perform(const PlayRole& action, const Deed& deed) {
  PlayRole play = action;
  if (play.asked_by.empty()) play.asked_by = deed.asked_by;
  deed.effects.emplace_back(std::move(play));
}

std::string MissionPlanning::put_targets(const std::vector<ArgumentTarget>& targets,
                                         const std::vector<mission::HighLevelTask*>& tasks) const {
  for (const ArgumentTarget& target : targets) {
    const Target where{
        std::visit([](const auto& it) -> decltype(Target::where) { return it; }, target.where), ""};
    const auto points = resolve(where, subject(), terrain_);
    if (!points) return points.error().why;
    const bool is_there =
        target.task < tasks.size() && target.argument < tasks[target.task]->arguments.size();
    if (!is_there) return "a target is for no argument";
    tasks[target.task]->arguments[target.argument] = points->front();
  }
  return "";
}

void MissionPlanning::perform(const CancelMission& action, const Deed& deed) {
  deed.issue(action.uav, action.cancel);
}

void MissionPlanning::perform(const SetDegree& action, const Deed& deed) {
  deed.issue(action.uav, action.change);
}

void MissionPlanning::perform(const TakeInHand& action, const Deed& deed) {
  deed.effects.emplace_back(ChangeHands{action.uav, ChangeHands::Way::kTake, action.interrupt,
                                        deed.expires, deed.asked_by});
}

void MissionPlanning::perform(const GiveBack& action, const Deed& deed) {
  deed.effects.emplace_back(
      ChangeHands{action.uav, ChangeHands::Way::kGiveBack, false, deed.expires, deed.asked_by});
}

void MissionPlanning::perform(const ResumePlan& action, const Deed& deed) {
  deed.effects.emplace_back(ResumeHeld{action.uav, action.without, deed.expires, deed.asked_by});
}

void MissionPlanning::perform(const DropPlan& action, const Deed& deed) {
  deed.effects.emplace_back(DropHeld{action.uav});
}

void MissionPlanning::Deed::tell(const mission::ChangeWorld& change,
                                 const std::vector<std::string>& uavs) const {
  for (const std::string& uav : uavs) issue(uav, change);
  if (uavs.empty()) effects.emplace_back(IssueToAll{change, expires, asked_by});
}

void MissionPlanning::perform(const CloseAir& action, const Deed& deed) {
  mission::ChangeWorld change;
  change.volume = action.volume;
  deed.tell(change, action.uavs);
}

void MissionPlanning::perform(const OpenAir& action, const Deed& deed) {
  mission::ChangeWorld change;
  change.volume.name = action.name;
  change.remove = true;
  deed.tell(change, action.uavs);
}

void MissionPlanning::perform(const TellWorld& action, const Deed& deed) {
  deed.tell(action.change, action.uavs);
}

void MissionPlanning::perform(const Finish&, const Deed& deed) {
  finished_ = true;
  deed.effects.emplace_back(MissionFinished{});
}

}  // namespace skein::ground_station
