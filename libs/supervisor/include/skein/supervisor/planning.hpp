// SPDX-License-Identifier: Apache-2.0
// Operator 3: planner and refiners together make elementary tasks of high-level ones.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/mission/progress.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/world/world.hpp"

namespace skein::supervisor {

/// Tasks that a supervisor gives itself, where the domain declares them: to come down, and to leave
/// air that was closed around the UAV. The second comes first in every order.
inline constexpr std::string_view kComeDown = "general-land";
inline constexpr std::string_view kLeaveClosedAir = "leave-closed-air";

/// What looks over a zone for a time, by a patrol that has it in view for so long in all.
inline constexpr std::string_view kDetection = "perform-detection";

/// What a domain that has both may do in two parts, with other tasks between them: the mapping of a
/// zone; and the first of its parts, with the zone, the share of the lanes (0 to 1) and the number
/// of the mapping, which flies the others when its turn comes.
inline constexpr std::string_view kMapping = "perform-mapping";
inline constexpr std::string_view kMapPart = "map-part";
/// The mapping that a task is a part of; nothing of other tasks.
std::optional<mission::GoalId> whole_of(const mission::HighLevelTask& task);
/// The share of the lanes that a part of a mapping is to fly; nothing of other tasks.
std::optional<double> share_of(const mission::HighLevelTask& task);

/// A planning domain as text (docs/comets-domain.md).
struct DomainText {
  std::string file;  ///< name for messages
  std::string text;
};

/// What is known of another of the team from the start, whatever has become of it.
struct Partner {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector3 home = world::Vector3::Zero();  ///< [m] ENU, on ground
  double altitude = 40;                          ///< of its flights, over the ground [m]
};

/// What deliberation knows all along a mission. Immutable; shared by jobs.
struct Knowledge {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector3 home =
      world::Vector3::Zero();     ///< where it takes off and lands [m] ENU, on ground
  double altitude = 40;           ///< of flights, over the ground, where nothing else is asked [m]
  std::vector<std::string> team;  ///< names of all UAVs, this one too
  std::vector<Partner> partners;  ///< of the team; who is not here is taken to be like this UAV
  DomainText domain;
  mission::Vocabulary vocabulary;
};

/// The tasks that the domain declares, or every error of the domain: text, unknown functions,
/// declarations of unknown kinds.
Result<mission::Vocabulary, Diagnostics> vocabulary_of(const DomainText& domain);

/// When a resource is free, and after what. Source: spec 3.3.
struct Timeline {
  mission::Interval free;                    ///< relative to Situation::origin
  std::optional<mission::Dependence> after;  ///< absent: nothing is to be waited for
  bool operator==(const Timeline&) const = default;
};

/// The state that a plan starts from: where the UAV will be when what it has in hand is over.
struct Situation {
  MissionTime origin;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
  double heading = 0;                                ///< [rad]
  bool airborne = false;
  /// It is flying there now, with that heading, and flies on until the plan begins: it does not
  /// wait or circle there.
  bool flies_on = false;
  /// It stands there now; else a landing that is to come brings it there, near enough.
  bool stands = false;
  double energy = 1;                      ///< what will be left, [0, 1]
  std::optional<world::Vector3> land_at;  ///< on the ground [m] ENU; absent: at home
  Timeline motion;
  /// What runs along with that motion, or still runs after it: the next motion waits for it too.
  std::vector<Timeline> riders;
  std::map<std::string, Timeline> devices;  ///< those that are not here are free at once
  std::set<std::string> broken;             ///< devices that do not work
  executive::TaskId next_id{1};             ///< elementary tasks are numbered from here
  /// Of high-level tasks that were interrupted: what need not be done again.
  std::map<mission::GoalId, mission::Progress> done;
};

/// How much may be spent on one plan. Counts give the same answer everywhere; the clock is filled
/// by who runs the job. A value type.
struct PlanningBudget {
  std::uint64_t expansions = 200'000;
  std::uint64_t inferences = 20'000'000;
  std::uint64_t memory_bytes = std::uint64_t{1} << 30U;  ///< of the search's own structures
  /// True once the time is up, or nobody wants the plan any more. May be empty: never.
  std::function<bool()> time_is_up;

  bool over() const { return time_is_up && time_is_up(); }
};

struct PlanningRequest {
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  Situation situation;
  std::vector<mission::HighLevelTask> tasks;  ///< in order
  std::uint64_t seed = 1;
  PlanningBudget budget = {};
};

struct PlanningFailure {
  std::optional<mission::GoalId> culprit;  ///< the high-level task that could not be refined
  std::vector<std::string> reasons;        ///< all that is known: conditions, refusals of refiners
  bool operator==(const PlanningFailure&) const = default;
};

/// Figures of one planning, for measurements.
struct PlanningEffort {
  std::uint64_t expansions = 0, inferences = 0;
  std::uint64_t refinements = 0;  ///< calls of refiners that were not known from before
  bool operator==(const PlanningEffort&) const = default;
};

/// A plan whose every task has its duration, way and conditions; not yet checked as a network
/// (schedule.hpp). Deterministic; a job: it touches nothing shared but what the request points to.
/// Cost: some milliseconds and what the refiners take. Source: T IV.2, IV.4.2 (SCD-3), spec 3.3 to
/// 3.5.
Result<mission::ElementaryPlan, PlanningFailure> plan_tasks(const PlanningRequest& request,
                                                            PlanningEffort* effort = nullptr);

}  // namespace skein::supervisor
