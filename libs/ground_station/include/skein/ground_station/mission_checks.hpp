// SPDX-License-Identifier: Apache-2.0
// Checks of requests at the ground, before they are sent.
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

/// The data that missions are checked against.
struct MissionKnowledge {
  /// Vocabulary of the UAVs' planning domain. Absent: the statements of missions are not checked.
  std::optional<mission::Vocabulary> vocabulary = std::nullopt;
  std::vector<std::string> places = {}, zones = {};
  /// By UAV; the devices of a UAV without an entry are not checked.
  std::map<std::string, world::VehicleModel> vehicles = {};
  /// Types of joint tasks, and the versions of their interaction models that the ground has.
  ModelVersions joint_tasks = {};
  /// Types of joint tasks with roles that the ground station may play.
  std::set<std::string> by_ground = {};
};

/// A UAV of the team, as the board has it.
struct Teammate {
  Degree degree = 3;
  ModelVersions models = {};  ///< that it reported to have; empty: no report yet
};

/// The request's addressee, as the board has it.
struct Addressee {
  std::string name;
  Degree degree = 3;
  const std::vector<mission::GoalStatus>& goals;
  std::map<std::string, Teammate> team = {};  ///< including the addressee; empty: unknown
};

/// Finds the requests that no UAV could accept, so that an operator gets every reason at once and
/// the UAV's plan stays untouched. A value; not safe to share between threads while it is assigned.
class MissionChecks {
 public:
  MissionChecks() = default;
  MissionChecks(MissionKnowledge knowledge, std::vector<std::string> team)
      : knowledge_(std::move(knowledge)), team_(std::move(team)) {}

  void know_place(const std::string& name) {
    auto& places = knowledge_.places;
    if (std::find(places.begin(), places.end(), name) == places.end()) places.push_back(name);
  }

  /// Every reason why the request is invalid, in sentences; empty: it may be sent. Requests to an
  /// MLE are left to that MLE. Source: spec 1.2, 6.2.
  std::vector<std::string> problems_of(const Request& request, const Addressee& to,
                                       MissionTime now) const;
  /// The same for a joint task in which the ground is to play the role of `to`.
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
