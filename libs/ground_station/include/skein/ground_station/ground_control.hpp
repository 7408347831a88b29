// SPDX-License-Identifier: Apache-2.0
// The ground station's decision making as one component: PPS, MCS, MPS and, for UAVs at degree 1,
// their MLEs.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/ground_station/messages.hpp"
#include "skein/ground_station/mission_planning.hpp"
#include "skein/ground_station/monitoring.hpp"
#include "skein/ground_station/perception_processing.hpp"
#include "skein/ground_station/script.hpp"

namespace skein::ground_station {

struct PerceptionReceived {
  world::Perception perception;
};

/// One UAV of the scenario.
struct GroundUav {
  std::string name;
  Degree degree = 3;  ///< at the start
  /// Of the MLE that the ground runs for it at degree 1; its name is replaced by the UAV's. Should
  /// be as the UAV's own, so that a degree makes no difference to its plans.
  executive::Config executive = {};
};

struct GroundConfig {
  std::vector<GroundUav> uavs;  ///< names differ
  Script script = {};
  PpsConfig pps = {};
  Duration reply_grace = Duration::milliseconds(5'000);  ///< see Monitoring
};

/// Routes what comes in to its components and their effects to each other, in order, until only
/// effects for the outside are left.
///
/// Who executes (T II.2, spec 1.2): at degree 1 a request goes to the UAV's MLE here, whose
/// dispatches and interruptions become SendFunctional; at degrees 2 and up to the UAV's own MLE, as
/// SendRequest. A request about a task goes to the MLE that holds the task, so that what runs
/// across a change of degree stays commanded.
///
/// Who relays: a synchronisation message goes to the MLE here if its receiver's degree is 1; else
/// it is sent on (SendSync), and again when the receiver comes back in reach or restarts. Messages
/// between UAVs for which synchronises_directly() holds never come here.
///
/// When the node of a UAV whose MLE is here restarts, what that MLE has under way is asked for
/// again; a functional layer answers a request that it has already had, and does not execute it
/// twice.
///
/// Instants due before an input come before it. The same inputs at the same instants give the same
/// effects. Not safe to share between threads. Source: T II.1, VI.1.1, spec 1.1, 1.2, 1.5.
class GroundControl {
 public:
  using Input = std::variant<Tick, PerceptionReceived, TelemetryReceived, TaskEventReceived,
                             RequestReplyReceived, CommandUndelivered, PlanBoardReceived,
                             FunctionalStatusReceived, SyncReceived, PeerReachable, OperatorActs,
                             OperatorCommand>;
  using Effect = std::variant<
      // to be sent
      SendRequest, SendFunctional, SendSync, AlarmEvent, AlarmRefined,
      // for the journal
      CommandChanged, LocalRequestAnswered, LocalTaskEvent, LocalSync, PerceptionLogged,
      PhaseEntered, StepDone, OperatorDid, DegreeChanged, UavRestarted,
      // for the runtime
      Anomaly, MissionFinished>;

  /// Precondition: problems_of(config.script) and problems_of(config.pps) are empty, and UAV names
  /// differ. The terrain must outlive this.
  GroundControl(const GroundConfig& config, const world::Terrain& terrain);

  /// `now` never decreases.
  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  Board board(MissionTime now) const { return monitoring_.board(now); }
  std::vector<Alarm> alarms() const { return perception_.alarms(); }
  const std::string& phase() const { return planning_.phase(); }
  bool finished() const { return planning_.finished(); }

 private:
  /// An input of the MLE here of `uav`; with `command`, its reply answers that command.
  struct LocalInput {
    std::string uav;
    executive::Input input;
    std::optional<SendRequest> command;
  };
  struct LocalMle {
    executive::Executive executive;
    std::optional<bool> airborne;  ///< as last told to it
  };
  /// What is still to be handed to a component.
  using Errand = std::variant<Monitoring::Input, MissionPlanning::Input, LocalInput>;
  using Effects = std::vector<Effect>;

  void wake(MissionTime now);
  void accept(const Input& input, MissionTime now, Effects& out);
  void accept_status(const FunctionalStatusReceived& input, Effects& out);
  void accept_reachability(const PeerReachable& input, Effects& out);
  void run_errands(MissionTime now, Effects& out);
  void do_errand(const Monitoring::Input& input, MissionTime now, Effects& out);
  void do_errand(const MissionPlanning::Input& input, MissionTime now, Effects& out);
  void do_errand(const LocalInput& input, MissionTime now, Effects& out);
  void route(const Monitoring::Effect& effect, Effects& out);
  void route(const MissionPlanning::Effect& effect, Effects& out);
  void route(const PerceptionProcessing::Effect& effect, Effects& out);
  void route_local(const LocalInput& cause, const executive::Effect& effect, Effects& out);
  void dispatch(const std::string& uav, const executive::Dispatch& dispatch, Effects& out);
  void send_functional(const std::string& uav, FunctionalVerb verb, executive::TaskId id,
                       Effects& out);
  void ask_again(const std::string& uav, Effects& out);
  void deliver_sync(const SyncReceived& sync, Effects& out);
  bool is_held_here(const SendRequest& request) const;
  bool runs_here(const std::string& uav) const {
    return runs_at_ground(monitoring_.degree_of(uav));
  }
  void tell_flight(const std::string& uav, bool airborne);
  LocalMle& local(const std::string& uav);

  std::map<std::string, executive::Config> mle_configs_;
  PerceptionProcessing perception_;
  Monitoring monitoring_;
  MissionPlanning planning_;
  std::map<std::string, LocalMle> local_;
  std::deque<Errand> errands_;
  std::map<std::string, std::set<std::pair<std::uint64_t, std::string>>>
      relayed_;  ///< by receiver: id, sender
};

}  // namespace skein::ground_station
