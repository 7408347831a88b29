// SPDX-License-Identifier: Apache-2.0
// Loading, and the end.
#include "interaction/joint_task.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interaction/agreed_places.hpp"
#include "interaction/interaction.hpp"
#include "interaction/loading_talks.hpp"
#include "interaction/places.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::decision_node {

namespace {

using interaction::JointPhase;
using Kind = interaction::NegotiationOutcome::Kind;

// What is agreed must still be possible when it is agreed: a start that was not is offered so much
// later, twice as much each time.
constexpr Duration kAhead = Duration::milliseconds(5'000);
constexpr Duration kFurthestAhead = Duration::milliseconds(60'000);
constexpr double kSameBeginning = 25;  // [m] what a refusal depends on is the same

/// Why nothing was agreed, who asks for it otherwise, and who is silent.
std::string why_too_late(const Membership& my, const std::string& self, Interaction& interaction) {
  const Partners& partners = interaction.partners();
  std::string why = my.why;
  const std::string otherwise = interaction.strange().asked_otherwise(my.joint.subject);
  if (!otherwise.empty()) why += (why.empty() ? "" : "; ") + otherwise;
  for (const std::string& uav : my.joint.members) {
    const auto since = uav == self ? std::nullopt : partners.silent_since(uav);
    if (!since) continue;
    why += (why.empty() ? "'" : "; '") + uav + "' is not heard since " +
           std::to_string(std::lround(since->to_seconds())) + " s";
  }
  return why;
}

/// When its negotiation is tried again; absent: not by itself. While this UAV is engaged it asks
/// for no start.
std::optional<MissionTime> tries_at(const Membership& my, const Retries& retries, bool waits) {
  return my.phase == JointPhase::kLoading && !waits ? retries.at() : std::nullopt;
}

/// Until it has only flights left.
bool needs_partners(const Membership& my, const JointPlay& play) {
  return my.phase == JointPhase::kRunning && !play.has_only_flights_left();
}

}  // namespace

JointTask::JointTask(JointHost& host, Interaction& interaction, Joint joint,
                     std::vector<mission::Interval> preferences, const Sightings& sightings)
    : host_(host),
      interaction_(interaction),
      sightings_(sightings),
      self_(host.config().uav),
      preferences_(std::move(preferences)),
      asked_(joint),
      my_{std::move(joint)},
      companions_(host.partners(), my_, self_),
      play_({host, interaction, sightings, *this, my_}),
      newcomers_({host, interaction, sightings, *this, my_}, asked_, play_, companions_) {}

MissionTime JointTask::now() const { return host_.bus().now(); }

// ---- loading ----

// What has failed is looked at again when the plan is made anew, and may be in it again.
std::optional<MissionTime> JointTask::not_agreed_until() const {
  const bool is_agreed = my_.phase == JointPhase::kLoaded || my_.phase == JointPhase::kRunning ||
                         my_.phase == JointPhase::kEnded;
  return is_agreed ? std::nullopt : std::optional(time_.waits_until());
}

// A start that was agreed does not stand while an earlier joint task is not agreed on any more.
void JointTask::look_at_earlier() {
  if (!is_to_begin(my_.phase)) return;
  const bool was_engaged = time_.engaged().has_value();
  time_.engage(interaction_.engaged_until(my_.joint.task));
  if (was_engaged && !time_.engaged()) time_.put_off(preferences_, now());
  const bool is_wrong = time_.engaged() && my_.phase == JointPhase::kLoaded;
  if (is_wrong) my_.phase = JointPhase::kLoading;
  if (is_wrong || (was_engaged && !time_.engaged() && retries_.at())) retries_.anew(now());
  announce();
}

void JointTask::load(const EarlierAttempts& before) {
  asked_at_ = before.asked_at.value_or(now());
  time_.follows(before);
  time_.plan(preferences_, now());
  do_without_the_absent();
  give_up_on_partners();
  if (!over()) interaction_.begin(my_.joint, roles_session(my_.joint));
  announce();
}

void JointTask::ask_again(executive::TaskId task, std::vector<mission::Interval> preferences) {
  if (task != my_.joint.task) dispatched_ = false;
  my_.joint.task = task;
  preferences_ = std::move(preferences);
  answered_ = false;
  time_.plan(preferences_, now());
  if (my_.phase == JointPhase::kLoaded) {
    const Duration start = *agreed_start_ - MissionTime();
    const bool keeps = std::any_of(
        preferences_.begin(), preferences_.end(),
        [&](const mission::Interval& one) { return one.least <= start && start <= one.most; });
    if (keeps) {
      ahead_ = {};
      answer();
    } else {
      my_.phase = JointPhase::kLoading;
      my_.why = "it cannot begin any more when it was agreed";
      ahead_ = std::clamp(ahead_ + ahead_, kAhead, kFurthestAhead);
      interaction_.begin(my_.joint, start_session(my_.joint));
    }
  } else if (roles_known_ && retries_.at()) {
    retries_.anew(now());
  }
  announce();
}

world::VehicleState JointTask::where_it_begins() const {
  const world::VehicleState& seen = sightings_.own()->state;
  return is_to_begin(my_.phase) ? host_.when_it_begins(my_.joint.task, seen) : seen;
}

Result<interaction::Rows, Failure> JointTask::offer_for(const interaction::Terms& terms) const {
  if (over()) return failure("it is over here: " + my_.why);
  if (newcomers_.come_by(terms)) return newcomers_.offer_for(terms);
  if (terms.modality == "time-interval") {
    if (is_to_begin(my_.phase) && interaction_.engaged_until(my_.joint.task))
      return failure("a joint task before this one is not agreed on yet");
    return offer_of_start(preferences_, ahead_);
  }
  if (sightings_.own() == nullptr) return failure("it does not know where it is");
  if (terms.modality == kAreaSharing) {
    if (!my_.holders.contains(self_)) return failure("it holds no role");
    return play_.mapping().offer(terms);
  }
  const Outlook outlook = play_.outlook();
  if (gives_places(terms.modality)) return offer_of_places(terms, sightings_.own()->state, outlook);
  return offer_of_roles(terms, {host_, sightings_, my_, where_it_begins(), outlook});
}

void JointTask::decided(const interaction::Terms& terms,
                        const interaction::NegotiationOutcome& outcome) {
  if (over()) return;
  const bool loads =
      terms.subject == my_.joint.subject + kRoles || terms.subject == my_.joint.subject + kStart;
  if (!loads) return play_.decided(terms, outcome);
  if (newcomers_.come_by(terms)) return newcomers_.decided(terms, outcome);
  if (my_.phase != JointPhase::kLoading) return;
  if (outcome.kind == Kind::kFailed) {
    not_agreed(outcome.why);
  } else if (outcome.kind == Kind::kUndecided) {
    my_.why = outcome.why;  // it may be settled yet
  } else if (terms.subject == my_.joint.subject + kRoles) {
    roles_agreed(terms, outcome.result);
  } else if (roles_known_) {
    start_agreed(outcome.result);
  }
  announce();
}

void JointTask::roles_agreed(const interaction::Terms& terms, const interaction::Rows& result) {
  for (const interaction::Row& row : result) my_.holders[row.name] = row.text;
  my_.allocation = to_text(terms.id());
  agreed_at_ = now();
  companions_.begin_anew();
  roles_known_ = true;
  interaction_.begin(my_.joint, start_session(my_.joint));
}

void JointTask::start_agreed(const interaction::Rows& result) {
  const MissionTime start = MissionTime::seconds(result.front().numbers[0]);
  const bool known = answered_ && agreed_start_ == start;
  start_agreed_at_ = now();
  agreed_start_ = start;
  time_.agree(start);
  my_.phase = JointPhase::kLoaded;
  my_.why.clear();
  if (!known) answer();
  announce();  // also where it has passed already
  begin_if_due();
}

// Who cannot begin by then begins later: the others wait for it where their roles meet first.
void JointTask::answer() {
  answered_ = true;
  supervisor::JointTaskAnswered answer{
      my_.joint.task, true, {*agreed_start_ - MissionTime(), Duration::max()}, "", {}};
  if (sightings_.own() != nullptr) {
    const auto cost = cost_of(my_.joint, my_.holders.at(self_), where_it_begins(), play_.outlook());
    if (cost) answer.takes = {Duration::seconds(cost->seconds), cost->energy};
  }
  host_.answered(answer);
}

void JointTask::not_agreed(const std::string& why) {
  my_.why = why;
  if (retries_.failed(why, now()))
    host_.bus().emit(Notice{my_.joint.subject + " is not agreed on, and is tried until " +
                            std::to_string(std::lround(time_.until().to_seconds())) +
                            " s: " + why});
  if (now() + Retries::kOftenest > time_.until())
    not_loaded(why_too_late(my_, self_, interaction_));
}

void JointTask::not_loaded(const std::string& why) {
  my_.why = why.empty() ? "nothing was agreed" : why;
  if (answered_) return finish(JointPhase::kAborted);
  my_.phase = JointPhase::kNotLoaded;
  over_since_ = now();
  host_.answered({my_.joint.task, false, {}, my_.why, {}});
}

// ---- carrying out ----

void JointTask::due() {
  dispatched_ = true;
  if (my_.phase == JointPhase::kAborted) return finish(JointPhase::kAborted);
  begin_if_due();  // while it loads, and when that fails, the supervisor answers
}

void JointTask::begin_if_due() {
  if (!dispatched_ || my_.phase != JointPhase::kLoaded || now() < *agreed_start_) return;
  my_.phase = JointPhase::kRunning;
  host_.run(executive::FunctionalStatus{my_.joint.task, executive::TaskState::kRunning, ""});
  play_.begin(my_.holders.at(self_));
}

void JointTask::task_changed(const executive::TaskEvent& event) {
  if (event.id == my_.joint.task && is_terminal(event.state)) {
    return leave(event.reason.empty() ? "aborted" : event.reason);
  }
  play_.task_changed(event);
}

void JointTask::watch() {
  if (sightings_.own() == nullptr) return;
  if (my_.phase == JointPhase::kRunning && play_.watch()) announce();
  const auto world = my_.phase == JointPhase::kLoading ? host_.world() : nullptr;
  if (world == nullptr) return;
  const double circle = 2 * host_.config().knowledge->vehicle.orbit_radius;
  retries_.see({where_it_begins().position, world->volumes, sightings_.own()->failed},
               kSameBeginning + circle, now());
}

// ---- partners ----

// Who cannot begin when it was agreed asks for another start, and who waits to ask for one answers
// whoever asks first; who knows nothing of roles that were agreed has lost its memory.
void JointTask::invited(const interaction::Terms& terms) {
  if (terms.subject == my_.joint.subject + kRoles) {
    const bool anew = roles_known_ && terms.opened > agreed_at_ &&
                      !newcomers_.is_from_before(terms.opener, terms.opened);
    const std::string why = "'" + terms.opener + "' asks for roles anew";
    if (anew && is_to_begin(my_.phase)) load_again(why);
    const bool forgot = my_.phase == JointPhase::kRunning && companions_.counts_on(terms.opener);
    if (anew && forgot) lost(terms.opener, why);
  }
  if (newcomers_.come_by(terms)) return newcomers_.invited(terms);
  if (terms.subject == my_.joint.subject + kRoles) return;
  if (terms.subject == my_.joint.subject + kStart) {
    const bool anew = roles_known_ && terms.opened > start_agreed_at_;
    const bool waits = my_.phase != JointPhase::kLoading || retries_.at();
    if (!anew || !waits || my_.phase > JointPhase::kRunning) return;
    if (is_to_begin(my_.phase)) my_.phase = JointPhase::kLoading;
    retries_.tried();
    return host_.bus().post([this] { interaction_.begin(my_.joint, start_session(my_.joint)); });
  }
  // Who has been lost here calls others than those who go on.
  if (my_.phase != JointPhase::kRunning || newcomers_.called(terms)) return;
  if (!my_.holders.contains(terms.opener)) return;
  // Whom the others do not count on any more is lost here too.
  for (const auto& [uav, role] : Holders(my_.holders)) {
    const bool in = std::count(terms.members.begin(), terms.members.end(), uav) > 0;
    if (terms.modality == kAreaSharing && !in) lost(uav, "the others go on without it");
  }
  play_.tell(interaction::Message{terms.modality + " invitation"});
  announce();
}

// ---- time ----

void JointTask::time_passes() {
  const auto at = tries_at(my_, retries_, roles_known_ && time_.engaged());
  if (at && *at <= now()) {
    retries_.tried();
    // Those who are at it do without who is lost to them, and wait for this UAV.
    if (roles_known_ && companions_.some_have_begun())
      for (const auto& [uav, why] : companions_.lost(now())) load_again(why);
    if (!roles_known_) do_without_the_absent();
    const Joint& joint = my_.joint;
    if (my_.phase == JointPhase::kLoading)
      interaction_.begin(joint, roles_known_ ? start_session(joint) : roles_session(joint));
  }
  give_up_on_partners();
  if (my_.phase == JointPhase::kLoading && time_.until() <= now())
    not_loaded(why_too_late(my_, self_, interaction_));
  begin_if_due();
  if (needs_partners(my_, play_))
    for (const auto& [uav, why] : companions_.lost(now())) lost(uav, why);
  play_.time_passes();
  look_at_earlier();
  announce();
}

std::optional<MissionTime> JointTask::next_wakeup() const {
  if (over()) return std::nullopt;
  std::optional<MissionTime> next = play_.next_wakeup();
  if (my_.phase == JointPhase::kLoading)
    next = earliest(
        next, earliest(tries_at(my_, retries_, roles_known_ && time_.engaged()), time_.until()));
  if (my_.phase == JointPhase::kLoaded && dispatched_) next = earliest(next, agreed_start_);
  if (my_.phase == JointPhase::kLoading)
    next = earliest(next, companions_.next_given_up(time_.since(now())));
  return needs_partners(my_, play_) ? earliest(next, companions_.next_loss(now())) : next;
}

// ---- the end ----

void JointTask::interrupted() {
  if (!answered_) dispatched_ = false;
  leave("interrupted");
}

void JointTask::leave(const std::string& why) {
  if (over() || my_.phase == JointPhase::kLeaving) return;
  my_.why = why;
  if (play_.role() == nullptr) return finish(JointPhase::kAborted);
  my_.phase = JointPhase::kLeaving;
  announce();
  play_.leave();
}

// As for one whose last flight gets no air: what was to be done together is done. Mostly the role
// is over by the end of its tasks.
void JointTask::leave_at_once(const std::string& why) {
  if (over()) return;
  const bool is_done = my_.phase == JointPhase::kRunning && play_.nothing_is_left_together();
  my_.why = is_done ? "" : why;
  play_.abort_tasks(is_done);
  if (!over()) finish(is_done ? JointPhase::kEnded : JointPhase::kAborted);
}

void JointTask::finish(interaction::JointPhase phase) {
  const bool loading = my_.phase == JointPhase::kLoading;
  my_.phase = phase;
  over_since_ = now();
  if (loading) {
    interaction_.withdraw(my_.joint.subject + (roles_known_ ? kStart : kRoles), my_.why);
  }
  if (dispatched_) {
    const bool ended = phase == JointPhase::kEnded;
    host_.run(executive::FunctionalStatus{
        my_.joint.task, ended ? executive::TaskState::kEnded : executive::TaskState::kAborted,
        ended ? "" : my_.why});
  }
  announce();
}

void JointTask::announce() {
  interaction::JointTaskStatus status = status_of(my_.joint, self_);
  status.phase = my_.phase;
  status.why = my_.why;
  status.holders = my_.holders;
  if (my_.phase == JointPhase::kRunning) status.holders.merge(newcomers_.awaited());
  play_.tell_of(status);
  if (needs_partners(my_, play_))
    for (interaction::Row& row : companions_.silent(now())) status.left.push_back(std::move(row));
  status.agreed_start = time_.engaged() ? time_.engaged() : agreed_start_;
  if (told_ == status) return;
  const bool moved = !told_ || told_->phase != status.phase;
  told_ = status;
  if (moved) interaction_.phase_changed();
  host_.bus().emit(JointTaskChanged{std::move(status), asked_.others(self_)});
}

}  // namespace skein::decision_node
