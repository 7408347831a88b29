// SPDX-License-Identifier: Apache-2.0
// What the ground can know to be wrong with a request before it is sent.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/ground_orders/messages.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::ground_station {

/// What missions are checked against.
struct MissionKnowledge {
  /// Of the planning domain that the UAVs have. Absent: what a mission says is not checked here.
  std::optional<mission::Vocabulary> vocabulary = std::nullopt;
  std::vector<std::string> places = {}, zones = {};
  /// By UAV; the devices of one that is not here are not checked.
  std::map<std::string, world::VehicleModel> vehicles = {};
  /// Joint tasks and the versions of their interaction models that the ground has.
  ModelVersions joint_tasks = {};
  /// Of these, those of whose roles the ground station may play some.
  std::set<std::string> by_ground = {};
};

/// Another UAV, as the board has it.
struct Teammate {
  Degree degree = 3;
  ModelVersions models = {};  ///< that it told to have; none: it told nothing yet
};

/// The request's addressee, as the board has it.
struct Addressee {
  std::string name;
  Degree degree = 3;
  const std::vector<mission::GoalStatus>& goals;
  std::map<std::string, Teammate> team = {};  ///< it is among them; empty: nothing is known
};

/// Refuses at the ground what no UAV could accept, so that an operator has every reason at once and
/// a UAV's plan stays untouched. A value; not safe to share between threads while it is assigned.
class MissionChecks {
 public:
  MissionChecks() = default;
  MissionChecks(MissionKnowledge knowledge, std::vector<std::string> team)
      : knowledge_(std::move(knowledge)), team_(std::move(team)) {}

  void know_place(const std::string& name) {
    auto& places = knowledge_.places;
    if (std::find(places.begin(), places.end(), name) == places.end()) places.push_back(name);
  }

  /// Every reason why the request makes no sense, in sentences; empty when it may be sent. Requests
  /// to an MLE are its own business. Source: spec 1.2, 6.2.
  std::vector<std::string> problems_of(const Request& request, const Addressee& to,
                                       MissionTime now) const;
  /// Likewise, of a joint task in which the ground is to play the role of `to`.
  std::vector<std::string> problems_of(const mission::HighLevelTask& played, const Addressee& to,
                                       MissionTime now) const;

 private:
  std::vector<std::string> problems(const mission::UnitMission& mission, const Addressee& to,
                                    MissionTime now) const;
  std::vector<std::string> statement_problems(const mission::UnitMission& mission,
                                              const Addressee& to, MissionTime now) const;
  std::vector<std::string> joint_problems(const mission::HighLevelTask& task,
                                          const Addressee& to) const;

  MissionKnowledge knowledge_;
  std::vector<std::string> team_;
};

}  // namespace skein::ground_station
