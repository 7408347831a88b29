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
#include "skein/ground_station/mission_checks.hpp"
#include "skein/ground_station/task_board.hpp"

namespace skein::ground_station {

struct UavOnBoard {
  std::string name;
  Degree degree = 3;
  bool reachable = false;
  bool airborne = false;
  std::optional<world::VehicleState> telemetry;  ///< the last
  MissionTime telemetry_at;                      ///< when it was so
  TaskBoard tasks;
  std::size_t commands_pending = 0;
  /// High-level tasks, in the order of the UAV's high-level plan.
  std::vector<mission::GoalStatus> goals;
  mission::PlanReport plan;  ///< the last; revision 0: none
  /// What the UAV's supervisor did last, oldest first; not more than kDecisionsKept.
  std::deque<mission::Decision> decisions;
  /// What missions would cost that it was asked to evaluate: the last answer to each.
  std::map<mission::MissionId, mission::MissionOutcome> evaluations;
  /// What it handed over and nobody carries out until it is resumed, in the order of ids.
  std::vector<mission::HeldTask> held;
  /// In hand, the last time; absent: it never was.
  std::optional<Degree> degree_before_taken;

  static constexpr std::size_t kDecisionsKept = 20;
};

/// A snapshot for displays and progress. UAVs in the order configured.
struct Board {
  MissionTime at;
  std::vector<UavOnBoard> uavs;
};

/// The task that a person would say the UAV is doing: the lowest that is started or running and
/// moves it (takeoff, goto, land, wait) or, if none, the lowest started or running one; null when
/// it does nothing. Valid as long as `uav` is.
const TaskOnBoard* current_task(const UavOnBoard& uav);

/// A command is pending from its issue until exactly one of
///   acknowledged   its MLE accepted it,
///   refused        its MLE or decision node refused it, it makes no sense (MissionChecks), its UAV
///                  is unknown, or what it is about was lost in a restart,
///   expired        it could not be delivered, or no answer came by `expires` + `grace`.
/// Meanwhile it is told once that it was delivered: by CommandDelivered, or by the answer of its
/// MLE, which proves it. So what is acknowledged was delivered before. What comes later about it is
/// reported as an anomaly and changes nothing. It is sent when issued, and again, under its number,
/// when its UAV's node restarted meanwhile.
///
/// A change of degree decides on who gets the commands after it. From its sending on, other
/// commands to the UAV wait, in order, until the UAV handed over its plan or the change came to
/// nothing (ChangeSettled), and then until ReleaseCommands. The degree on plan boards is
/// set aside meanwhile, and disregarded when something later told the degree.
///
/// Task states come by events and by plan boards, in any order and more than once; each is told
/// once and the board never goes back (scheduled, started, running, aborting, then ended or
/// aborted), but for a task that was lost and is started anew.
///
/// The background routine's tasks are on the board but are no command's business: AbortEverything
/// leaves them.
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
                              HandedOver, ChangeSettled, GoalChanged, MissionChanged, Anomaly>;

  struct Uav {
    std::string name;
    Degree degree = 3;  ///< until its plan board says otherwise
  };

  /// How long after its expiry a command's answer may still be under way.
  explicit Monitoring(const std::vector<Uav>& uavs, Duration grace = Duration::milliseconds(5'000),
                      MissionChecks checks = {});

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Missions may name the place from now on.
  void know_place(const std::string& name) { checks_.know_place(name); }

  /// Why the role cannot be played here, all reasons at once.
  std::vector<std::string> problems_of(const PlayRole& play, MissionTime now) const;

  Board board(MissionTime now) const;
  /// In the order configured.
  const std::vector<std::string>& uavs() const { return order_; }
  /// What is known of it, without a copy. Precondition: it is one of uavs(). Valid until the next
  /// input.
  const UavOnBoard& uav(const std::string& name) const { return uavs_.at(name).board; }
  /// 3 for an unknown UAV.
  Degree degree_of(const std::string& uav) const;
  bool knows(const std::string& uav) const { return uavs_.contains(uav); }
  /// Absent when the UAV or the task is unknown. Of one that was over long ago: TaskBoard.
  std::optional<TaskOnBoard> find_task(const std::string& uav, executive::TaskId task) const;
  /// Whether a TaskChanged was given for it; false when the UAV or the task is unknown or lost.
  bool has_told(const std::string& uav, executive::TaskId task, executive::TaskState state) const;
  /// Whether a START of the task is pending.
  bool is_being_started(const std::string& uav, executive::TaskId task) const;
  /// The messages that its MLE, wherever it is, has acknowledged to have processed.
  std::set<std::string> messages_of(const std::string& uav) const;

 private:
  struct Pending {
    std::string uav;
    Request request;
    MissionTime expires;
    std::string asked_by;
    bool delivered = false;
  };
  /// A change of degree that was sent and is not settled.
  struct Change {
    CommandNumber command;
    mission::ChangeDegree wanted;
    MissionTime until;           ///< then it counts as settled
    std::optional<Degree> seen;  ///< on plan boards meanwhile
  };
  struct Record {
    UavOnBoard board;
    ByteBook told_missions;                ///< a bit for each stage
    std::optional<MissionTime> degree_at;  ///< when the last degree told was so
    std::optional<MissionTime> goals_at;   ///< when the goals on the board were so
    std::optional<Change> change;
    /// The last change that expired; it may have been made, and its hand-over be under way.
    std::optional<mission::ChangeDegree> unanswered;
    std::deque<CommandNumber> waiting;  ///< for the change, in order
    std::set<std::string> messages;     ///< that it has processed
    ModelVersions models;               ///< of joint tasks, as it told
  };
  using Effects = std::vector<Effect>;

  // monitoring.cpp: what comes in about UAVs and tasks
  void on(const Tick&, MissionTime, Effects&) {}
  void on(const TelemetryReceived& input, MissionTime now, Effects& effects);
  void on(const TaskEventReceived& input, MissionTime now, Effects& effects);
  void on(const PeerReachable& input, MissionTime now, Effects& effects);
  void on(const PlanBoardReceived& input, MissionTime now, Effects& effects);
  Record* find(const std::string& uav, const char* what, Effects& effects);
  void learn(Record& record, const TaskEventReceived& event, MissionTime now, Effects& effects);
  void lose_tasks(Record& record, Effects& effects);

  // monitoring_commands.cpp
  void on(const IssueCommand& input, MissionTime now, Effects& effects);
  void on(const IssueToAll& input, MissionTime now, Effects& effects);
  void on(const AbortEverything& input, MissionTime now, Effects& effects);
  void on(const ReleaseCommands& input, MissionTime now, Effects& effects);
  void on(const RequestReplyReceived& input, MissionTime now, Effects& effects);
  void on(const CommandDelivered& input, MissionTime now, Effects& effects);
  void on(const CommandUndelivered& input, MissionTime now, Effects& effects);
  void deliver(CommandNumber number, Effects& effects);
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
  Degree expected_degree(const Record& record) const;
  void set_degree(Record& record, Degree degree, Effects& effects);
  void settle(Record& record, Effects& effects);
  void settle_if_closed(Record& record, CommandNumber number, CommandState state, Effects& effects);
  void take_goals(Record& record, const std::vector<mission::GoalStatus>& goals,
                  std::optional<MissionTime> at, Effects& effects);
  void tell_stages(Record& record, Effects& effects);
  void tell_stage(Record& record, mission::MissionId mission, MissionStage stage, Effects& effects);

  std::vector<std::string> order_;  ///< of the board
  std::map<std::string, Record> uavs_;
  std::map<CommandNumber, Pending> pending_;
  std::set<std::pair<MissionTime, CommandNumber>> deadlines_;
  Duration grace_;
  MissionChecks checks_;
  std::uint64_t last_number_ = 0;
};

}  // namespace skein::ground_station
