// SPDX-License-Identifier: Apache-2.0
#include "interaction/voice.hpp"

#include <algorithm>

#include "core.hpp"
#include "role_ids.hpp"
#include "skein/decision_node/stand_in.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kSilence = Duration::milliseconds(60'000);  // as of a partner
constexpr const char* kNoGround = "no contact with the ground station, which plays its role";

bool is_about(const std::string& session, const std::string& joint) {
  return session.starts_with(joint + "/");
}

}  // namespace

// ---- of the ground ----

void Voice::say(const GroundNegotiates& said) {
  const bool known = core_.config().others.contains(said.to);
  if (said.message.from != core_.config().uav || !known) {
    return core_.bus().emit(Notice{"the ground station negotiates for '" + said.message.from +
                                   "' with '" + said.to + "': not through here"});
  }
  negotiated_.insert(said.message.terms.subject);
  core_.bus().emit(SendNegotiation{said.to, said.message});
}

// What this node has left in the ground's place stays left: the ground may not have heard of it.
void Voice::say(const GroundPlays& said) {
  const interaction::JointTaskStatus& status = said.status;
  if (status.uav != core_.config().uav) return;
  const bool over = interaction::is_over(status.phase);
  if (const auto left = given_up_.find(status.subject); left != given_up_.end()) {
    const bool anew = status.task != left->second.task;
    if (!over && !anew) return core_.bus().emit(SpokenFor{left->second, true, false});
    given_up_.erase(left);
    if (!anew) return;
  }
  if (over) {
    played_.erase(status.subject);
    std::erase_if(negotiated_, [&](const auto& one) { return is_about(one, status.subject); });
  } else {
    const auto before = played_.find(status.subject);
    const bool forgot = status.phase == interaction::JointPhase::kLoading &&
                        before != played_.end() &&
                        before->second.phase != interaction::JointPhase::kLoading;
    if (forgot) abort_begun();
    played_[status.subject] = status;
  }
  core_.bus().emit(SpokenFor{status, false, true});
}

void Voice::contact(const Contact& contact) {
  if (!contact.ground) return;
  if (contact.reachable) {
    silent_since_.reset();
  } else if (!silent_since_) {
    silent_since_ = core_.bus().now();
  }
}

// ---- of partners ----

// A session of the ground's may be heard of before the joint task that it is about.
bool Voice::is_negotiated_for(const std::string& about) const {
  return negotiated_.contains(about) ||
         std::any_of(played_.begin(), played_.end(),
                     [&](const auto& one) { return is_about(about, one.first); });
}

bool Voice::passes_on(const interaction::SessionMessage& message) {
  if (!is_negotiated_for(message.terms.subject)) return false;
  core_.bus().emit(NegotiationPassedOn{message});
  return true;
}

bool Voice::passes_on(const JointTaskTold& told) {
  if (!played_.contains(told.status.subject)) return false;
  core_.bus().emit(PartnerPassedOn{told.status});
  return true;
}

bool Voice::passes_on(const PartnerSeen& seen) {
  if (played_.empty()) return false;
  core_.bus().emit(TelemetryPassedOn{seen.telemetry});
  return true;
}

// ---- what happens ----

// At degree 1 they are the ground's own.
void Voice::task_changed(const executive::TaskEvent& event) {
  if (executive::is_terminal(event.state))
    begun_.erase(event.id);
  else if (is_of_role(event.id) && (core_.degree() == 2 || core_.degree() == 3))
    begun_.insert(event.id);
}

void Voice::abort_begun() {
  for (const executive::TaskId task : std::exchange(begun_, {}))
    core_.execution().run(executive::Abort{task});
}

void Voice::vehicle_told(const world::Telemetry& telemetry) {
  std::vector<std::string> told;
  for (const auto& [subject, status] : played_) {
    for (const auto& [partner, role] : status.holders) {
      const bool is_new = std::find(told.begin(), told.end(), partner) == told.end();
      if (partner == core_.config().uav || !is_new) continue;
      told.push_back(partner);
      core_.bus().emit(ShareTelemetry{partner, telemetry});
    }
  }
}

void Voice::time_passes() {
  const auto at = next_wakeup();
  if (!at || *at > core_.bus().now()) return;
  give_up(kNoGround);
  abort_begun();
}

std::optional<MissionTime> Voice::next_wakeup() const {
  if (!silent_since_ || played_.empty()) return std::nullopt;
  return *silent_since_ + kSilence;
}

void Voice::give_up(const std::string& why) {
  for (auto& [subject, status] : std::exchange(played_, {})) {
    status.phase = interaction::JointPhase::kAborted;
    status.why = why;
    status.active_blocks.clear();
    status.violated.clear();
    core_.bus().emit(SpokenFor{status, true, true});
    given_up_[subject] = std::move(status);
  }
}

}  // namespace skein::decision_node
