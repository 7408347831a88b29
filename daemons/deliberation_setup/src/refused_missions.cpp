// SPDX-License-Identifier: Apache-2.0
#include "skein/deliberation_setup/refused_missions.hpp"

#include <set>
#include <string>
#include <variant>

#include "script_actions.hpp"
#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/mission/alarm_name.hpp"
#include "skein/mission/degree.hpp"
#include "skein/supervisor/domain_warnings.hpp"

namespace skein::deliberation_setup {

namespace {

using ground_station::SendMission;
using scenario::Scenario;
using scenario::UavSpec;

/// Looks at missions one by one. Refers to the scenario.
class Foreseeing {
 public:
  Foreseeing(const Scenario& scenario, mission::Vocabulary vocabulary)
      : scenario_(scenario), vocabulary_(std::move(vocabulary)) {
    for (const auto& [name, place] : scenario.world.places) around_.places.push_back(name);
    for (const world::Zone& zone : scenario.world.zones) around_.zones.push_back(zone.name);
    around_.uavs = scenario.uav_names();
  }

  /// A degree that is changed, or a place that is told of, may make a later mission valid.
  void learn(const ground_station::Action& action) {
    if (const auto* change = std::get_if<ground_station::SetDegree>(&action))
      changed_.insert(change->uav);
    if (const auto* told = std::get_if<ground_station::TellWorld>(&action);
        told != nullptr && told->change.place)
      around_.places.push_back(told->change.place->name);
  }

  void check(const ground_station::Action& action, MissionTime begin) {
    const auto* sent = std::get_if<SendMission>(&action);
    if (sent == nullptr) return;
    const UavSpec* uav = scenario_.find_uav(sent->uav);
    if (uav == nullptr) return;
    around_.vehicle = &uav->model;
    const std::vector<mission::HighLevelTask>& tasks = sent->mission.tasks;
    const mission::GoalId first = tasks.empty() ? mission::GoalId() : tasks.front().id;
    if (tasks.empty()) say(*sent, first, "the mission has no tasks");
    if (!mission::deliberates(uav->degree) && !changed_.contains(uav->name)) {
      say(*sent, first,
          uav->name + " is at degree " + std::to_string(uav->degree) +
              ": missions are planned at degree 4");
    }
    for (const mission::HighLevelTask& task : tasks) check(*sent, task, begin);
  }

  Diagnostics take() { return std::move(found_); }

 private:
  void check(const SendMission& sent, mission::HighLevelTask task, MissionTime begin) {
    mission::UnitMission alone = sent.mission;
    mission::Surroundings around = around_;
    for (const mission::Argument& argument : task.arguments) {
      const auto* name = std::get_if<std::string>(&argument);
      if (name != nullptr && mission::is_name_of_alarm(*name)) around.places.push_back(*name);
    }
    alone.tasks = {std::move(task)};
    for (const std::string& problem : mission::problems_of(alone, vocabulary_, around, begin)) {
      say(sent, alone.tasks.front().id, problem);
    }
  }

  void say(const SendMission& sent, mission::GoalId task, const std::string& why) {
    world::Mark mark{0, "ground.script"};
    const auto known = scenario_.ground.asked.find({sent.uav, task});
    if (known != scenario_.ground.asked.end()) mark = known->second;
    found_.add(
        {scenario_.file, mark.line, 0, mark.path,
         "mission " + to_text(sent.mission.id) + " to " + sent.uav + " will be refused: " + why, "",
         ""});
  }

  const Scenario& scenario_;
  mission::Vocabulary vocabulary_;
  mission::Surroundings around_;
  std::set<std::string> changed_;
  Diagnostics found_;
};

}  // namespace

Diagnostics refused_missions(const Scenario& scenario) {
  if (!scenario.planning) return {};
  auto vocabulary = vocabulary_of(scenario);
  if (!vocabulary) return {};
  Foreseeing foreseeing(scenario, std::move(*vocabulary));
  const ground_station::Script& script = scenario.ground.script;
  for_each_action(script, [&](const auto& action, MissionTime) { foreseeing.learn(action); });
  for_each_action(script,
                  [&](const auto& action, MissionTime begin) { foreseeing.check(action, begin); });
  return foreseeing.take();
}

Diagnostics domain_warnings(const Scenario& scenario) {
  if (!scenario.planning) return {};
  return supervisor::warnings_of({scenario.planning->domain_path, scenario.planning->domain});
}

}  // namespace skein::deliberation_setup
