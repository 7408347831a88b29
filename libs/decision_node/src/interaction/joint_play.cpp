// SPDX-License-Identifier: Apache-2.0
// A joint task while it runs: what its role asks for is carried out.
#include <algorithm>

#include "interaction/agreed_places.hpp"
#include "interaction/interaction.hpp"
#include "interaction/places.hpp"
#include "interaction/role_tasks.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/interaction/describe.hpp"

namespace skein::decision_node {

namespace {

using interaction::ComponelState;
using interaction::JointPhase;
using Word = interaction::Status::Word;

constexpr const char* kMemberLost = "member lost";
constexpr Duration kReallocation = Duration::milliseconds(10'000);
constexpr Duration kStand = Duration::milliseconds(20'000);  // of roles that were just confirmed
constexpr Duration kNothing = Duration::milliseconds(500);   // of a perception: it is done

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

bool is_mapping(const interaction::Automaton& automaton, const std::string& componel) {
  return automaton[*automaton.find(componel)].task()->type == kMapArea;
}

/// Way-points are passed within that [m].
double passing_distance(const world::VehicleModel& vehicle, const world::Wind& wind) {
  return 5 + 6 * world::tracking_spread(vehicle) + vehicle.wind_drift * wind.speed;
}

/// Of what has no duration nothing is known.
bool is_done(Duration wanted, Duration done) {
  return wanted > Duration() && wanted - done < kNothing;
}

}  // namespace

std::vector<std::string> Membership::parties_of(const std::string& role, const std::string& action,
                                                const std::string& self) const {
  std::set<std::string> all{self};
  for (const interaction::Correspondence& one : joint.variant->table.correspondences) {
    if (one.role != role || one.action != action) continue;
    for (const auto& [uav, held] : holders) {
      if (held == one.target_role) all.insert(uav);
    }
  }
  return {all.begin(), all.end()};
}

JointPlay::JointPlay(const Surroundings& of)
    : host_(of.host),
      interaction_(of.interaction),
      sightings_(of.sightings),
      task_(of.task),
      my_(of.my),
      self_(of.host.config().uav),
      share_(self_) {}

MissionTime JointPlay::now() const { return host_.bus().now(); }
Outlook JointPlay::outlook() const { return task_.outlook(); }

// ---- the role ----

void JointPlay::begin(const std::string& role) {
  ++plays_;
  tasks_.clear();
  record_.begin_anew();
  actions_.clear();
  looks_.clear();
  following_.clear();
  sharing_again_.reset();
  places_again_.reset();
  roles_stand_until_.reset();
  play_.emplace(my_.joint, role, my_.holders, self_);
  tell(interaction::Start{});
}

// What follows from it comes after all that was asked before.
void JointPlay::tell(const interaction::Input& input) {
  host_.bus().post([this, input, number = plays_] {
    if (number != plays_ || !play_ || task_.over()) return;
    const auto effects = play_->tell(input, now());
    if (!effects) {
      return host_.bus().emit(Notice{my_.joint.subject + ": " + effects.error().why});
    }
    for (const interaction::Effect& effect : *effects) {
      std::visit([this](const auto& one) { carry_out(one); }, effect.what);
    }
    const auto* message = std::get_if<interaction::Message>(&input);
    if (message != nullptr && message->text == kMemberLost && effects->empty())
      meet_without_the_lost();
    task_.announce();
  });
}

void JointPlay::tell_status(const std::string& componel, Word word) {
  tell(interaction::Status{componel, word});
}

void JointPlay::carry_out(const interaction::StateChanged& effect) {
  ComponelChanged note{my_.joint.subject, play_->role(), effect.componel, effect.state, "", ""};
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::Componel& componel = automaton[*automaton.find(effect.componel)];
  const interaction::Componel& around = automaton[componel.parent];
  note.block = around.id;
  if (effect.state == ComponelState::kScheduled)
    record_.forget_failures_in(effect.componel, automaton);
  if (effect.state == ComponelState::kRunning && componel.block() != nullptr) {
    note.because = joined(describe(componel.block()->precondition, automaton), " ");
  }
  host_.bus().emit(std::move(note));
}

void JointPlay::carry_out(const interaction::Compute& effect) {
  const RolePlay::Local local = play_->local(effect.parameter);
  if (const auto text = text_of(call_of(local.initialiser), *my_.joint.library, play_->scope())) {
    return play_->know(effect.parameter, *text);
  }
  PlaceQuery query;
  query.call = call_of(local.initialiser);
  query.scope = play_->scope();
  query.from = position_of(sightings_.own()->state.position);
  query.device = device_of(play_->model(), host_.config().knowledge->vehicle);
  query.scms = play_->scms_at(local.block, true);
  const auto place = place_of(query, outlook());
  if (place) {
    play_->know(effect.parameter, *place);
  } else {
    play_->forget(effect.parameter);
  }
  PlaceComputed note{
      my_.joint.subject, play_->role(), effect.parameter, local.initialiser, {}, "", {}};
  for (const interaction::ActiveScm& one : query.scms) note.scms.push_back(one.id);
  if (place) {
    note.at = *place;
  } else {
    note.why = place.error().why;
  }
  host_.bus().emit(std::move(note));
}

// ---- what befalls it ----

bool JointPlay::goes_on_without() const { return play_ && play_->listens_to(kMemberLost); }

bool JointPlay::has_done_its_part() const {
  if (!play_) return false;
  const interaction::Automaton& automaton = play_->automaton();
  return std::ranges::any_of(record_.done(), [&](const auto& one) {
    const auto& [componel, done] = one;
    const auto found = automaton.find(componel);  // it may be of a role that it had before
    const auto* task = found ? automaton[*found].task() : nullptr;
    if (task == nullptr) return false;
    const Duration wanted = duration_of(*task, *play_);
    return is_done(wanted, done);
  });
}

void JointPlay::lose(const std::string& uav) {
  roles_stand_until_.reset();
  play_->lose(uav);
  share_.lose(uav);
  tell(interaction::Message{kMemberLost});
}

void JointPlay::leave() {
  next_role_.reset();
  tell(interaction::Abort{});
}

// What is told may be carried out at once, and then it is no task of the role any more.
void JointPlay::abort_tasks(bool is_done) {
  for (const auto& [id, componel] : std::map(tasks_)) {
    if (is_done) interaction_.aborts().note(id, AbortedFor::kRole);
    host_.run(executive::Abort{id});
  }
}

void JointPlay::time_passes() {
  const bool runs = my_.phase == JointPhase::kRunning;
  if (runs && sharing_again_ && sharing_again_->is_due(now())) share_area(sharing_again_->action);
  if (runs && places_again_ && places_again_->is_due(now()))
    negotiate_places(places_again_->action);
  const auto next = play_ ? play_->next_wakeup() : std::nullopt;
  if (next && *next <= now()) tell(interaction::Tick{});
}

std::optional<MissionTime> JointPlay::next_wakeup() const {
  std::optional<MissionTime> next = play_ ? play_->next_wakeup() : std::nullopt;
  if (my_.phase != JointPhase::kRunning) return next;
  if (sharing_again_) next = earliest(next, sharing_again_->at);
  return places_again_ ? earliest(next, places_again_->at) : next;
}

void JointPlay::tell_of(interaction::JointTaskStatus& status) const {
  if (play_) {
    status.active_blocks = play_->active_blocks();
    status.violated = play_->violated();
  }
  status.left = share_.left();
}

// ---- its tasks ----

// Interrupted as it begins: that it is to be left comes next.
void JointPlay::run(const std::string& name) {
  if (host_.stops(my_.joint.task)) return;
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::Componel& componel = automaton[*automaton.find(name)];
  if (componel.task()->type == kMapArea) return map_area(name);
  if (componel.task()->type == kFollow) return follow(name);
  const Duration done = record_.done(name);
  const Duration wanted = duration_of(*componel.task(), *play_);
  if (is_done(wanted, done)) return tell_status(name, Word::kEnded);
  const Outlook outlook = this->outlook();
  auto task = make_task(componel, my_.joint.subject,
                        {*play_, outlook, sightings_.own()->state, done, my_.allocation});
  if (!task) return fail(name, task.error().why);
  give(name, std::move(*task));
}

// Few roles say what comes then; the others would wait for its end for ever.
bool JointPlay::begin_again(const std::string& componel, Duration ran) {
  if (my_.phase != JointPhase::kRunning || next_role_) return false;
  if (!record_.is_tried_again(componel, ran)) return false;
  host_.bus().emit(Notice{my_.joint.subject + ": " + componel + " is begun again"});
  run(componel);
  return true;
}

// The role itself does nothing about the loss: who waited for the lost would do so for ever.
void JointPlay::meet_without_the_lost() {
  const interaction::Automaton& automaton = play_->automaton();
  for (const auto& [id, componel] : std::map(tasks_)) {
    const bool meets = is_meeting(*automaton[*automaton.find(componel)].task());
    if (!meets || interaction_.aborts().of(id) == AbortedFor::kRole) continue;
    interaction_.aborts().note(id, AbortedFor::kAnew);
    host_.run(executive::Abort{id});
  }
}

// Once the role has heard of it.
void JointPlay::leave_if_stuck(const std::string& componel, const std::string& why) {
  host_.bus().post([this, componel, why, number = plays_] {
    const bool plays = number == plays_ && play_ && my_.phase == JointPhase::kRunning;
    if (plays && !play_->goes_on()) task_.leave(componel + ": " + why);
  });
}

void JointPlay::fail(const std::string& componel, const std::string& why) {
  host_.bus().emit(Notice{my_.joint.subject + ": " + componel + ": " + why});
  following_.erase(componel);
  record_.failed(componel, why);
  tell_status(componel, Word::kAborted);
  leave_if_in_vain(componel, why);
  leave_if_stuck(componel, why);
}

bool JointPlay::has_only_flights_left() const {
  return play_ && !record_.failure() && play_->has_only_flights_left();
}

bool JointPlay::nothing_is_left_together() const {
  return task_.partners_have_ended() && has_only_flights_left();
}

// What was to be done together is done. A role that is not over by this has something left to do.
void JointPlay::stay_without_air(const std::string& componel, const std::string& why) {
  host_.bus().emit(Notice{my_.joint.subject + ": " + componel + ": " + why +
                          "; its partners have ended, and it stays where it is"});
  host_.bus().post([this, why, number = plays_] {
    if (number == plays_ && !task_.over()) task_.leave(why);
  });
}

// A loop begins anew in the same instant what failed as it began, and would for ever.
void JointPlay::leave_if_in_vain(const std::string& componel, const std::string& why) {
  if (record_.fails_at_once_again(componel)) task_.leave(componel + ": " + why);
}

// Motions wait for each other; what looks along one does not count.
executive::TaskId JointPlay::give(const std::string& componel, executive::Task task,
                                  std::optional<executive::TaskId> along) {
  task.id = interaction_.next_id();
  for (const auto& [other, id] : tasks_) {
    if (!holds_vehicle(task.type)) continue;
    const executive::Literal over{executive::TaskInState{other, executive::TaskState::kEnded},
                                  false, executive::Modality::kOptional};
    task.preconditions.push_back({over});
  }
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::Componel& around = automaton[automaton[*automaton.find(componel)].parent];
  if (along) {
    looks_[task.id] = *along;
  } else {
    tasks_[task.id] = componel;
  }
  host_.serves(task.id, my_.joint.task);
  host_.bus().emit(RoleTaskGiven{my_.joint.subject, play_->role(), around.id, componel, task.id,
                                 my_.joint.task, task.type,
                                 joined(describe(around.block()->precondition, automaton), " ")});
  const executive::TaskId id = task.id;
  host_.run(executive::Start{std::move(task), executive::InsertionMode::kSeq});
  return id;
}

void JointPlay::carry_out(const interaction::Interrupt& effect) {
  for (const auto& [id, componel] : tasks_) {
    if (componel != effect.task) continue;
    interaction_.aborts().note(id, AbortedFor::kRole);
    return host_.run(executive::Abort{id});
  }
  following_.erase(effect.task);
  tell_status(effect.task, Word::kAborted);
}

void JointPlay::task_changed(const executive::TaskEvent& event) {
  const auto found = tasks_.find(event.id);
  if (found == tasks_.end()) return look_changed(event);
  const std::string componel = found->second;
  if (flew_after(event, componel)) return;
  if (event.state == executive::TaskState::kRunning) {
    record_.runs(componel, now());
    return tell_status(componel, Word::kRunning);
  }
  if (!is_terminal(event.state)) return;
  const Duration ran = record_.stopped(componel, now());
  tasks_.erase(found);
  const bool ended = event.state == executive::TaskState::kEnded;
  const std::optional<AbortedFor> aborted = interaction_.aborts().take(event.id);
  if (!ended && aborted == AbortedFor::kAnew) return run(componel);
  const bool asked = aborted == AbortedFor::kRole;
  const bool gave_up =
      aborted == AbortedFor::kNothing || event.cause == executive::AbortCause::kOther;
  const bool by_vehicle = !ended && !asked && gave_up;
  if (by_vehicle && begin_again(componel, ran)) return;
  const bool has_no_air = event.cause == executive::AbortCause::kNoAir;
  const bool is_last = has_no_air && nothing_is_left_together();
  if (!ended && !asked && !is_last) record_.aborted(componel, event.reason);
  if (ended && is_mapping(play_->automaton(), componel)) share_.flown();
  tell_status(componel, ended ? Word::kEnded : Word::kAborted);
  if (is_last) return stay_without_air(componel, event.reason);
  // Else it would wait for its partner in a later meeting of the role, and that for it in this one.
  if (has_no_air) return task_.leave(event.reason);
  if (ended || !RoleRecord::failed_at_once(ran)) {
    record_.did_not_fail_at_once(componel);
  } else if (!asked) {
    leave_if_in_vain(componel, event.reason);
  }
  if (by_vehicle) leave_if_stuck(componel, event.reason);
}

bool JointPlay::watch() {
  if (!play_) return false;
  const auto own = position_of(sightings_.own()->state.position);
  share_.fly(sightings_.own()->state.position,
             passing_distance(host_.config().knowledge->vehicle, host_.world()->wind));
  look_after_followed();
  for (const interaction::ScmFound& found : play_->watch(own, outlook().observer, now())) {
    host_.bus().emit(ScmNoted{my_.joint.subject, play_->role(), found});
    tell(found.report);
  }
  return true;
}

// ---- its negotiations ----

void JointPlay::carry_out(const interaction::Negotiate& effect) {
  const interaction::Automaton& automaton = play_->automaton();
  const auto& action = *automaton[*automaton.find(effect.action)].action();
  if (action.modality == kAreaSharing) return share_area(effect.action);
  if (gives_places(action.modality)) return negotiate_places(effect.action);
  if (action.modality != "role-allocation") {
    host_.bus().emit(Notice{my_.joint.subject + ": nobody negotiates '" + action.modality + "'"});
    return tell_status(effect.action, Word::kAborted);
  }
  if (roles_stand_until_ && now() < *roles_stand_until_) {
    host_.bus().emit(Notice{my_.joint.subject + ": " + effect.action +
                            ": roles were confirmed a moment ago, and stand"});
    return tell_status(effect.action, Word::kEnded);
  }
  negotiate_roles(effect.action, action.modality);
}

void JointPlay::negotiate_roles(const std::string& action, const std::string& modality) {
  interaction::BeginNegotiation begin;
  begin.subject = my_.joint.subject + "/" + modality;
  begin.modality = modality;
  begin.members = my_.parties_of(play_->role(), action, self_);
  std::map<std::string, int> held;
  for (const std::string& uav : begin.members) ++held[my_.holders.at(uav)];
  for (const auto& [role, count] : held) {
    begin.parameters.push_back({role, "", {double(count), double(count)}});
  }
  begin.within = kReallocation;
  actions_[action] = begin.subject;
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  actions_.erase(action);
  tell_status(action, Word::kAborted);
}

void JointPlay::carry_out(const interaction::Withdraw& effect) {
  const auto negotiated = actions_.find(effect.action);
  if (negotiated != actions_.end()) {
    interaction_.withdraw(negotiated->second, my_.why.empty() ? "left" : my_.why);
    actions_.erase(negotiated);
  }
  if (sharing_again_ && sharing_again_->action == effect.action) sharing_again_.reset();
  if (places_again_ && places_again_->action == effect.action) places_again_.reset();
  tell_status(effect.action, Word::kAborted);
}

// What is undecided is kept until it is known. Roles that are others now are begun anew.
void JointPlay::decided(const interaction::Terms& terms,
                        const interaction::NegotiationOutcome& outcome) {
  using Kind = interaction::NegotiationOutcome::Kind;
  if (my_.phase != JointPhase::kRunning || outcome.kind == Kind::kUndecided) return;
  if (terms.modality == kAreaSharing) return area_shared(terms, outcome);
  if (gives_places(terms.modality)) return places_agreed(terms, outcome);
  roles_agreed(terms, outcome);
}

void JointPlay::roles_agreed(const interaction::Terms& terms,
                             const interaction::NegotiationOutcome& outcome) {
  using Kind = interaction::NegotiationOutcome::Kind;
  Holders agreed = my_.holders;
  if (outcome.kind == Kind::kAgreed) {
    for (const interaction::Row& row : outcome.result) agreed[row.name] = row.text;
  }
  if (agreed != my_.holders) {
    my_.holders = std::move(agreed);
    my_.allocation = to_text(terms.id());
    next_role_ = my_.holders.at(self_);
    tell(interaction::Abort{});
    return task_.announce();
  }
  if (outcome.kind == Kind::kAgreed) roles_stand_until_ = now() + kStand;
  for (const auto& [action, subject] : std::map(actions_)) {
    if (subject != terms.subject) continue;
    actions_.erase(action);
    tell_status(action, outcome.kind == Kind::kAgreed ? Word::kEnded : Word::kAborted);
  }
}

// A role of which a task failed is not done, though its automaton came to its end.
void JointPlay::carry_out(const interaction::ModelOver& effect) {
  if (next_role_) {
    const std::string role = *std::exchange(next_role_, std::nullopt);
    return begin(role);
  }
  const std::optional<std::string> failure = record_.failure();
  const bool ended =
      !failure && effect.state == ComponelState::kEnded && my_.phase == JointPhase::kRunning;
  if (failure && my_.why.empty()) my_.why = *failure;
  if (!ended && my_.why.empty()) my_.why = effect.why.empty() ? "its role was left" : effect.why;
  task_.finish(ended ? JointPhase::kEnded : JointPhase::kAborted);
}

}  // namespace skein::decision_node
