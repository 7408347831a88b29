// SPDX-License-Identifier: Apache-2.0
// What each scripted action asks of the other components.
#include "script_actions.hpp"

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

void ScriptActions::issue(const std::string& uav, Request request) {
  effects_.emplace_back(IssueCommand{uav, std::move(request), of_.expires, of_.asked_by});
}

void ScriptActions::on(const SendPlan& plan) {
  for (const PlannedTask& planned : plan.tasks) {
    executive::Start start{planned.task, planned.mode};
    std::string problem;
    for (const Target& target : planned.targets) {
      const auto points = resolve(target, of_.subject, of_.terrain);
      if (points) {
        start.task.parameters.add(parameter_of(target.parameter, *points));
      } else {
        problem = points.error().why;
      }
    }
    if (problem.empty()) {
      issue(plan.uav, std::move(start));
    } else {
      effects_.emplace_back(Anomaly{"task " + skein::to_text(planned.task.id) + " of " + plan.uav +
                                        " is not sent: " + problem,
                                    of_.asked_by});
    }
  }
}

void ScriptActions::on(const AbortTasks& action) {
  if (!action.tasks) {
    effects_.emplace_back(AbortEverything{action.uav, of_.expires, of_.asked_by});
    return;
  }
  for (const executive::TaskId id : *action.tasks) issue(action.uav, executive::Abort{id});
}

void ScriptActions::on(const SendMessage& action) {
  issue(action.uav, executive::ProcessMessage{action.text});
}

void ScriptActions::on(const UpdateConditions& action) { issue(action.uav, action.update); }

void ScriptActions::on(const SendMission& action) {
  mission::UnitMission mission = action.mission;
  if (mission.asked_by.empty()) mission.asked_by = of_.asked_by;
  std::vector<mission::HighLevelTask*> tasks;
  for (mission::HighLevelTask& task : mission.tasks) tasks.push_back(&task);
  if (const std::string why = put_targets(action.targets, tasks); !why.empty()) {
    effects_.emplace_back(Anomaly{
        "mission " + skein::to_text(mission.id) + " of " + action.uav + " is not sent: " + why,
        of_.asked_by});
    return;
  }
  issue(action.uav, std::move(mission));
}

void ScriptActions::on(const SendGlobalMission& action) {
  team::GlobalMission mission = action.mission;
  if (mission.asked_by.empty()) mission.asked_by = of_.asked_by;
  std::vector<mission::HighLevelTask*> tasks;
  for (team::GlobalTask& task : mission.tasks) tasks.push_back(&task.task);
  if (const std::string why = put_targets(action.targets, tasks); !why.empty()) {
    effects_.emplace_back(Anomaly{
        "global mission " + skein::to_text(mission.id) + " is not given: " + why, of_.asked_by});
    return;
  }
  for (const ArgumentTarget& target : action.targets) {
    team::GlobalTask& task = mission.tasks[target.task];
    const auto& at = std::get<world::Vector3>(task.task.arguments[target.argument]);
    task.at = {at.x(), at.y()};
  }
  effects_.emplace_back(GiveGlobalMission{std::move(mission)});
}

void ScriptActions::on(const PlayRole& action) {
  PlayRole play = action;
  if (play.asked_by.empty()) play.asked_by = of_.asked_by;
  effects_.emplace_back(std::move(play));
}

std::string ScriptActions::put_targets(const std::vector<ArgumentTarget>& targets,
                                       const std::vector<mission::HighLevelTask*>& tasks) const {
  for (const ArgumentTarget& target : targets) {
    const Target where{
        std::visit([](const auto& it) -> decltype(Target::where) { return it; }, target.where), ""};
    const auto points = resolve(where, of_.subject, of_.terrain);
    if (!points) return points.error().why;
    const bool is_there =
        target.task < tasks.size() && target.argument < tasks[target.task]->arguments.size();
    if (!is_there) return "a target is for no argument";
    tasks[target.task]->arguments[target.argument] = points->front();
  }
  return "";
}

void ScriptActions::on(const CancelMission& action) { issue(action.uav, action.cancel); }

void ScriptActions::on(const SetDegree& action) { issue(action.uav, action.change); }

void ScriptActions::on(const TakeInHand& action) {
  effects_.emplace_back(ChangeHands{action.uav, ChangeHands::Way::kTake, action.interrupt,
                                    of_.expires, of_.asked_by});
}

void ScriptActions::on(const GiveBack& action) {
  effects_.emplace_back(
      ChangeHands{action.uav, ChangeHands::Way::kGiveBack, false, of_.expires, of_.asked_by});
}

void ScriptActions::on(const ResumePlan& action) {
  effects_.emplace_back(ResumeHeld{action.uav, action.without, of_.expires, of_.asked_by});
}

void ScriptActions::on(const DropPlan& action) { effects_.emplace_back(DropHeld{action.uav}); }

void ScriptActions::tell(const mission::ChangeWorld& change, const std::vector<std::string>& uavs) {
  for (const std::string& uav : uavs) issue(uav, change);
  if (uavs.empty()) effects_.emplace_back(IssueToAll{change, of_.expires, of_.asked_by});
}

void ScriptActions::on(const CloseAir& action) {
  mission::ChangeWorld change;
  change.volume = action.volume;
  tell(change, action.uavs);
}

void ScriptActions::on(const OpenAir& action) {
  mission::ChangeWorld change;
  change.volume.name = action.name;
  change.remove = true;
  tell(change, action.uavs);
}

void ScriptActions::on(const TellWorld& action) { tell(action.change, action.uavs); }

void ScriptActions::on(const Finish&) {
  finished_ = true;
  effects_.emplace_back(MissionFinished{});
}

}  // namespace skein::ground_station
