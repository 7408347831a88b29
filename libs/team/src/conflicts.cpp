// SPDX-License-Identifier: Apache-2.0
#include "skein/team/conflicts.hpp"

#include <algorithm>

#include "skein/auction/member_conflicts.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::team {

namespace {

/// "tasks 21, 22, 21: each is to end before the next begins".
Conflict conflict_of(const std::vector<auction::TaskNumber>& numbers, const std::string& why) {
  std::vector<std::string> tasks;
  for (const auction::TaskNumber task : numbers) tasks.push_back(to_text(task));
  return {mission::GoalId(numbers.back().value()),
          (tasks.size() == 1 ? "task " : "tasks ") + joined(tasks, ", ") + ": " + why};
}

/// With the bounds that count only here: see decision 76.
auction::Lot lot_of(const GlobalMission& mission, const Roster& roster,
                    const mission::Vocabulary& vocabulary, MissionTime now) {
  auction::Lot lot = given(mission, roster, vocabulary).lot;
  for (std::size_t i = 0; i < lot.tasks.size(); ++i) {
    auction::Task& task = lot.tasks[i];
    task.earliest = std::max(task.earliest, now.to_seconds());
    // It may last longer than it must, so with a bound on its start this says nothing of its end.
    const mission::TimeConstraints& time = mission.tasks[i].task.time;
    if (time.end_after && !time.start_before)
      task.earliest = std::max(task.earliest, time.end_after->to_seconds() - task.duration);
  }
  return lot;
}

}  // namespace

std::vector<Conflict> conflicts_of(const GlobalMission& mission, const Roster& roster,
                                   const mission::Vocabulary& vocabulary,
                                   const std::vector<std::string>& uavs, MissionTime now) {
  std::set<auction::MemberNumber> members;
  for (const std::string& uav : uavs) {
    if (const auto number = roster.number_of(uav)) members.insert(*number);
  }
  const auction::Lot lot = lot_of(mission, roster, vocabulary, now);
  std::vector<Conflict> conflicts;
  for (const auction::Contradiction& one : auction::contradictions(lot))
    conflicts.push_back(conflict_of(one.chain, one.why));
  for (const auction::MemberConflict& one : auction::member_conflicts(lot, members)) {
    const std::string all = one.tasks.size() == 2 ? "both" : "all";
    const std::string need =
        one.member ? all + " need " + roster.name_of(*one.member) + ", and " : std::string();
    conflicts.push_back(conflict_of(one.tasks, need + one.why));
  }
  return conflicts;
}

}  // namespace skein::team
