// SPDX-License-Identifier: Apache-2.0
// Operator 3: planner and refiners together decompose high-level tasks into elementary tasks.
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
#include "skein/foundation/shared_list.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/mission/progress.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/world/world.hpp"

namespace skein::supervisor {

/// High-level tasks that the supervisor adds by itself if the domain declares them: to land, and to
/// leave air that was closed around the UAV. kLeaveClosedAir comes first in every order.
inline constexpr std::string_view kComeDown = "general-land";
inline constexpr std::string_view kLeaveClosedAir = "leave-closed-air";

/// The detection task: a patrol that has a zone in view for a given total time.
inline constexpr std::string_view kDetection = "perform-detection";

/// A domain that declares both may fly a mapping in two parts, with other tasks between them:
/// kMapPart is the first part. Its arguments are the zone, the share of the lanes (0 to 1) and the
/// id of the mapping, which flies the remaining lanes when its turn comes.
inline constexpr std::string_view kMapping = "perform-mapping";
inline constexpr std::string_view kMapPart = "map-part";
/// The mapping that a kMapPart belongs to; absent for other tasks.
std::optional<mission::GoalId> whole_of(const mission::HighLevelTask& task);
/// The share of the lanes that a kMapPart is to fly; absent for other tasks.
std::optional<double> share_of(const mission::HighLevelTask& task);

/// A planning domain as text (docs/comets-domain.md).
struct DomainText {
  std::string file;  ///< name for messages
  std::string text;
};

/// Static data of a UAV of the team.
struct Partner {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector3 home = world::Vector3::Zero();  ///< [m] ENU, on ground
  double altitude = 40;                          ///< usual flight altitude over the ground [m]
};

/// What deliberation knows throughout a mission. Immutable; shared by jobs.
struct Knowledge {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector3 home =
      world::Vector3::Zero();    ///< where the UAV takes off and lands [m] ENU, on ground
  double altitude = 40;          ///< usual flight altitude over the ground [m]
  SharedList<std::string> team;  ///< names of all UAVs, including this one
  SharedList<Partner> partners;  ///< a UAV of the team without an entry is taken to be like this
  DomainText domain;
  mission::Vocabulary vocabulary;
};

/// The high-level tasks that the domain declares, or every error of the domain: syntax, unknown
/// functions, declarations of unknown kinds.
Result<mission::Vocabulary, Diagnostics> vocabulary_of(const DomainText& domain);

/// From when on a resource (the vehicle's motion, a device) is free. Source: spec 3.3.
struct Timeline {
  mission::Interval free;                    ///< relative to Situation::origin
  std::optional<mission::Dependence> after;  ///< its last user; absent: there is none to wait for
  bool operator==(const Timeline&) const = default;
};

/// The initial state of a plan: that of the UAV when the tasks that its executive keeps are over.
struct Situation {
  MissionTime origin;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
  double heading = 0;                                ///< [rad]
  bool airborne = false;
  /// The UAV is passing `position` now, with that heading, and does not hover or circle there
  /// before the plan begins.
  bool flies_on = false;
  /// The UAV stands at `position` now; otherwise, if it is not airborne, a landing to come ends
  /// near it.
  bool stands = false;
  double energy = 1;                      ///< expected remaining energy then, fraction in [0, 1]
  std::optional<world::Vector3> land_at;  ///< on the ground [m] ENU; absent: at home
  Timeline motion;
  /// Tasks that run along with that motion, or still run after it: the next motion waits for them,
  /// too.
  std::vector<Timeline> riders;
  std::map<std::string, Timeline> devices;  ///< devices without an entry are free at once
  std::set<std::string> broken;             ///< devices that do not work
  executive::TaskId next_id{1};             ///< elementary tasks are numbered from here
  /// Progress of interrupted high-level tasks, which is not planned again.
  std::map<mission::GoalId, mission::Progress> done;
};

/// Limits of the search for one plan. The counts are reproducible on every machine; `time_is_up` is
/// set by the host that runs the job. A value type.
struct PlanningBudget {
  std::uint64_t expansions = 200'000;
  std::uint64_t inferences = 20'000'000;
  std::uint64_t memory_bytes = std::uint64_t{1} << 30U;  ///< of the search's own data structures
  /// Returns true once the time is up or the plan is no longer wanted. Empty: never.
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
  std::uint64_t refinements = 0;  ///< calls of refiners whose answers were not cached
  bool operator==(const PlanningEffort&) const = default;
};

/// Plans the tasks of the request in their order. Each elementary task of the plan has its
/// duration, way and conditions; the plan is not yet checked as a temporal network (schedule.hpp).
/// Deterministic; a job: it shares nothing with others except what the request points to. Cost:
/// some milliseconds plus the refiners'. Source: T IV.2, IV.4.2 (SCD-3), spec 3.3 to 3.5.
Result<mission::ElementaryPlan, PlanningFailure> plan_tasks(const PlanningRequest& request,
                                                            PlanningEffort* effort = nullptr);

}  // namespace skein::supervisor
