// SPDX-License-Identifier: Apache-2.0
// MCS: the status board of every UAV and task, and the intake of commands.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/ground_station/messages.hpp"

namespace skein::ground_station {

struct TaskOnBoard {
  executive::TaskId id;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
  bool lost = false;  ///< its MLE restarted before it was terminal
  std::string reason = {};
  MissionTime since;
};

/// Neither terminal nor lost.
bool is_open(const TaskOnBoard& task);

struct UavOnBoard {
  std::string name;
  Degree degree = 3;
  bool reachable = false;
  bool airborne = false;
  std::optional<world::VehicleState> telemetry;  ///< the last
  MissionTime telemetry_at;                      ///< when it was so
  std::map<executive::TaskId, TaskOnBoard> tasks;
  std::size_t commands_pending = 0;
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
///   refused        its MLE refused it, its UAV is unknown, or what it is about was lost in a
///   restart, expired        it could not be delivered, or no answer came by `expires` + `grace`.
/// What comes later about it is reported as an anomaly and changes nothing. It is sent when issued,
/// and again, under its number, when its UAV's node restarted meanwhile.
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
      std::variant<Tick, IssueCommand, AbortEverything, TelemetryReceived, TaskEventReceived,
                   RequestReplyReceived, CommandUndelivered, PeerReachable, PlanBoardReceived>;
  using Effect =
      std::variant<SendRequest, CommandChanged, TaskChanged, UavRestarted, DegreeChanged, Anomaly>;

  struct Uav {
    std::string name;
    Degree degree = 3;  ///< until its plan board says otherwise
  };

  /// How long after its expiry a command's answer may still be under way.
  explicit Monitoring(const std::vector<Uav>& uavs, Duration grace = Duration::milliseconds(5'000));

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  Board board(MissionTime now) const;
  /// 3 for an unknown UAV.
  Degree degree_of(const std::string& uav) const;
  bool knows(const std::string& uav) const { return uavs_.contains(uav); }
  /// Null when the UAV or the task is unknown. Valid until the next handle.
  const TaskOnBoard* find_task(const std::string& uav, executive::TaskId task) const;

 private:
  struct Pending {
    std::string uav;
    Request request;
    MissionTime expires;
  };
  struct Record {
    UavOnBoard board;
    /// States already told, by task.
    std::map<executive::TaskId, std::set<executive::TaskState>> told;
  };
  using Effects = std::vector<Effect>;

  void on(const Tick& input, MissionTime now, Effects& effects);
  void on(const IssueCommand& input, MissionTime now, Effects& effects);
  void on(const AbortEverything& input, MissionTime now, Effects& effects);
  void on(const TelemetryReceived& input, MissionTime now, Effects& effects);
  void on(const TaskEventReceived& input, MissionTime now, Effects& effects);
  void on(const RequestReplyReceived& input, MissionTime now, Effects& effects);
  void on(const CommandUndelivered& input, MissionTime now, Effects& effects);
  void on(const PeerReachable& input, MissionTime now, Effects& effects);
  void on(const PlanBoardReceived& input, MissionTime now, Effects& effects);

  Record* find(const std::string& uav, const char* what, Effects& effects);
  void close(CommandNumber number, CommandState state, const std::string& why, Effects& effects);
  void expire_due(MissionTime now, Effects& effects);
  void learn(Record& record, const TaskEventReceived& event, MissionTime now, Effects& effects);
  void restart(Record& record, Effects& effects);
  void send_again(const Record& record, Effects& effects);

  std::vector<std::string> order_;  ///< of the board
  std::map<std::string, Record> uavs_;
  std::map<CommandNumber, Pending> pending_;
  std::set<std::pair<MissionTime, CommandNumber>> deadlines_;
  Duration grace_;
  std::uint64_t last_number_ = 0;
};

}  // namespace skein::ground_station
