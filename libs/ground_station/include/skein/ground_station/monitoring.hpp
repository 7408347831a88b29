// SPDX-License-Identifier: Apache-2.0
// MCS: the status board of every UAV and task, and the intake of commands.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/ground_orders/messages.hpp"
#include "skein/ground_station/degree_change.hpp"
#include "skein/ground_station/mission_checks.hpp"
#include "skein/ground_station/mission_progress.hpp"
#include "skein/ground_station/pending_commands.hpp"
#include "skein/ground_station/plan_interrupted.hpp"
#include "skein/ground_station/task_board.hpp"

namespace skein::ground_station {

struct UavOnBoard {
  std::string name;
  Degree degree = 3;
  bool reachable = false;
  bool airborne = false;
  std::optional<world::VehicleState> telemetry;  ///< the last
  MissionTime telemetry_at;                      ///< when `telemetry` was measured
  TaskBoard tasks;
  std::size_t commands_pending = 0;
  /// High-level tasks, in the order of the UAV's high-level plan.
  std::vector<mission::GoalStatus> goals;
  mission::PlanReport plan;  ///< the last; revision 0: none
  /// The last decisions of the UAV's supervisor, oldest first; at most kDecisionsKept.
  std::deque<mission::Decision> decisions;
  /// The last answer to each mission that the UAV was asked to evaluate.
  std::map<mission::MissionId, mission::MissionOutcome> evaluations;
  /// Tasks that the UAV handed over and that nobody executes until they are resumed, by id.
  std::vector<mission::HeldTask> held;
  /// The degree before the UAV was last taken in hand; absent: it never was.
  std::optional<Degree> degree_before_taken;

  static constexpr std::size_t kDecisionsKept = 20;
};

/// A snapshot for displays and progress. UAVs in the order configured.
struct Board {
  MissionTime at;
  std::vector<UavOnBoard> uavs;
};

/// The task to show as the UAV's present one: among its started or running tasks, the one with the
/// lowest id that moves it (takeoff, goto, land, wait) or, if there is none, the one with the
/// lowest id; null if no task is started or running. Valid as long as `uav` is.
const TaskOnBoard* current_task(const UavOnBoard& uav);

/// A command is pending from its issue until exactly one of
///   acknowledged   its MLE accepted it,
///   refused        its MLE or decision node refused it, it is invalid (MissionChecks), its UAV is
///                  unknown, or its task was lost in a restart,
///   expired        it could not be delivered, or no answer came by `expires` + `grace`.
/// Meanwhile its delivery is reported once: on CommandDelivered, or on the answer of its MLE, which
/// proves it; so each acknowledged command was delivered before. Later inputs about a settled
/// command are reported as anomalies and change nothing. A command is sent when issued, and again
/// with the same number if its UAV's node restarts meanwhile.
///
/// A change of degree determines the receiver of later commands. Once it is sent, other commands to
/// the UAV wait, in order, until the UAV has handed over its plan or the change has failed
/// (ChangeSettled), and then until ReleaseCommands. The degree on plan boards is not used
/// meanwhile, and ignored if the degree was told later by another message.
///
/// Task states come by events and by plan boards, in any order and more than once. Each state is
/// reported once, and the board never goes back (scheduled, started, running, aborting, then ended
/// or aborted), except for a task that was lost and is started anew.
///
/// The background routine's tasks are on the board, but AbortEverything does not abort them.
///
/// Deterministic. Not safe to share between threads. Cost of an input: O(log) in tasks and
/// commands, but O(tasks of the UAV) for a restart or a plan board. Source: T VI.1.1,
/// spec 1.1, 1.2.
class Monitoring {
 public:
  using Input =
      std::variant<Tick, IssueCommand, IssueToAll, AbortEverything, ChangeHands, ReleaseCommands,
                   TelemetryReceived, TaskEventReceived, RequestReplyReceived, CommandDelivered,
                   CommandUndelivered, PeerReachable, PlanBoardReceived, MissionPlanReceived,
                   HandOverReceived, DecisionReceived, MissionOutcomeReceived>;
  using Effect = std::variant<SendRequest, CommandChanged, TaskChanged, UavRestarted, DegreeChanged,
                              HandedOver, PlanInterrupted, ChangeSettled, GoalChanged,
                              MissionChanged, Anomaly>;

  struct Uav {
    std::string name;
    Degree degree = 3;  ///< until its plan board says otherwise
  };

  /// `grace`: how long after a command's expiry its answer may still be under way.
  explicit Monitoring(const std::vector<Uav>& uavs, Duration grace = Duration::milliseconds(5'000),
                      MissionChecks checks = {});

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Adds a place that missions may name.
  void know_place(const std::string& name) { checks_.know_place(name); }

  /// Every reason why the role cannot be played at the ground, in sentences; empty: it can.
  std::vector<std::string> problems_of(const PlayRole& play, MissionTime now) const;

  Board board(MissionTime now) const;
  /// Names of the UAVs, in the order configured.
  const std::vector<std::string>& uavs() const { return order_; }
  /// The UAV's entry of board(), without a copy. Precondition: `name` is one of uavs(). Valid until
  /// the next input.
  const UavOnBoard& uav(const std::string& name) const { return uavs_.at(name).board; }
  /// 3 for an unknown UAV.
  Degree degree_of(const std::string& uav) const;
  bool knows(const std::string& uav) const { return uavs_.contains(uav); }
  /// The task; absent if it or the UAV is unknown. For tasks that were over long ago see TaskBoard.
  std::optional<TaskOnBoard> find_task(const std::string& uav, executive::TaskId task) const;
  /// Whether TaskChanged was emitted for this state; false if the UAV or the task is unknown or
  /// lost.
  bool has_told(const std::string& uav, executive::TaskId task, executive::TaskState state) const;
  /// Whether a START of the task is pending.
  bool is_being_started(const std::string& uav, executive::TaskId task) const;
  /// The messages (PROCESS-MSG) that the UAV's MLE, on board or here, has acknowledged.
  std::set<std::string> messages_of(const std::string& uav) const;

 private:
  struct Record {
    UavOnBoard board;
    MissionProgress missions;
    DegreeChange change;
    std::deque<CommandNumber> waiting;  ///< commands that wait for the change, in order
    std::set<std::string> messages;     ///< that its MLE has processed
    ModelVersions models;               ///< of joint tasks, as the UAV reported
  };
  using Effects = std::vector<Effect>;

  // monitoring.cpp: inputs about UAVs and tasks
  void on(const Tick&, MissionTime, Effects&) {}
  void on(const TelemetryReceived& input, MissionTime now, Effects& effects);
  void on(const TaskEventReceived& input, MissionTime now, Effects& effects);
  void on(const PeerReachable& input, MissionTime now, Effects& effects);
  void on(const PlanBoardReceived& input, MissionTime now, Effects& effects);
  Record* find(const std::string& uav, const char* what, Effects& effects);
  void learn(Record& record, const TaskEventReceived& event, MissionTime now, Effects& effects);

  // monitoring_commands.cpp
  void on(const IssueCommand& input, MissionTime now, Effects& effects);
  void on(const IssueToAll& input, MissionTime now, Effects& effects);
  void on(const AbortEverything& input, MissionTime now, Effects& effects);
  void on(const ReleaseCommands& input, MissionTime now, Effects& effects);
  void on(const RequestReplyReceived& input, MissionTime now, Effects& effects);
  void on(const CommandDelivered& input, MissionTime now, Effects& effects);
  void on(const CommandUndelivered& input, MissionTime now, Effects& effects);
  void send(CommandNumber number, MissionTime now, Effects& effects);
  void close(CommandNumber number, CommandState state, const std::string& why, Effects& effects);
  Addressee addressee(const Record& record) const;
  void expire_due(MissionTime now, Effects& effects);
  void send_again(const Record& record, Effects& effects);

  // monitoring_autonomy.cpp: missions and degrees
  void on(const ChangeHands& input, MissionTime now, Effects& effects);
  void on(const MissionPlanReceived& input, MissionTime now, Effects& effects);
  void on(const HandOverReceived& input, MissionTime now, Effects& effects);
  void on(const DecisionReceived& input, MissionTime now, Effects& effects);
  void on(const MissionOutcomeReceived& input, MissionTime now, Effects& effects);
  void set_degree(Record& record, Degree degree, Effects& effects);
  void settle(Record& record, Effects& effects);

  std::vector<std::string> order_;  ///< of the board
  std::map<std::string, Record> uavs_;
  PendingCommands commands_;
  MissionChecks checks_;
};

}  // namespace skein::ground_station
