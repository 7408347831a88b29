// SPDX-License-Identifier: Apache-2.0
// Routing between the ground station's components.
#include "skein/ground_station/ground_control.hpp"

#include <utility>

#include "request_facts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/alarm_name.hpp"
#include "task_places.hpp"

namespace skein::ground_station {
namespace {

std::vector<Monitoring::Uav> roster(const std::vector<GroundUav>& uavs) {
  std::vector<Monitoring::Uav> roster;
  roster.reserve(uavs.size());
  for (const GroundUav& uav : uavs) roster.push_back({uav.name, uav.degree});
  return roster;
}

std::vector<std::string> names_of(const std::vector<GroundUav>& uavs) {
  std::vector<std::string> names;
  names.reserve(uavs.size());
  for (const GroundUav& uav : uavs) names.push_back(uav.name);
  return names;
}

std::map<std::string, executive::Config> executives_of(const std::vector<GroundUav>& uavs) {
  std::map<std::string, executive::Config> configs;
  for (const GroundUav& uav : uavs) {
    executive::Config& config = configs[uav.name];
    config = uav.executive;
    config.name = uav.name;
  }
  return configs;
}

constexpr Duration kRoleTaskLives = Duration::milliseconds(30'000);

bool is_due(std::optional<MissionTime> wakeup, MissionTime now) { return wakeup && *wakeup <= now; }

}  // namespace

GroundControl::GroundControl(const GroundConfig& config, const world::Terrain& terrain)
    : perception_(config.pps, terrain),
      objects_(config.objects),
      monitoring_(roster(config.uavs), config.reply_grace,
                  MissionChecks(config.missions, names_of(config.uavs))),
      planning_(config.script, terrain),
      mles_(executives_of(config.uavs)),
      transfer_lifetime_(config.transfer_lifetime) {}

std::vector<GroundControl::Effect> GroundControl::handle(const Input& input, MissionTime now) {
  Effects out;
  for (const OperatorDesk::Effect& effect : desk_.wake(now)) accept(effect, out);
  if (!std::holds_alternative<Resumed>(input)) wake(now);
  run_errands(now, out);
  accept(input, now, out);
  run_errands(now, out);
  for (OperatorAnswered& answer : desk_.take_answers()) out.emplace_back(std::move(answer));
  return out;
}

std::optional<MissionTime> GroundControl::next_wakeup() const {
  const auto components = earliest(monitoring_.next_wakeup(), planning_.next_wakeup());
  return earliest(earliest(components, mles_.next_wakeup()), desk_.next_wakeup());
}

Board GroundControl::board(MissionTime now) const {
  Board board = monitoring_.board(now);
  for (UavOnBoard& uav : board.uavs) uav.held = held_.of(uav.name);
  return board;
}

void GroundControl::wake(MissionTime now) {
  for (const std::string& uav : mles_.due(now)) {
    errands_.emplace_back(LocalInput{uav, executive::Tick{}, std::nullopt});
  }
  if (is_due(monitoring_.next_wakeup(), now)) errands_.emplace_back(Monitoring::Input(Tick{}));
  if (is_due(planning_.next_wakeup(), now)) errands_.emplace_back(MissionPlanning::Input(Tick{}));
}

void GroundControl::accept(const Input& input, MissionTime now, Effects& out) {
  std::visit(
      Overloaded{
          [](const Tick&) {},
          [&](const Resumed&) {
            for (const std::string& uav : mles_.running())
              errands_.emplace_back(LocalInput{uav, executive::Tick{true}, std::nullopt});
          },
          [&](const PerceptionReceived& it) {
            for (const auto& effect : perception_.handle(it.perception, now)) {
              route(effect, out);
            }
            for (ObjectSeen& seen : objects_.handle(it.perception))
              out.emplace_back(std::move(seen));
          },
          [&](const TelemetryReceived& it) {
            tell_flight(it.uav, it.state.airborne);
            errands_.emplace_back(Monitoring::Input(it));
          },
          [&](const PlanBoardReceived& it) {
            tell_flight(it.uav, it.airborne);
            errands_.emplace_back(Monitoring::Input(it));
          },
          [&](const FunctionalStatusReceived& it) { accept_status(it, out); },
          [&](const SyncReceived& it) { deliver_sync(it, now, out); },
          [&](const PeerReachable& it) { accept_reachability(it, out); },
          [&](const OperatorActs& it) { errands_.emplace_back(MissionPlanning::Input(it)); },
          [&](const TeamTaskChanged& it) { errands_.emplace_back(MissionPlanning::Input(it)); },
          [&](const GlobalMissionChanged& it) {
            desk_.note(it);
            errands_.emplace_back(MissionPlanning::Input(it));
          },
          [&](const OperatorCommand& it) {
            errands_.emplace_back(
                Monitoring::Input(IssueCommand{it.uav, it.request, now + it.lifetime, "operator"}));
          },
          [&](const OperatorRequest& it) { accept(it, now, out); },
          [&](const RoleAsks& it) {
            errands_.emplace_back(Monitoring::Input(
                IssueCommand{it.uav, it.request, now + kRoleTaskLives, "a role played here"}));
          },
          [&](const PlayedTaskChanged& it) {
            errands_.emplace_back(Monitoring::Input(roles_.note(it)));
          },
          [&](const auto& it) { errands_.emplace_back(Monitoring::Input(it)); },
      },
      input);
}

void GroundControl::accept(const OperatorRequest& request, MissionTime now, Effects& out) {
  const Board known = board(now);
  const OperatorDesk::Surroundings around{known, planning_.answers(), perception_.alarms()};
  for (const OperatorDesk::Effect& effect : desk_.handle(request, around, now)) {
    accept(effect, out);
  }
}

void GroundControl::accept(const OperatorDesk::Effect& effect, Effects& out) {
  std::visit(
      Overloaded{[&](const DoActions& it) { errands_.emplace_back(MissionPlanning::Input(it)); },
                 [&](const OperatorActs& it) { errands_.emplace_back(MissionPlanning::Input(it)); },
                 [&](const JudgeAlarm& it) {
                   for (const auto& judged : perception_.judge(it.alarm, it.state)) {
                     route(judged, out);
                   }
                 },
                 [&](const auto& it) { out.emplace_back(it); }},
      effect);
}

void GroundControl::report(const Anomaly& anomaly, Effects& out) {
  desk_.note(anomaly);
  out.emplace_back(anomaly);
}

void GroundControl::accept_status(const FunctionalStatusReceived& input, Effects& out) {
  if (mles_.runs(input.uav)) {
    errands_.emplace_back(LocalInput{input.uav, input.status, std::nullopt});
  } else {
    out.emplace_back(
        Anomaly{"functional status of '" + input.uav + "', for which no MLE runs here"});
  }
}

void GroundControl::accept_reachability(const PeerReachable& input, Effects& out) {
  errands_.emplace_back(Monitoring::Input(input));
  errands_.emplace_back(MissionPlanning::Input(input));
  if (!input.reachable) return;
  if (input.restarted) {
    for (const Alarm& alarm : perception_.alarms()) out.emplace_back(TellAlarm{alarm, input.uav});
  }
  for (const std::string& uav : mles_.running()) {
    if (uav == input.uav) continue;
    errands_.emplace_back(LocalInput{uav, executive::PeerReachable{input.uav}, std::nullopt});
  }
  // The transparent node may have taken requests with it that were on their way, or their statuses.
  if (input.restarted && mles_.runs(input.uav)) {
    for (SendFunctional& again : mles_.under_way(input.uav)) out.emplace_back(std::move(again));
  }
  if (runs_here(input.uav)) return;
  for (SendSync& kept : syncs_.for_sending(input.uav)) out.emplace_back(std::move(kept));
}

void GroundControl::run_errands(MissionTime now, Effects& out) {
  while (!errands_.empty()) {
    const Errand errand = std::move(errands_.front());
    errands_.pop_front();
    std::visit([&](const auto& it) { do_errand(it, now, out); }, errand);
  }
}

void GroundControl::do_errand(const Monitoring::Input& input, MissionTime now, Effects& out) {
  for (const auto& effect : monitoring_.handle(input, now)) route(effect, now, out);
}

void GroundControl::do_errand(const MissionPlanning::Input& input, MissionTime now, Effects& out) {
  for (const auto& effect : planning_.handle(input, now)) route(effect, out);
}

// The MLE may have handed over what it had since the errand was given.
void GroundControl::do_errand(const LocalInput& input, MissionTime now, Effects& out) {
  if (!runs_here(input.uav) && !mles_.runs(input.uav)) return;
  for (const auto& effect : mles_.of(input.uav).handle(input.input, now)) {
    route_local(input, effect, now, out);
  }
}

void GroundControl::route(const Monitoring::Effect& effect, MissionTime now, Effects& out) {
  const auto tell_planning = [&](const auto& it) {
    errands_.emplace_back(MissionPlanning::Input(it));
  };
  const auto stop_playing = [&](const std::string& uav, const std::string& why) {
    if (auto stop = roles_.stop(uav, why)) out.emplace_back(std::move(*stop));
  };
  std::visit(Overloaded{
                 [&](const SendRequest& it) { route(it, out); },
                 [&](const CommandChanged& it) {
                   desk_.note(it, now);
                   out.emplace_back(it);
                   if (it.state == CommandState::kExpired) tell_planning(it);
                 },
                 [&](const Anomaly& it) { report(it, out); },
                 [&](const TaskChanged& it) {
                   tell_planning(it);
                   if (const auto original = stand_ins_.original_of(it.uav, it.task))
                     tell_planning(TaskChanged{it.uav, *original, it.state});
                 },
                 [&](const GoalChanged& it) {
                   if (it.state == mission::GoalState::kCancelled) give_up(it.uav, it.goal, out);
                   tell_planning(it);
                 },
                 [&](const MissionChanged& it) { tell_planning(it); },
                 [&](const PlanInterrupted& it) { tell_planning(it); },
                 [&](const UavRestarted& it) {
                   out.emplace_back(it);
                   stop_playing(it.uav, "the decision node of '" + it.uav + "' restarted");
                   tell_planning(it);
                 },
                 [&](const DegreeChanged& it) {
                   out.emplace_back(it);
                   stop_playing(it.uav, "'" + it.uav + "' is at degree " +
                                            std::to_string(it.degree) +
                                            " now: what comes next is decided anew");
                   tell_planning(it);
                   if (!runs_at_ground(it.degree)) send_up(it.uav, now, out);
                 },
                 [&](const HandedOver& it) { take_over(it, now, out); },
                 [&](const ChangeSettled& it) {
                   errands_.emplace_back(Monitoring::Input(ReleaseCommands{it.uav}));
                 },
                 [&](const auto& it) { out.emplace_back(it); },
             },
             effect);
}

void GroundControl::route(const SendRequest& request, Effects& out) {
  air_.note(request.request);
  const auto answer = [&](bool accepted, const std::string& why) {
    errands_.emplace_back(Monitoring::Input(RequestReplyReceived{request.command, accepted, why}));
  };
  if (const auto edited = held_.edit(request.uav, request.request)) {
    if (edited->dropped > 0) {
      out.emplace_back(HeldPlanChanged{request.uav, edited->dropped, HeldState::kDropped});
    }
    return answer(edited->accepted, edited->why);
  }
  if (auto stop = roles_.stop(request)) {
    out.emplace_back(std::move(*stop));
    return answer(true, "");
  }
  const TaskPlaces places(monitoring_, mles_);
  const bool is_here = to_executive(request.request) && places.is_at_ground(request);
  SendRequest adapted = request;
  adapted.request = places.adapted(request, is_here);
  if (is_here) {
    errands_.emplace_back(LocalInput{request.uav, *to_executive(adapted.request), adapted});
    return;
  }
  out.emplace_back(std::move(adapted));
}

void GroundControl::route(const MissionPlanning::Effect& effect, Effects& out) {
  const auto tell_monitoring = [&](const auto& it) {
    errands_.emplace_back(Monitoring::Input(it));
  };
  std::visit(Overloaded{
                 [&](const IssueCommand& it) {
                   IssueCommand command = it;
                   command.request = stand_ins_.redirected(it.uav, it.request);
                   tell_monitoring(command);
                 },
                 [&](const IssueToAll& it) { tell_monitoring(it); },
                 [&](const AbortEverything& it) { tell_monitoring(it); },
                 [&](const ChangeHands& it) { tell_monitoring(it); },
                 [&](const ResumeHeld& it) { resume(it, out); },
                 [&](const DropHeld& it) { drop(it.uav, out); },
                 [&](const Anomaly& it) { report(it, out); },
                 [&](const PlayRole& it) { errands_.emplace_back(it); },
                 [&](const GiveGlobalMission& it) {
                   desk_.note(it);
                   out.emplace_back(it);
                 },
                 [&](const auto& it) { out.emplace_back(it); },
             },
             effect);
}

void GroundControl::route(const PerceptionProcessing::Effect& effect, Effects& out) {
  std::visit(Overloaded{
                 [&](const PerceptionLogged& it) { out.emplace_back(it); },
                 [&](const AlarmEvent& it) {
                   monitoring_.know_place(mission::name_of_alarm(it.alarm.id.value()));
                   out.emplace_back(it);
                   errands_.emplace_back(MissionPlanning::Input(it));
                 },
                 [&](const AlarmRefined& it) {
                   out.emplace_back(TellAlarm{it.alarm, {}});
                   errands_.emplace_back(MissionPlanning::Input(it));
                 },
             },
             effect);
}

void GroundControl::route_local(const LocalInput& cause, const executive::Effect& effect,
                                MissionTime now, Effects& out) {
  const std::string& uav = cause.uav;
  std::visit(
      Overloaded{
          [&](const executive::TaskEvent& it) {
            if (!monitoring_.has_told(uav, it.id, it.state)) {
              const auto task = mles_.of(uav).find(it.id);
              out.emplace_back(LocalTaskEvent{uav, it,
                                              task ? task->parameters : executive::Parameters(),
                                              is_functional(it.type)});
            }
            errands_.emplace_back(Monitoring::Input(
                TaskEventReceived{uav, it.id, it.type, it.state, it.reason, true}));
          },
          [&](const executive::Dispatch& it) { dispatch(uav, it, now, out); },
          [&](const executive::Interrupt& it) {
            if (!it.joint) out.emplace_back(mles_.to_interrupt(uav, it.id));
          },
          [&](const executive::SendSync& it) {
            out.emplace_back(LocalSync{it.id, uav, it.to, SyncDirection::kSent, it.word});
            deliver_sync({it.id, uav, it.to, it.word, now}, now, out);
          },
          [&](const executive::Reply& it) {
            if (!cause.command) {
              if (!it.accepted) out.emplace_back(Anomaly{uav + ": not taken over: " + it.why});
              return;
            }
            const auto* start = std::get_if<executive::Start>(&cause.command->request);
            const auto mode = start != nullptr ? start->mode : executive::InsertionMode::kSeq;
            out.emplace_back(LocalRequestAnswered{uav, it, mode});
            errands_.emplace_back(Monitoring::Input(
                RequestReplyReceived{cause.command->command, it.accepted, it.why}));
          },
          [](const executive::ForwardToSupervisor&) {},
          [&](const executive::Notice& it) { out.emplace_back(Anomaly{uav + ": " + it.text}); },
      },
      effect);
}

// ---- roles that are played here ----

// What is refused is over: the script may wait for it.
void GroundControl::do_errand(const PlayRole& play, MissionTime now, Effects& out) {
  const executive::TaskId task(play.task.id.value());
  const std::vector<std::string> problems = monitoring_.problems_of(play, now);
  if (problems.empty()) {
    roles_.play(play);
    out.emplace_back(play);
    return;
  }
  const std::string why = joined(problems, "; ");
  report({"joint task " + skein::to_text(task) + " is not played for " + play.uav + ": " + why,
          play.asked_by},
         out);
  const bool known = monitoring_.find_task(play.uav, task).has_value();
  if (known || !monitoring_.knows(play.uav)) return;
  const executive::TaskEvent refused{task, std::string(executive::kJointPrefix) + play.task.name,
                                     executive::TaskState::kAborted, why};
  errands_.emplace_back(Monitoring::Input(roles_.note({play.uav, refused})));
}

// A joint task needs a supervisor, which degree 1 does not have. What the executive has given up
// without an answer the UAV must not begin when it is heard again; an interruption is never late.
void GroundControl::dispatch(const std::string& uav, const executive::Dispatch& dispatch,
                             MissionTime now, Effects& out) {
  if (dispatch.joint) {
    const executive::FunctionalStatus refusal{dispatch.id, executive::TaskState::kAborted,
                                              "no joint tasks at degree 1"};
    errands_.emplace_back(LocalInput{uav, refusal, std::nullopt});
    return;
  }
  out.emplace_back(mles_.to_begin(uav, dispatch.id, now));
}

void GroundControl::deliver_sync(const SyncReceived& sync, MissionTime now, Effects& out) {
  if (!monitoring_.knows(sync.to) || !monitoring_.knows(sync.from)) {
    out.emplace_back(Anomaly{"synchronisation message from '" + sync.from + "' to '" + sync.to +
                             "': one of them is unknown"});
    return;
  }
  const executive::SyncReceived message = syncs_.note(sync, now);
  if (runs_here(sync.to)) {
    out.emplace_back(LocalSync{sync.id, sync.from, sync.to, SyncDirection::kReceived, sync.word});
    errands_.emplace_back(LocalInput{sync.to, message, std::nullopt});
  } else {
    out.emplace_back(SendSync{sync.id, sync.from, sync.to, sync.word, *message.said});
  }
}

void GroundControl::tell_flight(const std::string& uav, bool airborne) {
  if (!runs_here(uav) || !mles_.can_run(uav) || !mles_.note_flight(uav, airborne)) return;
  errands_.emplace_back(LocalInput{uav, executive::Flight{airborne}, std::nullopt});
}

}  // namespace skein::ground_station
