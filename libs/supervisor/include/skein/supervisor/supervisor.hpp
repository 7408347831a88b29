// SPDX-License-Identifier: Apache-2.0
// The supervisor of the deliberative layer: the conductor of planner, refiners, interaction manager
// and executive.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/deliberation.hpp"
#include "skein/temporal/team_dates.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::supervisor {

// ---- inputs ----

/// Operator 0: a user adds a unit mission.
struct AddMission {
  mission::UnitMission mission;
};
/// Operators 0 and 2: a user cancels or interrupts high-level tasks.
struct CancelMission {
  mission::CancelGoals goals;
  std::string asked_by;
};
/// The operator lowers the degree, or the contact-loss policy takes over: the supervisor stops
/// deciding. What it had not given to the executive is handed over.
struct Disengage {
  std::string cause;  ///< "degree 3 by operator", "contact lost: hold"
};
/// The degree is 4 (again). With `resume`, high-level tasks that were handed over and are not
/// settled are planned again from here.
struct Engage {
  bool resume = true;
  std::string cause;
  /// What the executive has that is not over. Absent: all that it was given. Tasks that are not
  /// among these were taken over by somebody else and count as lost.
  std::optional<std::vector<executive::TaskId>> in_executive = std::nullopt;
};
struct WorldChanged {
  mission::ChangeWorld change;
};
/// What the executive told of any task, also of those that are not the supervisor's.
struct TaskSeen {
  executive::TaskEvent event;
};
/// The executive answered a request of the supervisor's.
struct RequestAnswered {
  executive::Reply reply;
};
struct VehicleSeen {
  world::VehicleState state;
  std::vector<std::string> failed;  ///< devices that do not work
};
struct JobFinished {
  std::uint64_t job = 0;
  DeliberationResult result;
};
/// The executive wants a joint task carried out, or interrupted.
struct JointTaskDue {
  executive::TaskId task;
  bool interrupt = false;
};
/// The interaction manager's answer to LoadJointTask.
struct JointTaskAnswered {
  executive::TaskId task;
  bool loaded = false;
  mission::Interval agreed;  ///< when it is to start, relative to mission time zero
  std::string why;           ///< not
  /// What its role takes along its nominal path.
  struct Takes {
    Duration expected;
    double energy = 0;  ///< expected, as a fraction of what is held when full
  };
  std::optional<Takes> takes = {};
};
/// When those whom the UAV is to meet come, as far as their plans are known.
struct PartnersSeen {
  std::map<temporal::MeetingId, temporal::PartnerDates> meetings;
};
/// Which orders there are between its way and others', where that changed.
struct OrdersSeen {
  AirOrders orders;
};
struct Tick {};

using Input = std::variant<AddMission, CancelMission, Disengage, Engage, WorldChanged, TaskSeen,
                           RequestAnswered, VehicleSeen, JobFinished, JointTaskDue,
                           JointTaskAnswered, PartnersSeen, OrdersSeen, Tick>;

// ---- effects ----

/// The answer to AddMission, CancelMission, WorldChanged, in the same call: every reason at once.
struct Answer {
  bool accepted = true;
  std::vector<std::string> reasons;
};
/// Later than its acceptance: the mission has a plan, or none.
struct MissionDecided {
  mission::MissionOutcome outcome;
};
/// START, ABORT or UPDATE-COND for the executive; or, of a joint task, its status.
struct ToExecutive {
  executive::Input input;
};
/// Run deliberate(request) as a job; its result comes back as JobFinished. The request is shared,
/// so that a job costs no copy.
struct StartDeliberation {
  std::uint64_t job = 0;
  std::shared_ptr<const DeliberationRequest> request;
};
/// Nobody wants the result of this job any more: it may end as soon as it likes, with any result,
/// which comes back all the same.
struct StopDeliberation {
  std::uint64_t job = 0;
};
/// The plan, its dates or the state of a high-level task changed. At most one in a call.
struct PlanChanged {
  mission::PlanReport report;
};
struct GoalChanged {
  mission::GoalStatus status;
};
/// An operator was applied.
struct Decided {
  mission::Decision decision;
};
/// What was not given to the executive when the supervisor was disengaged, as it would have been.
struct HandedOver {
  std::vector<mission::HeldTask> tasks;
};
/// Operator 4: to the interaction manager. Without preferences: it is not wanted any more.
struct LoadJointTask {
  mission::ElementaryTask task;
  std::vector<mission::Interval>
      preferences;  ///< starts, relative to mission time zero; best first
};
/// What others need to know of the plan's network changed. Empty: nothing is decided here.
struct FrontierChanged {
  temporal::Frontier frontier;
};
/// For the log.
struct Notice {
  std::string text;
};

using Effect = std::variant<Answer, MissionDecided, ToExecutive, StartDeliberation,
                            StopDeliberation, PlanChanged, GoalChanged, Decided, HandedOver,
                            LoadJointTask, FrontierChanged, Notice>;
using Effects = std::vector<Effect>;

struct Config {
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  /// A high-level task is given to the executive when it may start within this: the commitment
  /// horizon.
  Duration horizon = Duration::seconds(15);
  /// How long beyond its most a task may take before that is a contingency.
  Duration grace = Duration::seconds(1);
  /// Others are told the whole network of the plan, not what is left of it between its meetings.
  bool tells_all = false;
  int refinements = 2;            ///< times that a failed high-level task is refined again
  executive::TaskId first_id{1};  ///< of elementary tasks, where no plan says otherwise
};

/// Keeps the plan of one UAV at degree 4: takes missions, has them planned as jobs, gives tasks to
/// the executive as they come near, watches their execution, and repairs. It answers in the same
/// call, whatever jobs run; one job runs at a time, what comes meanwhile waits for its end, and a
/// result whose premises no longer hold is made again.
///
/// Laws: what the executive has is revised on explicit requests of users and by repair only. A
/// high-level task is achieved when all its elementary tasks have ended, and fails with the first
/// that is aborted and not replaced. While engaged and in the air the UAV has a task, or the
/// effects say that it has none: then it is told to wait.
///
/// It is not engaged until Engage comes; what it was told before counts. Before its first task it
/// only says, by a Notice, that the UAV flies without one.
///
/// The host carries out the effects of a call in their order, all of them, and only then hands over
/// what came of them, in the order in which it came.
///
/// `now` never decreases. Deterministic. Not safe to share between threads. Source: T IV.4, spec 6.
class Supervisor {
 public:
  explicit Supervisor(Config config);
  ~Supervisor();
  Supervisor(Supervisor&&) noexcept;
  Supervisor& operator=(Supervisor&&) noexcept;

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  bool engaged() const;
  const mission::PlanReport& report() const;
  /// As believed, at any degree. What was given away never changes.
  std::shared_ptr<const world::World> world() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::supervisor
