// SPDX-License-Identifier: Apache-2.0
#include "skein/team/global_mission.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/mission/alarm_name.hpp"
#include "skein/team/conflicts.hpp"

namespace skein::team {

namespace {

auction::TaskNumber number_of(mission::GoalId id) {
  return auction::TaskNumber(static_cast<std::uint32_t>(id.value()));
}

double duration_of(const mission::HighLevelTask& task, const mission::Vocabulary& vocabulary) {
  const auto signature = vocabulary.tasks.find(task.name);
  if (signature == vocabulary.tasks.end()) return 0;
  const auto& kinds = signature->second.parameters;
  double seconds = 0;
  for (std::size_t i = 0; i < std::min(kinds.size(), task.arguments.size()); ++i) {
    const auto* number = std::get_if<double>(&task.arguments[i]);
    if (kinds[i] == mission::ParameterKind::kDuration && number != nullptr) seconds += *number;
  }
  return seconds;
}

auction::Task task_of(const GlobalTask& asked, const Roster& roster,
                      const mission::Vocabulary& vocabulary, const std::string& asked_by) {
  auction::Task task;
  task.number = number_of(asked.task.id);
  task.duration = duration_of(asked.task, vocabulary);
  task.least_members = asked.members;
  const mission::TimeConstraints& time = asked.task.time;
  if (time.start_after) task.earliest = std::max(0.0, time.start_after->to_seconds());
  if (time.end_before) task.deadline = time.end_before->to_seconds();
  if (time.start_before) {
    task.deadline = std::min(task.deadline, time.start_before->to_seconds() + task.duration);
  }
  task.at = asked.at;
  if (asked.by) task.pinned = roster.number_of(*asked.by);
  for (const std::string& uav : asked.not_by) {
    if (const auto number = roster.number_of(uav)) task.forbidden.insert(*number);
  }
  task.repeatable = asked.repeatable;
  task.work = std::make_shared<const Order>(asked.task, asked_by, asked.needs);
  return task;
}

bool names_members(const mission::HighLevelTask& task) {
  return std::any_of(task.arguments.begin(), task.arguments.end(), [](const auto& argument) {
    const auto* word = std::get_if<std::string>(&argument);
    return word != nullptr && *word == kMembers;
  });
}

// Whoever they will be.
mission::HighLevelTask for_some(const GlobalTask& task, const std::vector<std::string>& uavs) {
  const std::size_t count = std::min<std::size_t>(task.members, uavs.size());
  return for_members(task.task, {uavs.begin(), uavs.begin() + static_cast<std::ptrdiff_t>(count)});
}

std::string about(const GlobalTask& task) { return "task " + to_text(task.task.id) + ": "; }

void check_members(const GlobalTask& task, const Roster& roster,
                   const mission::Surroundings& around, std::vector<std::string>& problems) {
  const auto known = [&](const std::string& uav) {
    const bool flies = std::find(around.uavs.begin(), around.uavs.end(), uav) != around.uavs.end();
    return flies && roster.number_of(uav).has_value();
  };
  if (task.by && !known(*task.by)) problems.push_back(about(task) + "no UAV '" + *task.by + "'");
  for (const std::string& uav : task.not_by) {
    if (!known(uav)) problems.push_back(about(task) + "no UAV '" + uav + "'");
  }
  if (task.members == 0) problems.push_back(about(task) + "it has no members");
  if (task.members == 1 && names_members(task.task)) {
    problems.push_back(about(task) + "it is for several, and says 'members: 1'");
  }
  if (task.members > around.uavs.size()) {
    problems.push_back(about(task) + "it wants " + std::to_string(task.members) + " of " +
                       std::to_string(around.uavs.size()) + " UAVs");
  }
}

void check_order(const GlobalMission& mission, std::vector<std::string>& problems) {
  for (const GlobalTask& task : mission.tasks) {
    if (task.task.id.value() > std::numeric_limits<std::uint32_t>::max()) {
      problems.push_back(about(task) + "numbers end at 4294967295");
    }
    for (const mission::GoalId before : task.after) {
      const bool there = std::any_of(mission.tasks.begin(), mission.tasks.end(),
                                     [&](const auto& one) { return one.task.id == before; });
      if (!there) problems.push_back(about(task) + "task " + to_text(before) + " is not in it");
    }
    for (const mission::GoalBound& bound : task.task.after) {
      const bool before = std::count(task.after.begin(), task.after.end(), bound.goal) > 0;
      if (!before || bound.on_end)
        problems.push_back(about(task) +
                           "of another task it may bound its beginning, after the end");
    }
  }
}

}  // namespace

auction::Delay delay_after(auction::TaskNumber first, const mission::HighLevelTask& task) {
  auction::Delay delay;
  for (const mission::GoalBound& bound : task.after) {
    if (number_of(bound.goal) != first) continue;
    delay.least = std::max(delay.least, bound.least.to_seconds());
    if (bound.most < Duration::max()) delay.most = std::min(delay.most, bound.most.to_seconds());
  }
  return delay;
}

mission::HighLevelTask in_time(mission::HighLevelTask task, const auction::Task& granted) {
  if (task.after.empty()) return task;
  const auto bounds_above = [](const mission::GoalBound& bound) {
    return bound.most < Duration::max();
  };
  const bool above = std::any_of(task.after.begin(), task.after.end(), bounds_above);
  mission::TimeConstraints& time = task.time;
  const MissionTime from = MissionTime::seconds(granted.earliest);
  time.start_after = std::max(time.start_after.value_or(from), from);
  if (above && std::isfinite(granted.deadline)) {
    const MissionTime by = MissionTime::seconds(granted.deadline - granted.duration);
    time.start_before = std::min(time.start_before.value_or(by), by);
  }
  task.after.clear();
  return task;
}

const Order* order_of(const auction::Task& task) {
  return dynamic_cast<const Order*>(task.work.get());
}

mission::HighLevelTask for_members(mission::HighLevelTask task,
                                   const std::vector<std::string>& members) {
  for (mission::Argument& argument : task.arguments) {
    const auto* word = std::get_if<std::string>(&argument);
    if (word != nullptr && *word == kMembers) argument = members;
  }
  return task;
}

std::vector<std::string> alarms_in(const mission::HighLevelTask& task) {
  std::vector<std::string> alarms;
  const auto add = [&](const std::string& name) {
    if (mission::is_name_of_alarm(name)) alarms.push_back(name);
  };
  for (const mission::Argument& argument : task.arguments) {
    if (const auto* name = std::get_if<std::string>(&argument)) add(*name);
    if (const auto* names = std::get_if<std::vector<std::string>>(&argument))
      std::for_each(names->begin(), names->end(), add);
  }
  return alarms;
}

std::vector<std::string> problems_of(const GlobalMission& mission, const Roster& roster,
                                     const mission::Vocabulary& vocabulary,
                                     const mission::Surroundings& around, MissionTime now) {
  mission::UnitMission as_one;
  as_one.id = mission.id;
  mission::Surroundings places = around;
  places.vehicle = nullptr;
  for (const GlobalTask& task : mission.tasks) {
    as_one.tasks.push_back(for_some(task, around.uavs));
    for (std::string& alarm : alarms_in(task.task)) places.places.push_back(std::move(alarm));
  }
  std::vector<std::string> problems = mission::problems_of(as_one, vocabulary, places, now);
  for (const GlobalTask& task : mission.tasks) check_members(task, roster, around, problems);
  check_order(mission, problems);
  if (!problems.empty()) return problems;
  for (Conflict& one : conflicts_of(mission, roster, vocabulary, around.uavs, now))
    problems.push_back(std::move(one.sentence));
  return problems;
}

auction::GivenMission given(const GlobalMission& mission, const Roster& roster,
                            const mission::Vocabulary& vocabulary) {
  auction::GivenMission result{auction::MissionNumber(mission.id.value()), {}};
  for (const GlobalTask& task : mission.tasks) {
    result.lot.tasks.push_back(task_of(task, roster, vocabulary, mission.asked_by));
    for (const mission::GoalId before : task.after) {
      const auction::TaskNumber first = number_of(before);
      result.lot.precedences.push_back(
          {first, number_of(task.task.id), delay_after(first, task.task)});
    }
  }
  return result;
}

}  // namespace skein::team
