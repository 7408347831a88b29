// SPDX-License-Identifier: Apache-2.0
#include "interaction/interaction.hpp"

#include <algorithm>
#include <utility>

#include "interaction/role_air.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::decision_node {

namespace {

constexpr std::uint32_t kMission = 1;
/// What is over is tried again within minutes, if at all.
constexpr Duration kForgotten = Duration::milliseconds(3'600'000);

using Kind = interaction::NegotiationOutcome::Kind;

}  // namespace

Interaction::Interaction(JointHost& host)
    : host_(host), sightings_(host.config().uav), strange_(host) {}

void Interaction::start() {
  manager_.emplace(host_.config().uav, kMission, interaction::standard_modalities(),
                   interaction::NegotiationLimits{}, host_.bus().now());
}

// ---- joint tasks ----

void Interaction::load(const supervisor::LoadJointTask& asked) {
  forget_what_is_over();
  const auto known = tasks_.find(asked.task.id);
  if (asked.preferences.empty()) {
    if (known != tasks_.end()) known->second->leave("it is not wanted any more");
    return;
  }
  auto joint = joint_of(asked.task, host_.config().interaction, host_.config().uav,
                        host_.config().others.names());
  if (!joint) {
    return host_.answered({asked.task.id, false, {}, joint.error().why, {}});
  }
  if (const auto* seen = sightings_.own(); seen != nullptr) {
    const std::string why = no_role_for(*joint, host_.config().knowledge->vehicle, seen->state);
    if (!why.empty()) {
      strange_.decline(*joint, why);
      return host_.answered({asked.task.id, false, {}, why, {}});
    }
  }
  strange_.wanted(*joint);
  // Later than foreseen is better than not at all, where nothing forbids it.
  std::vector<mission::Interval> preferences = asked.preferences;
  if (!preferences.empty() && !asked.task.time.start_before) {
    preferences.push_back({preferences.front().least, Duration::max()});
  }
  // The plan may have been made anew meanwhile: what it asks for is the same with another number.
  const auto same = std::find_if(tasks_.begin(), tasks_.end(), [&](const auto& one) {
    return one.second->joint().subject == joint->subject && is_to_begin(one.second->phase());
  });
  if (same != tasks_.end()) {
    auto moved = tasks_.extract(same);
    moved.key() = asked.task.id;
    return tasks_.insert(std::move(moved))
        .position->second->ask_again(asked.task.id, std::move(preferences));
  }
  const EarlierAttempts before = attempts_at(joint->subject);
  auto& task = tasks_[asked.task.id];
  task = std::make_unique<JointTask>(host_, *this, std::move(*joint), std::move(preferences),
                                     sightings_);
  task->load(before);
}

EarlierAttempts Interaction::attempts_at(const std::string& subject) const {
  EarlierAttempts all;
  for (const auto& [id, task] : tasks_) {
    if (task->joint().subject != subject) continue;
    const EarlierAttempts one = task->before();
    all.has_run = all.has_run || one.has_run;
    all.waits_since = earliest(all.waits_since, one.waits_since);
    all.asked_at = earliest(all.asked_at, one.asked_at);
    all.engaged.insert(one.engaged.begin(), one.engaged.end());
  }
  return all;
}

// With the refusals of its partners; and those of which no task was ever asked for here.
void Interaction::forget_what_is_over() {
  const MissionTime now = host_.bus().now();
  std::erase_if(tasks_, [&](const auto& one) {
    const auto since = one.second->over_since();
    return since && *since + kForgotten <= now;
  });
  std::set<std::string> subjects;
  for (const auto& [id, task] : tasks_) subjects.insert(task->asked().subject);
  strange_.forget(subjects, kForgotten);
  refusals_.forget(subjects, kForgotten, now);
}

// What was loaded has told its partners.
void Interaction::given_up(const mission::HighLevelTask& goal, const std::string& why) {
  forget_what_is_over();
  const auto& library = host_.config().interaction;
  if (library == nullptr || !library->models.contains(goal.name)) return;
  const auto joint = joint_of(as_planned(goal, *library), library, host_.config().uav,
                              host_.config().others.names());
  const auto is_it = [&](const auto& one) { return one.second->asked().subject == joint->subject; };
  if (joint && std::ranges::none_of(tasks_, is_it)) strange_.decline(*joint, why);
}

std::optional<MissionTime> Interaction::engaged_until(executive::TaskId task) const {
  std::optional<MissionTime> until;
  for (const executive::TaskId earlier : host_.joint_tasks_before(task)) {
    const auto found = tasks_.find(earlier);
    const auto one = found == tasks_.end() ? std::nullopt : found->second->not_agreed_until();
    if (one) until = std::max(until.value_or(*one), *one);
  }
  return until;
}

void Interaction::phase_changed() {
  host_.bus().post([this] {
    for (const auto& [id, task] : tasks_) task->look_at_earlier();
  });
}

void Interaction::due(executive::TaskId task, bool interrupt) {
  const auto found = tasks_.find(task);
  if (found == tasks_.end()) return;
  host_.bus().post(
      [&joint = *found->second, interrupt] { interrupt ? joint.interrupted() : joint.due(); });
}

void Interaction::leave(executive::TaskId task, const std::string& why) {
  const auto found = tasks_.find(task);
  if (found != tasks_.end()) found->second->leave(why);
}

bool Interaction::is_over(executive::TaskId task) const {
  const auto found = tasks_.find(task);
  return found == tasks_.end() || found->second->over();
}

bool Interaction::needs_no_place(executive::TaskId task) const {
  const auto found = tasks_.find(task);
  return found != tasks_.end() && found->second->needs_no_place();
}

void Interaction::leave_all(const std::string& why) {
  for (const auto& [id, task] : tasks_) task->leave_at_once(why);
}

executive::TaskId Interaction::next_id() {
  return executive::TaskId(host_.first_role_id().value() + ids_.next(host_.bus().now()));
}

// Of one that is being left there is a next one already, when its plan is made anew.
JointTask* Interaction::about(const std::string& subject) {
  JointTask* leaving = nullptr;
  for (const auto& [id, task] : tasks_) {
    if (task->over() || !task->joint().has(subject)) continue;
    if (task->phase() != interaction::JointPhase::kLeaving) return task.get();
    leaving = task.get();
  }
  return leaving;
}

// ---- what happens ----

void Interaction::task_changed(const executive::TaskEvent& event) {
  for (const auto& [id, task] : tasks_) {
    if (!task->over()) task->task_changed(event);
  }
}

// The way of a role was looked at when it began.
void Interaction::give_up_closed_ways(const world::VehicleState& state) {
  const bool plays = std::any_of(tasks_.begin(), tasks_.end(),
                                 [](const auto& one) { return !one.second->over(); });
  const auto world = plays ? host_.world() : nullptr;
  const auto before = std::exchange(flights_, {});
  if (world == nullptr) return;
  for (const mission::HeldTask& one : host_.held()) {
    const executive::TaskId id = one.task.id;
    const bool flies = id >= host_.first_role_id() && id < functional::kFirstOwnId &&
                       one.task.type == "goto" && one.state == executive::TaskState::kRunning;
    if (!flies) continue;
    const auto known = before.find(id);
    const auto& from = flights_[id] = known == before.end() ? state.position : known->second;
    const world::Volume* closed =
        closed_ahead(one.task.parameters, from, state, host_.config().knowledge->vehicle,
                     world->volumes, host_.bus().now());
    if (closed == nullptr) continue;
    host_.bus().emit(Notice{"goto " + std::to_string(id.value()) +
                            " of a role is given up: volume '" + closed->name +
                            "' closes on its way"});
    aborts_.note(id, AbortedFor::kAir);
    host_.run(executive::Abort{id});
  }
}

void Interaction::vehicle_told(const world::Telemetry& telemetry) {
  sightings_.see(telemetry);
  give_up_closed_ways(telemetry.state);
  for (const auto& [id, task] : tasks_) {
    if (task->over()) continue;
    for (const std::string& partner : task->asked().others(host_.config().uav)) {
      host_.bus().emit(ShareTelemetry{partner, telemetry});
    }
    task->watch();
  }
}

void Interaction::place_told(const mission::ChangeWorld& told) {
  if (told.place) sightings_.see(*told.place);
}

void Interaction::hear(const PartnerSeen& seen) { sightings_.see(seen.telemetry); }

void Interaction::hear(const JointTaskTold& told) {
  using interaction::JointPhase;
  refusals_.hear(told.status, host_.bus().now());
  bool known = false;
  for (const auto& [id, task] : tasks_) {
    if (task->joint().subject != told.status.subject) continue;
    known = true;
    task->partner_told(told.status, told.at);
  }
  const JointPhase phase = told.status.phase;
  const bool counts_on_me = (phase == JointPhase::kLoaded || phase == JointPhase::kRunning) &&
                            told.status.holders.contains(host_.config().uav);
  if (!known && counts_on_me) strange_.disown(told.status);
}

void Interaction::time_passes() {
  if (manager_) negotiate(interaction::NegotiationTick{});
  for (const auto& [id, task] : tasks_) {
    if (!task->over()) task->time_passes();
  }
}

std::optional<MissionTime> Interaction::next_wakeup() const {
  std::optional<MissionTime> next = manager_ ? manager_->next_wakeup() : std::nullopt;
  for (const auto& [id, task] : tasks_) next = earliest(next, task->next_wakeup());
  return next;
}

// ---- negotiations ----

bool Interaction::begin(const Joint& joint, interaction::BeginNegotiation negotiation) {
  if (negotiation.members.empty()) negotiation.members = joint.members;
  negotiation.model = joint.hash;
  return negotiate(negotiation);
}

void Interaction::withdraw(const std::string& subject, const std::string& why) {
  // Of what is over, or promised, there is nothing to withdraw from.
  const auto effects =
      manager_->handle(interaction::WithdrawNegotiation{subject, why}, host_.bus().now());
  if (!effects) return;
  for (const auto& one : *effects) {
    std::visit([this](const auto& effect) { carry_out(effect); }, one);
  }
}

void Interaction::hear(const interaction::SessionMessage& message) {
  if (manager_) negotiate(interaction::SessionMessageReceived{message});
}

bool Interaction::negotiate(const interaction::NegotiationInput& input) {
  const auto effects = manager_->handle(input, host_.bus().now());
  if (!effects) {
    host_.bus().emit(Notice{"negotiation: " + effects.error().why});
    return false;
  }
  for (const auto& one : *effects) {
    std::visit([this](const auto& effect) { carry_out(effect); }, one);
  }
  return true;
}

void Interaction::carry_out(const interaction::SendSessionMessage& effect) {
  host_.bus().emit(SendNegotiation{effect.to, effect.message});
}

void Interaction::carry_out(const interaction::InvitedToNegotiate& effect) {
  JointTask* task = about(effect.terms.subject);
  // Who is no member of the joint task asks nothing of it.
  const auto is_asked = [&](const std::string& uav) {
    const std::vector<std::string>& asked = task->asked().members;
    return std::ranges::find(asked, uav) != asked.end();
  };
  if (task != nullptr && !std::ranges::all_of(effect.terms.members, is_asked)) {
    return carry_out(
        interaction::MessageRejected{effect.terms.opener, effect.terms.subject,
                                     "of members " + joined(effect.terms.members, ", ") +
                                         ", not of " + joined(task->asked().members, ", ")});
  }
  host_.bus().emit(NegotiationNoted{effect.terms, "invited", {}, "", {}});
  if (task != nullptr) return task->invited(effect.terms);
  std::vector<const Joint*> loading;
  for (const auto& [id, one] : tasks_)
    if (is_to_begin(one->phase())) loading.push_back(&one->asked());
  strange_.hear(effect.terms, loading);
}

// Evaluated after what led to it is carried out.
void Interaction::carry_out(const interaction::PrepareOffer& effect) {
  host_.bus().post([this, terms = effect.terms] {
    JointTask* task = about(terms.subject);
    auto offer = task == nullptr
                     ? Result<interaction::Rows, Failure>(failure("no such joint task here"))
                     : task->offer_for(terms);
    host_.bus().emit(NegotiationNoted{terms,
                                      offer ? "offered" : "refused",
                                      offer.value_or(interaction::Rows{}),
                                      offer ? "" : offer.error().why,
                                      {}});
    negotiate(interaction::OfferPrepared{terms.id(), std::move(offer)});
  });
}

void Interaction::carry_out(const interaction::ReckonResult& effect) {
  stop_reckoning(effect.terms.subject);
  reckonings_.emplace(++last_reckoning_, effect.terms.id());
  host_.bus().emit(StartReckoning{last_reckoning_, effect.terms, effect.offers});
}

// What waits is not begun any more: else it would hold up what comes after it.
void Interaction::stop_reckoning(const std::string& subject) {
  std::erase_if(reckonings_, [&](const auto& one) {
    const bool unwanted = one.second.subject == subject;
    if (unwanted) host_.bus().emit(StopReckoning{one.first});
    return unwanted;
  });
}

void Interaction::reckoned(const ReckoningFinished& done) {
  const auto asked = reckonings_.extract(done.job);
  if (asked.empty()) return;
  negotiate(interaction::ResultReckoned{asked.mapped(), done.result});
}

void Interaction::carry_out(const interaction::NegotiationEnded& effect) {
  const interaction::NegotiationOutcome& outcome = effect.outcome;
  stop_reckoning(effect.terms.subject);
  host_.bus().emit(NegotiationNoted{effect.terms, std::string(to_text(outcome.kind)),
                                    outcome.result, outcome.why, outcome.unconfirmed});
  host_.bus().post([this, effect] {
    if (JointTask* task = about(effect.terms.subject)) task->decided(effect.terms, effect.outcome);
  });
}

void Interaction::carry_out(const interaction::NegotiationSettled& effect) {
  const interaction::NegotiationOutcome& outcome = effect.outcome;
  host_.bus().emit(NegotiationNoted{effect.terms, "settled " + std::string(to_text(outcome.kind)),
                                    outcome.result, outcome.why, outcome.unconfirmed});
  host_.bus().post([this, effect] {
    if (JointTask* task = about(effect.terms.subject)) task->decided(effect.terms, effect.outcome);
  });
}

void Interaction::carry_out(const interaction::MessageRejected& effect) {
  const auto count = rejected_.count({effect.from, effect.why});
  if (!count) return;
  host_.bus().emit(Notice{"negotiation of '" + effect.from + "' about " + effect.subject + ": " +
                          effect.why + *count});
}

}  // namespace skein::decision_node
