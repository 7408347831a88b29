// SPDX-License-Identifier: Apache-2.0
// The ground station's decision making as one component: PPS, MCS, MPS and, for UAVs at degree 1,
// their MLEs.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/ground_orders/messages.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/ground_station/closed_air.hpp"
#include "skein/ground_station/held_plans.hpp"
#include "skein/ground_station/kept_syncs.hpp"
#include "skein/ground_station/local_executives.hpp"
#include "skein/ground_station/mission_planning.hpp"
#include "skein/ground_station/monitoring.hpp"
#include "skein/ground_station/object_tracking.hpp"
#include "skein/ground_station/operator_desk.hpp"
#include "skein/ground_station/perception_processing.hpp"
#include "skein/ground_station/played_roles.hpp"
#include "skein/ground_station/stand_ins.hpp"

namespace skein::ground_station {

struct PerceptionReceived {
  world::Perception perception;
};

/// One UAV of the scenario.
struct GroundUav {
  std::string name;
  Degree degree = 3;  ///< at the start
  /// Configuration of the MLE that the ground runs for the UAV at degree 1; the name in it is
  /// replaced by the UAV's. Should equal that of the UAV's own MLE, so that plans run alike at all
  /// degrees.
  executive::Config executive = {};
};

struct GroundConfig {
  std::vector<GroundUav> uavs;  ///< names differ
  Script script = {};
  PpsConfig pps = {};
  std::vector<ObjectSpec> objects = {};                  ///< the objects to track
  Duration reply_grace = Duration::milliseconds(5'000);  ///< see Monitoring
  MissionKnowledge missions = {};
  bool dates = false;  ///< the ground relays to UAVs the dates at which partners come to meetings
  /// Lifetime of the requests that transfer tasks of the MLE here to a UAV whose degree goes up.
  Duration transfer_lifetime = Duration::seconds(600);
};

/// Routes inputs to its components, and their effects to each other, in order, until only effects
/// for the outside are left.
///
/// Who executes (T II.2, spec 1.2): at degree 1 a request goes to the UAV's MLE here, whose
/// dispatches and interruptions become SendFunctional; at degrees 2 and up to the UAV's own MLE, as
/// SendRequest. A request about a task goes to the MLE that holds the task, so that a task that
/// runs across a change of degree can still be commanded; requests that come while a change of
/// degree is under way wait for its outcome. Missions, cancellations, changes of degree and of the
/// world go to the UAV's decision node.
///
/// Hand-over is a transfer of the plan (ADR 9). Going to degree 1, the MLE here starts the tasks of
/// the UAV's MLE under the same ids; tasks under way are dispatched again, which the functional
/// layer answers without executing them twice. Going up, the tasks of the MLE here are sent to the
/// UAV as START in the same way; a dispatch from here that arrives after the change is refused,
/// after the hand-over, since events keep their order, and is ignored. Synchronisation messages
/// known here are transferred, too. Tasks that were only planned are held here: commands about them
/// edit them, ResumePlan starts them, DropPlan discards them. So are tasks that a contact-loss
/// policy interrupted, under new ids; to the script and in what it asks they go by the ids that it
/// gave.
///
/// Each state of a task is reported once: states that a transferred task repeats are not reported.
///
/// Relaying: a synchronisation message goes to the MLE here if its receiver's degree is 1; else it
/// is sent on (SendSync), and again when the receiver comes back in reach or restarts. Messages
/// between UAVs for which synchronises_directly() holds do not pass here.
///
/// When the node of a UAV whose MLE is here restarts, the tasks that this MLE has under way are
/// dispatched again; a functional layer answers a repeated request without executing it twice.
///
/// Roles that are played here (PlayRole) end with any change of the UAV's degree, with a restart of
/// its decision node, and by an ABORT of the joint task.
///
/// Operators send requests (OperatorDesk); their actions are carried out as those of the script
/// are.
///
/// Timers due before an input are handled before it. The same inputs at the same instants give the
/// same effects. Not safe to share between threads. Source: T II.1, VI.1.1, spec 1.1, 1.2, 1.5.
class GroundControl {
 public:
  using Input =
      std::variant<Tick, PerceptionReceived, TelemetryReceived, TaskEventReceived,
                   RequestReplyReceived, CommandDelivered, CommandUndelivered, PlanBoardReceived,
                   FunctionalStatusReceived, SyncReceived, PeerReachable, OperatorActs,
                   OperatorCommand, OperatorRequest, MissionPlanReceived, HandOverReceived,
                   DecisionReceived, MissionOutcomeReceived, TeamTaskChanged, GlobalMissionChanged,
                   RoleAsks, PlayedTaskChanged, Resumed>;
  using Effect = std::variant<
      // to be sent
      SendRequest, SendFunctional, SendSync, AlarmEvent, TellAlarm, ObjectSeen, OperatorAnswered,
      // for the team, and for roles that are played here
      GiveGlobalMission, DeclareLost, DeclareFound, PlayRole, StopRole,
      // for the journal
      CommandChanged, LocalRequestAnswered, LocalTaskEvent, LocalSync, PerceptionLogged,
      PhaseEntered, StepDone, OperatorDid, OperatorAsked, HandChanged, DegreeChanged, UavRestarted,
      HeldPlanChanged,
      // for the runtime
      Anomaly, MissionFinished>;

  /// Precondition: problems_of(config.script) and problems_of(config.pps) are empty, and UAV names
  /// differ. The terrain must outlive this.
  GroundControl(const GroundConfig& config, const world::Terrain& terrain);

  /// `now` never decreases.
  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  Board board(MissionTime now) const;
  /// Names of the UAVs, in the order configured.
  const std::vector<std::string>& uavs() const { return monitoring_.uavs(); }
  /// The UAV's entry of board(), except `held`, without copying all tasks of the mission.
  /// Precondition: `name` is one of uavs(). Valid until the next input.
  const UavOnBoard& uav(const std::string& name) const { return monitoring_.uav(name); }
  std::size_t held_of(const std::string& uav) const { return held_.of(uav).size(); }
  std::vector<Alarm> alarms() const { return perception_.alarms(); }
  const OperatorDesk& desk() const { return desk_; }
  std::vector<std::string> answers() const { return planning_.answers(); }
  /// Volumes that were closed during the mission and not opened again, by name.
  const std::map<std::string, world::Volume>& closed_air() const { return air_.volumes(); }
  const std::string& phase() const { return planning_.phase(); }
  bool finished() const { return planning_.finished(); }

 private:
  /// An input for the MLE here of `uav`; with `command`, its reply answers that command.
  struct LocalInput {
    std::string uav;
    executive::Input input;
    std::optional<SendRequest> command;
  };
  /// An input still to be passed to a component.
  using Errand = std::variant<Monitoring::Input, MissionPlanning::Input, LocalInput, PlayRole>;
  using Effects = std::vector<Effect>;

  void wake(MissionTime now);
  void accept(const Input& input, MissionTime now, Effects& out);
  void accept(const OperatorRequest& request, MissionTime now, Effects& out);
  void accept(const OperatorDesk::Effect& effect, Effects& out);
  void report(const Anomaly& anomaly, Effects& out);
  void accept_status(const FunctionalStatusReceived& input, Effects& out);
  void accept_reachability(const PeerReachable& input, Effects& out);
  void run_errands(MissionTime now, Effects& out);
  void do_errand(const Monitoring::Input& input, MissionTime now, Effects& out);
  void do_errand(const MissionPlanning::Input& input, MissionTime now, Effects& out);
  void do_errand(const LocalInput& input, MissionTime now, Effects& out);
  void do_errand(const PlayRole& play, MissionTime now, Effects& out);
  void route(const Monitoring::Effect& effect, MissionTime now, Effects& out);
  void route(const SendRequest& request, Effects& out);
  void route(const MissionPlanning::Effect& effect, Effects& out);
  void route(const PerceptionProcessing::Effect& effect, Effects& out);
  void route_local(const LocalInput& cause, const executive::Effect& effect, MissionTime now,
                   Effects& out);
  void dispatch(const std::string& uav, const executive::Dispatch& dispatch, MissionTime now,
                Effects& out);
  void deliver_sync(const SyncReceived& sync, MissionTime now, Effects& out);

  // execution_transfer.cpp
  void take_over(const HandedOver& hand_over, MissionTime now, Effects& out);
  void hold(const std::string& uav, std::vector<mission::HeldTask> tasks, Effects& out);
  void send_up(const std::string& uav, MissionTime now, Effects& out);
  void resume(const ResumeHeld& request, Effects& out);
  void drop(const std::string& uav, Effects& out);
  void give_up(const std::string& uav, mission::GoalId goal, Effects& out);
  bool runs_here(const std::string& uav) const {
    return runs_at_ground(monitoring_.degree_of(uav));
  }
  void tell_flight(const std::string& uav, bool airborne);

  PerceptionProcessing perception_;
  ObjectTracking objects_;
  Monitoring monitoring_;
  MissionPlanning planning_;
  OperatorDesk desk_;
  LocalExecutives mles_;
  std::deque<Errand> errands_;
  HeldPlans held_;
  StandIns stand_ins_;
  KeptSyncs syncs_;
  PlayedRoles roles_;
  ClosedAir air_;
  Duration transfer_lifetime_;
};

}  // namespace skein::ground_station
