// SPDX-License-Identifier: Apache-2.0
// Routing between the ground station's components.
#include "skein/ground_station/ground_control.hpp"

#include <algorithm>

#include "request_facts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/alarm_name.hpp"

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

constexpr Duration kRoleTaskLives = Duration::milliseconds(30'000);

// Carried out by the functional layer, not by the executive or a supervisor.
bool is_functional(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).by == functional::CarriedOutBy::kFunctionalLayer;
}

bool is_due(std::optional<MissionTime> wakeup, MissionTime now) { return wakeup && *wakeup <= now; }

}  // namespace

GroundControl::GroundControl(const GroundConfig& config, const world::Terrain& terrain)
    : perception_(config.pps, terrain),
      objects_(config.objects),
      monitoring_(roster(config.uavs), config.reply_grace,
                  MissionChecks(config.missions, names_of(config.uavs))),
      planning_(config.script, terrain),
      transfer_lifetime_(config.transfer_lifetime) {
  for (const GroundUav& uav : config.uavs) {
    executive::Config& mle = mle_configs_[uav.name];
    mle = uav.executive;
    mle.name = uav.name;
  }
}

std::vector<GroundControl::Effect> GroundControl::handle(const Input& input, MissionTime now) {
  Effects out;
  for (const OperatorDesk::Effect& effect : desk_.wake(now)) accept(effect, out);
  wake(now);
  run_errands(now, out);
  accept(input, now, out);
  run_errands(now, out);
  for (OperatorAnswered& answer : desk_.take_answers()) out.emplace_back(std::move(answer));
  return out;
}

std::optional<MissionTime> GroundControl::next_wakeup() const {
  std::optional<MissionTime> wakeup = earliest(monitoring_.next_wakeup(), planning_.next_wakeup());
  for (const auto& [uav, mle] : local_) wakeup = earliest(wakeup, mle.executive.next_wakeup());
  return earliest(wakeup, desk_.next_wakeup());
}

Board GroundControl::board(MissionTime now) const {
  Board board = monitoring_.board(now);
  for (UavOnBoard& uav : board.uavs) uav.held = held_.of(uav.name);
  return board;
}

void GroundControl::wake(MissionTime now) {
  for (const auto& [uav, mle] : local_) {
    if (is_due(mle.executive.next_wakeup(), now)) {
      errands_.emplace_back(LocalInput{uav, executive::Tick{}, std::nullopt});
    }
  }
  if (is_due(monitoring_.next_wakeup(), now)) errands_.emplace_back(Monitoring::Input(Tick{}));
  if (is_due(planning_.next_wakeup(), now)) errands_.emplace_back(MissionPlanning::Input(Tick{}));
}

void GroundControl::accept(const Input& input, MissionTime now, Effects& out) {
  std::visit(
      Overloaded{
          [](const Tick&) {},
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
          [&](const PlayedTaskChanged& it) { accept(it); },
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

void GroundControl::note_air(const Request& request) {
  const auto* change = std::get_if<mission::ChangeWorld>(&request);
  if (change == nullptr || change->place || change->ground) return;
  if (change->remove) {
    air_.erase(change->volume.name);
  } else {
    air_.insert_or_assign(change->volume.name, change->volume);
  }
}

void GroundControl::accept_status(const FunctionalStatusReceived& input, Effects& out) {
  if (local_.contains(input.uav)) {
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
  for (const auto& [uav, mle] : local_) {
    if (uav == input.uav) continue;
    errands_.emplace_back(LocalInput{uav, executive::PeerReachable{input.uav}, std::nullopt});
  }
  if (input.restarted && local_.contains(input.uav)) ask_again(input.uav, out);
  if (runs_here(input.uav)) return;
  send_kept_syncs(input.uav, out);
}

// What the transparent node may have taken with it: requests on their way, or their statuses.
void GroundControl::ask_again(const std::string& uav, Effects& out) {
  for (const executive::TaskStatus& task : local(uav).executive.tasks()) {
    if (!executive::is_active(task.state) || !is_functional(task.type)) continue;
    const bool is_aborting = task.state == executive::TaskState::kAborting;
    out.emplace_back(functional_of(
        uav, is_aborting ? functional::Verb::kInterrupt : functional::Verb::kDispatch, task.id));
  }
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
  if (!runs_here(input.uav) && !local_.contains(input.uav)) return;
  for (const auto& effect : local(input.uav).executive.handle(input.input, now)) {
    route_local(input, effect, now, out);
  }
}

void GroundControl::route(const Monitoring::Effect& effect, MissionTime now, Effects& out) {
  const auto tell_planning = [&](const auto& it) {
    errands_.emplace_back(MissionPlanning::Input(it));
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
                   stop_playing(it.uav, "the decision node of '" + it.uav + "' restarted", out);
                   tell_planning(it);
                 },
                 [&](const DegreeChanged& it) {
                   out.emplace_back(it);
                   stop_playing(it.uav,
                                "'" + it.uav + "' is at degree " + std::to_string(it.degree) +
                                    " now: what comes next is decided anew",
                                out);
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
  note_air(request.request);
  const auto answer = [&](bool accepted, const std::string& why) {
    errands_.emplace_back(Monitoring::Input(RequestReplyReceived{request.command, accepted, why}));
  };
  if (const auto edited = held_.edit(request.uav, request.request)) {
    if (edited->dropped > 0) {
      out.emplace_back(HeldPlanChanged{request.uav, edited->dropped, HeldState::kDropped});
    }
    return answer(edited->accepted, edited->why);
  }
  if (stops_playing(request, out)) return answer(true, "");
  const bool is_here = to_executive(request.request) && is_held_here(request);
  SendRequest adapted = request;
  adapted.request = for_receiver(request, is_here);
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
              const auto task = local(uav).executive.find(it.id);
              out.emplace_back(LocalTaskEvent{uav, it,
                                              task ? task->parameters : executive::Parameters(),
                                              is_functional(it.type)});
            }
            errands_.emplace_back(Monitoring::Input(
                TaskEventReceived{uav, it.id, it.type, it.state, it.reason, true}));
          },
          [&](const executive::Dispatch& it) { dispatch(uav, it, now, out); },
          [&](const executive::Interrupt& it) {
            if (!it.joint)
              out.emplace_back(functional_of(uav, functional::Verb::kInterrupt, it.id));
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
    played_.emplace(play.uav, task);
    out.emplace_back(play);
    return;
  }
  const std::string why = joined(problems, "; ");
  report({"joint task " + skein::to_text(task) + " is not played for " + play.uav + ": " + why,
          play.asked_by},
         out);
  const bool known = monitoring_.find_task(play.uav, task).has_value();
  if (known || !monitoring_.knows(play.uav)) return;
  accept(PlayedTaskChanged{play.uav,
                           {task, std::string(executive::kJointPrefix) + play.task.name,
                            executive::TaskState::kAborted, why}});
}

void GroundControl::accept(const PlayedTaskChanged& input) {
  const executive::TaskEvent& event = input.event;
  if (is_terminal(event.state)) played_.erase({input.uav, event.id});
  errands_.emplace_back(Monitoring::Input(
      TaskEventReceived{input.uav, event.id, event.type, event.state, event.reason, true}));
}

void GroundControl::stop_playing(const std::string& uav, const std::string& why, Effects& out) {
  const bool plays = std::any_of(played_.begin(), played_.end(),
                                 [&](const auto& one) { return one.first == uav; });
  if (plays) out.emplace_back(StopRole{uav, std::nullopt, why});
}

bool GroundControl::stops_playing(const SendRequest& request, Effects& out) {
  const auto* abort = std::get_if<executive::Abort>(&request.request);
  if (abort == nullptr || !played_.contains({request.uav, abort->id})) return false;
  out.emplace_back(StopRole{request.uav, abort->id, "interrupted by " + request.asked_by});
  return true;
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
  SendFunctional send = functional_of(uav, functional::Verb::kDispatch, dispatch.id);
  if (const auto timeout = mle_configs_.at(uav).functional_timeout) send.expires = now + *timeout;
  out.emplace_back(std::move(send));
}

SendFunctional GroundControl::functional_of(const std::string& uav, functional::Verb verb,
                                            executive::TaskId id) {
  functional::Request request{verb, id};
  if (const auto view = local(uav).executive.find(id)) {
    request.type = view->type;
    if (verb == functional::Verb::kDispatch) request.parameters = view->parameters;
  }
  return {uav, std::move(request)};
}

void GroundControl::deliver_sync(const SyncReceived& sync, MissionTime now, Effects& out) {
  if (!monitoring_.knows(sync.to) || !monitoring_.knows(sync.from)) {
    out.emplace_back(Anomaly{"synchronisation message from '" + sync.from + "' to '" + sync.to +
                             "': one of them is unknown"});
    return;
  }
  const MissionTime said = sync.said.value_or(now);
  const executive::SyncReceived message{sync.id, sync.from, sync.word, said};
  const auto [last, is_new] = syncs_[sync.to].try_emplace({sync.id, sync.from}, message);
  if (!is_new && *last->second.said <= said) last->second = message;
  if (runs_here(sync.to)) {
    out.emplace_back(LocalSync{sync.id, sync.from, sync.to, SyncDirection::kReceived, sync.word});
    errands_.emplace_back(LocalInput{sync.to, message, std::nullopt});
  } else {
    out.emplace_back(SendSync{sync.id, sync.from, sync.to, sync.word, said});
  }
}

void GroundControl::send_kept_syncs(const std::string& to, Effects& out) {
  for (const auto& [key, last] : syncs_[to]) {
    out.emplace_back(SendSync{last.id, last.from, to, last.word, *last.said});
  }
}

bool GroundControl::is_held_here(const SendRequest& request) const {
  if (const auto named = named_by(request.request)) {
    const auto mle = local_.find(request.uav);
    if (mle != local_.end() && mle->second.executive.find(*named)) return true;
    if (monitoring_.find_task(request.uav, *named)) return false;
  }
  return runs_here(request.uav);
}

void GroundControl::tell_flight(const std::string& uav, bool airborne) {
  if (!runs_here(uav) || !mle_configs_.contains(uav)) return;
  LocalMle& mle = local(uav);
  if (mle.airborne == airborne) return;
  mle.airborne = airborne;
  errands_.emplace_back(LocalInput{uav, executive::Flight{airborne}, std::nullopt});
}

GroundControl::LocalMle& GroundControl::local(const std::string& uav) {
  const auto found = local_.find(uav);
  if (found != local_.end()) return found->second;
  executive::Executive mle(mle_configs_.at(uav));
  return local_.emplace(uav, LocalMle{std::move(mle), std::nullopt}).first->second;
}

}  // namespace skein::ground_station
