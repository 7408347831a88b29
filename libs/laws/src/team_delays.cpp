// SPDX-License-Identifier: Apache-2.0
// The time between tasks of a team that are to follow each other within bounds.
#include <algorithm>
#include <map>
#include <optional>

#include "checks.hpp"
#include "scripted.hpp"

namespace skein::laws {

namespace {

/// Between the clocks of two nodes, and until an executive says what it has started [s].
constexpr double kMoment = 0.6;

struct Wanted {
  std::int64_t first = 0, then = 0;
  double least = 0, most = kNever;
};

std::vector<Wanted> wanted_by(const scenario::Scenario& scenario) {
  std::vector<Wanted> all;
  for_scripted<ground_station::SendGlobalMission>(scenario, [&](const auto& send) {
    for (const team::GlobalTask& task : send.mission.tasks) {
      for (const mission::GoalBound& bound : task.task.after) {
        all.push_back({static_cast<std::int64_t>(bound.goal.value()),
                       static_cast<std::int64_t>(task.task.id.value()), bound.least.to_seconds(),
                       bound.most == Duration::max() ? kNever : bound.most.to_seconds()});
      }
    }
  });
  return all;
}

// When all its owners under one sale had done it; several, if it was done again.
std::vector<double> ends_of(const TeamTask& task) {
  std::map<std::int64_t, double> ends;
  for (const TeamWork& work : task.works) {
    double& end = ends[work.sale];
    end = std::max(end, work.end == "done" ? work.over : kNever);
  }
  std::vector<double> all;
  for (const auto& [sale, end] : ends)
    if (end < kNever) all.push_back(end);
  return all;
}

// What it says of its work is lost with it.
bool somebody_was_killed(const History& history, const TeamTask& task) {
  return std::any_of(task.works.begin(), task.works.end(),
                     [&](const TeamWork& work) { return history.was_killed(work.uav); });
}

bool in_time(const Wanted& wanted, const std::vector<double>& ends, double started, bool done) {
  return std::any_of(ends.begin(), ends.end(), [&](double end) {
    const double after = started - end;
    return after >= wanted.least - kMoment && (!done || after <= wanted.most + kMoment);
  });
}

std::string told(const Wanted& wanted, const Execution& task, const std::vector<double>& ends) {
  const std::string what = task.type + " of task " + std::to_string(wanted.then) + " began ";
  const std::string first = "task " + std::to_string(wanted.first);
  if (ends.empty()) return what + "although " + first + " is not done";
  return what + figure(task.started - ends.back()) + " s after " + first + ", not " +
         figure(wanted.least) +
         (wanted.most == kNever ? " s or more" : " to " + figure(wanted.most) + " s");
}

}  // namespace

// Each part of the other begins within the bounds after the end of the first; of what was put back,
// no part sooner.
std::vector<Violation> team_delays_not_kept(const History& history) {
  std::vector<Violation> result;
  for (const Wanted& wanted : wanted_by(*history.scenario)) {
    const auto first = history.team.tasks.find(wanted.first);
    const auto then = history.team.tasks.find(wanted.then);
    if (first == history.team.tasks.end() || then == history.team.tasks.end()) continue;
    const std::vector<double> ends = ends_of(first->second);
    if (ends.empty() && somebody_was_killed(history, first->second)) continue;
    for (const TeamWork& work : then->second.works) {
      const auto uav = history.uavs.find(work.uav);
      if (uav == history.uavs.end()) continue;
      for (const auto& [id, task] : uav->second.executions) {
        if (uav->second.goal_of_task(id) != work.goal || task.started == kNever) continue;
        if (task.type == "takeshot") continue;  // rides along with a task whose times are judged
        if (in_time(wanted, ends, task.started, work.end == "done")) continue;
        result.push_back({"", task.started, work.uav, work.goal, told(wanted, task, ends)});
      }
    }
  }
  return result;
}

}  // namespace skein::laws
