// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/mission_progress.hpp"

#include <map>
#include <utility>

namespace skein::ground_station {

using mission::GoalState;
using mission::GoalStatus;
using mission::MissionId;

namespace {

/// Missions that are over, and how.
std::vector<std::pair<MissionId, MissionStage>> ends_in(const std::vector<GoalStatus>& goals) {
  struct Count {
    bool open = false, achieved = false, failed = false;
  };
  std::map<MissionId, Count> missions;
  for (const GoalStatus& goal : goals) {
    Count& count = missions[goal.mission];
    count.open = count.open || !mission::is_settled(goal.state);
    count.achieved = count.achieved || goal.state == GoalState::kAchieved;
    count.failed = count.failed || goal.state == GoalState::kFailed;
  }
  std::vector<std::pair<MissionId, MissionStage>> ends;
  for (const auto& [mission, count] : missions) {
    if (count.open || !(count.failed || count.achieved)) continue;
    ends.emplace_back(mission, count.failed ? MissionStage::kFailed : MissionStage::kAchieved);
  }
  return ends;
}

}  // namespace

// Plans and hand-overs come by different ways: the one that tells of a later instant counts.
std::vector<MissionProgress::Change> MissionProgress::take(const std::string& uav,
                                                           std::vector<GoalStatus>& goals,
                                                           const std::vector<GoalStatus>& told,
                                                           std::optional<MissionTime> at) {
  if (at && at_ && *at < *at_) return {};
  if (at) at_ = at;
  std::map<mission::GoalId, GoalState> before;
  for (const GoalStatus& goal : goals) before[goal.id] = goal.state;
  goals = told;
  std::vector<Change> changes;
  for (const GoalStatus& goal : goals) {
    const auto known = before.find(goal.id);
    if (known != before.end() && known->second == goal.state) continue;
    changes.emplace_back(GoalChanged{uav, goal.id, goal.state});
  }
  for (const auto& [mission, end] : ends_in(goals)) {
    if (auto change = stage(uav, mission, end)) changes.emplace_back(std::move(*change));
  }
  return changes;
}

std::optional<MissionChanged> MissionProgress::stage(const std::string& uav, MissionId mission,
                                                     MissionStage stage) {
  const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(stage));
  const std::uint8_t told = told_.of(mission.value());
  if ((told & bit) != 0) return std::nullopt;
  told_.set(mission.value(), told | bit);
  return MissionChanged{uav, mission, stage};
}

}  // namespace skein::ground_station
