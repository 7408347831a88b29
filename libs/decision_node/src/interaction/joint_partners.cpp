// SPDX-License-Identifier: Apache-2.0
// A joint task and its partners: how long they are waited for, and who leaves or is lost.
#include <algorithm>

#include "interaction/interaction.hpp"
#include "interaction/joint_task.hpp"
#include "interaction/loading_talks.hpp"
#include "interaction/role_tasks.hpp"
#include "partners.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::decision_node {

using interaction::JointPhase;

// What its supervisor plans again at once is one wait.
EarlierAttempts JointTask::before() const {
  const bool has_run = play_.role() != nullptr;
  EarlierAttempts before{my_.phase == JointPhase::kAborted && has_run, std::nullopt};
  before.engaged = time_.engaged_partners();
  const bool just_failed = over_since_ && now() <= *over_since_ + kPlannedAgain;
  if (!just_failed || has_run) return before;
  before.waits_since = time_.since(now());
  before.asked_at = asked_at_;
  return before;
}

// Its partners find out likewise; until they have, they want other members.
void JointTask::do_without_the_absent() {
  std::vector<std::string> there = asked_.members;
  std::string why;
  std::erase_if(there, [&](const std::string& uav) {
    if (uav == self_) return false;
    const auto since = interaction_.partners().silent_since(uav);
    const auto* refused = interaction_.refusals().of(asked_.subject, uav);
    const bool stands =
        refused && std::max(refused->since, asked_at_) + Companions::kLostAfter <= now();
    if (stands) why = "'" + uav + "' takes no part: " + refused->why;
    return stands || interaction_.partners().is_declared_lost(uav) ||
           (since && *since + Companions::kLostAfter <= now());
  });
  if (there == my_.joint.members) return;
  auto fewer = there.size() < 2 ? std::nullopt : among(asked_, there);
  if (!fewer) return why.empty() ? void() : not_loaded(why);
  host_.bus().emit(Notice{asked_.subject + ": it is loaded among " + joined(there, ", ") + " now"});
  my_.joint.variant = fewer->variant;
  my_.joint.members = std::move(fewer->members);
  my_.joint.arguments = std::move(fewer->arguments);
}

// Who is silent for its lease, or declared lost, is waited for no longer. Where it may be done
// without, it is: the lease is no shorter than what that takes.
void JointTask::give_up_on_partners() {
  if (!is_to_begin(my_.phase)) return;
  for (const std::string& uav : asked_.others(self_)) {
    const bool is_lost = interaction_.partners().is_declared_lost(uav);
    if (my_.phase == JointPhase::kLoaded && (!is_lost || !my_.holders.contains(uav))) continue;
    const auto why = interaction_.partners().given_up(uav, time_.since(now()), now());
    if (!why) continue;
    if (roles_known_ && my_.holders.contains(uav)) load_again(*why);
    if (!roles_known_) do_without_the_absent();
    const bool needed = std::ranges::count(my_.joint.members, uav) > 0;
    if (over()) return;
    if (needed) return not_loaded(*why);
  }
}

namespace {

// Who was not in the meetings of others would wait in its own for ever.
void meet_nobody(JointPlay& play, const std::string& self) {
  if (play.role() == nullptr) return;
  for (const auto& [uav, role] : Holders(play.role()->holders()))
    if (uav != self) play.role()->lose(uav);
  play.begin_anew(is_meeting);
}

}  // namespace

void JointTask::partner_told(const interaction::JointTaskStatus& status, MissionTime at) {
  const bool gone = status.phase == JointPhase::kLeaving || status.phase == JointPhase::kAborted ||
                    status.phase == JointPhase::kNotLoaded;
  if (status.phase == JointPhase::kLoading) time_.engage(status.uav, status.agreed_start, now());
  // What it said before the roles were agreed is about an attempt before this one.
  if (!roles_known_ || at <= agreed_at_ || newcomers_.is_from_before(status.uav, at)) return;
  const bool has_ended = status.phase == JointPhase::kEnded;
  if (has_ended) companions_.has_ended(status.uav);
  if (has_ended && my_.phase == JointPhase::kRunning && companions_.all_have_ended())
    meet_nobody(play_, self_);
  companions_.told(status);
  const bool does_without = status.phase == JointPhase::kRunning && !status.holders.empty() &&
                            !status.holders.contains(self_);
  if (does_without && my_.phase == JointPhase::kRunning) return go_on_apart(status);
  if (does_without && is_to_begin(my_.phase))
    return load_again("'" + status.uav + "' is at it without '" + self_ + "'");
  play_.mapping().share().told(status.uav, status.left);
  const bool is_engaged = status.phase == JointPhase::kLoading && status.agreed_start;
  if (is_engaged && my_.phase == JointPhase::kLoaded && at > start_agreed_at_) {
    my_.phase = JointPhase::kLoading;
    return retries_.anew(now());
  }
  if (!gone) return;
  const std::string why = "'" + status.uav + "' left: " + status.why;
  if (my_.phase == JointPhase::kRunning) return lost(status.uav, why);
  if (my_.phase == JointPhase::kLoading || my_.phase == JointPhase::kLoaded) load_again(why);
}

// It was lost there, over a link that is down or past a third one, and what it had left is theirs:
// they and this UAV do not count on each other any more.
void JointTask::go_on_apart(const interaction::JointTaskStatus& status) {
  if (outweigh(status.holders, my_.holders) &&
      play_.mapping().share().yield_to(status.uav, status.left)) {
    host_.bus().emit(
        Notice{my_.joint.subject + ": '" + status.uav + "' has some of what was its part to map"});
    play_.begin_anew(is_mapping);
  }
  for (const auto& [uav, role] : status.holders) {
    play_.mapping().share().leave_to(uav);
    lost(uav, "'" + status.uav + "' goes on without '" + self_ + "'");
  }
}

// It has not begun: the partner may come back to it.
void JointTask::load_again(const std::string& why) {
  interaction_.withdraw(my_.joint.subject + kStart, why);
  my_.phase = JointPhase::kLoading;
  my_.why = why;
  roles_known_ = false;
  my_.holders.clear();
  agreed_start_.reset();
  time_.agree(std::nullopt);
  retries_.anew(now());
  announce();
}

namespace {

/// Whether the joint task needs somebody in the role that this UAV held alone.
bool is_the_only_one(const Membership& my, const std::string& uav) {
  const std::string& role = my.holders.at(uav);
  const auto arity = my.joint.variant->table.arities.find(role);
  const auto held =
      std::ranges::count_if(my.holders, [&](const auto& one) { return one.second == role; });
  return held == 1 && arity != my.joint.variant->table.arities.end() && arity->second.least > 0;
}

}  // namespace

// It runs: without one that left, if the role can do without. Of a role that nobody else holds all
// have to agree anew.
void JointTask::lost(const std::string& uav, const std::string& why) {
  if (!my_.holders.contains(uav) || uav == self_) return;
  const bool needed = is_the_only_one(my_, uav) && !play_.has_done_its_part();
  if (!play_.goes_on_without() || needed) return leave(why);
  host_.bus().emit(Notice{my_.joint.subject + ": " + why + "; it goes on without"});
  my_.holders.erase(uav);
  play_.lose(uav);
  announce();
}

}  // namespace skein::decision_node
