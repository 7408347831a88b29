// SPDX-License-Identifier: Apache-2.0
// A joint task while it runs: what its role asks for is carried out.
#include <algorithm>

#include "interaction/interaction.hpp"
#include "interaction/places.hpp"
#include "interaction/role_tasks.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/interaction/describe.hpp"

namespace skein::decision_node {

namespace {

using interaction::ComponelState;
using interaction::JointPhase;
using Word = interaction::Status::Word;

constexpr Duration kNothing = Duration::milliseconds(500);  // of a perception: it is done

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
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

JointPlay::JointPlay(const PlaySurroundings& of)
    : host_(of.host),
      interaction_(of.interaction),
      sightings_(of.sightings),
      task_(of.task),
      my_(of.my),
      self_(of.host.config().uav),
      mapping_(of, *this),
      pursuit_(of, *this),
      talks_(of, {*this, mapping_.share(), record_}) {}

MissionTime JointPlay::now() const { return host_.bus().now(); }

Outlook JointPlay::outlook() const {
  const auto world = host_.world();  // is kept until the next input
  return {*host_.config().knowledge,
          *world,
          sightings_.observer(my_.joint.arguments, *world, now()),
          now(),
          host_.free_to_stay(),
          &refused_views_};
}

// ---- the role ----

void JointPlay::begin(const std::string& role) {
  ++plays_;
  tasks_.clear();
  record_.begin_anew();
  looks_.clear();
  pursuit_.begin_anew();
  talks_.begin_anew();
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
      std::visit(
          Overloaded{[](const interaction::Read&) {}, [this](const auto& one) { carry_out(one); }},
          effect.what);
    }
    const auto* message = std::get_if<interaction::Message>(&input);
    if (message != nullptr && message->text == kMemberLost && effects->empty())
      begin_anew(is_meeting);
    task_.announce();
  });
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
    play_->forget(effect.parameter, place.error().why);
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
  talks_.lose();
  play_->lose(uav);
  mapping_.share().lose(uav);
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
  if (my_.phase == JointPhase::kRunning) talks_.time_passes();
  const auto next = play_ ? play_->next_wakeup() : std::nullopt;
  if (next && *next <= now()) tell(interaction::Tick{});
}

std::optional<MissionTime> JointPlay::next_wakeup() const {
  const std::optional<MissionTime> next = play_ ? play_->next_wakeup() : std::nullopt;
  return my_.phase == JointPhase::kRunning ? earliest(next, talks_.next_wakeup()) : next;
}

void JointPlay::tell_of(interaction::JointTaskStatus& status) const {
  if (play_) {
    status.active_blocks = play_->active_blocks();
    status.violated = play_->violated();
  }
  status.left = mapping_.share().left();
}

// ---- its tasks ----

// Interrupted as it begins: that it is to be left comes next.
void JointPlay::run(const std::string& name) {
  if (host_.stops(my_.joint.task)) return;
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::Componel& componel = automaton[*automaton.find(name)];
  if (is_mapping(*componel.task())) return mapping_.map(name);
  if (componel.task()->type == kFollow) return pursuit_.follow(name);
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

// Where the role itself does nothing about a loss: who waited for the lost would do so for ever.
void JointPlay::begin_anew(bool (*is_meant)(const interaction::Task& task)) {
  const interaction::Automaton& automaton = play_->automaton();
  for (const auto& [id, componel] : std::map(tasks_)) {
    const bool meant = is_meant(*automaton[*automaton.find(componel)].task());
    if (!meant || interaction_.aborts().of(id) == AbortedFor::kRole) continue;
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
  pursuit_.stop(componel);
  record_.failed(componel, why);
  tell_status(componel, Word::kAborted);
  leave_if_in_vain(componel, why);
  leave_if_stuck(componel, why);
}

bool JointPlay::has_only_flights_left() const {
  return play_ && !record_.failure() && play_->has_only_flights_left();
}

bool JointPlay::nothing_is_left_together() const {
  return task_.companions().all_have_ended() && has_only_flights_left();
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
  pursuit_.stop(effect.task);
  tell_status(effect.task, Word::kAborted);
}

void JointPlay::task_changed(const executive::TaskEvent& event) {
  const auto found = tasks_.find(event.id);
  if (found == tasks_.end()) return look_changed(event);
  const std::string componel = found->second;
  if (pursuit_.follows(componel)) return flew_after(event, componel);
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
  const interaction::Automaton& automaton = play_->automaton();
  const bool maps = is_mapping(*automaton[*automaton.find(componel)].task());
  if (ended && maps && mapping_.goes_on_after(event.id)) return run(componel);
  // What lies beside that air is mapped, or it is waited for.
  const bool is_by_air = !ended && aborted == AbortedFor::kAir;
  if (is_by_air && maps && !RoleRecord::failed_at_once(ran)) return run(componel);
  const bool asked = aborted == AbortedFor::kRole;
  const bool gave_up =
      is_by_air || aborted == AbortedFor::kNothing || event.cause == executive::AbortCause::kOther;
  const bool by_vehicle = !ended && !asked && gave_up;
  if (by_vehicle && begin_again(componel, ran)) return;
  const bool has_no_air = event.cause == executive::AbortCause::kNoAir;
  const bool is_last = has_no_air && nothing_is_left_together();
  if (!ended && !asked && !is_last) record_.aborted(componel, event.reason);
  if (ended) record_.ended(componel);
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

void JointPlay::flew_after(const executive::TaskEvent& event, const std::string& componel) {
  if (!is_terminal(event.state)) return;
  pursuit_.arrived(componel);
  tasks_.erase(event.id);
  const bool asked = interaction_.aborts().take(event.id) == AbortedFor::kRole;
  if (event.state == executive::TaskState::kEnded && !asked) return;
  if (!asked) record_.aborted(componel, event.reason);
  pursuit_.stop(componel);
  tell_status(componel, Word::kAborted);
}

// Without its device a flight maps nothing.
void JointPlay::look_changed(const executive::TaskEvent& event) {
  const auto look = looks_.find(event.id);
  if (look == looks_.end() || !is_terminal(event.state)) return;
  const executive::TaskId flight = look->second;
  looks_.erase(look);
  const auto flown = tasks_.find(flight);
  const bool goes_with_it = interaction_.aborts().of(flight).has_value();
  if (flown == tasks_.end() || goes_with_it || event.state == executive::TaskState::kEnded) return;
  record_.failed(flown->second, event.reason);
  interaction_.aborts().note(flight, AbortedFor::kNothing);
  host_.run(executive::Abort{flight});
}

bool JointPlay::watch() {
  if (!play_) return false;
  mapping_.see();
  pursuit_.look();
  const auto own = position_of(sightings_.own()->state.position);
  for (const interaction::ScmFound& found : play_->watch(own, outlook().observer, now())) {
    host_.bus().emit(ScmNoted{my_.joint.subject, play_->role(), found});
    tell(found.report);
  }
  return true;
}

// ---- its negotiations ----

// Roles that are others now are begun anew.
void JointPlay::decided(const interaction::Terms& terms,
                        const interaction::NegotiationOutcome& outcome) {
  if (my_.phase != JointPhase::kRunning) return;
  if (!talks_.decided(terms, outcome)) return;
  next_role_ = my_.holders.at(self_);
  tell(interaction::Abort{});
  task_.announce();
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
