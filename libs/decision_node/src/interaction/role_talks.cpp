// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_talks.hpp"

#include <algorithm>
#include <utility>

#include "interaction/agreed_places.hpp"
#include "interaction/interaction.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;
using Word = interaction::Status::Word;

constexpr const char* kRoleAllocation = "role-allocation";
constexpr Duration kReallocation = Duration::milliseconds(10'000);
// Then an area is not shared.
constexpr Duration kSharingPatience = Duration::milliseconds(240'000);
// Whoever does not answer, be it for a cut, is asked again; then the role goes on without a place.
constexpr Duration kPlacesPatience = Duration::milliseconds(30'000);
constexpr Duration kStand = Duration::milliseconds(20'000);  // of roles that were just confirmed

}  // namespace

RoleTalks::RoleTalks(const PlaySurroundings& of, const Parts& parts)
    : host_(of.host),
      interaction_(of.interaction),
      task_(of.task),
      my_(of.my),
      self_(of.host.config().uav),
      course_(parts.course),
      share_(parts.share),
      record_(parts.record),
      sharing_(kSharingPatience),
      places_(kPlacesPatience) {}

MissionTime RoleTalks::now() const { return host_.bus().now(); }

void RoleTalks::note(const std::string& text) {
  host_.bus().emit(Notice{my_.joint.subject + ": " + text});
}

void RoleTalks::begin_anew() {
  actions_.clear();
  sharing_.stop();
  places_.stop();
  undecided_.clear();
  roles_stand_until_.reset();
}

interaction::BeginNegotiation RoleTalks::session(const std::string& action,
                                                 const std::string& modality, Duration within) {
  interaction::BeginNegotiation begin;
  begin.subject = my_.joint.subject + "/" + modality;
  begin.modality = modality;
  begin.members = my_.parties_of(course_.play().role(), action, self_);
  begin.within = within;
  return begin;
}

std::optional<std::string> RoleTalks::action_about(const std::string& subject) const {
  const auto asked =
      std::ranges::find_if(actions_, [&](const auto& one) { return one.second == subject; });
  return asked == actions_.end() ? std::nullopt : std::optional(asked->first);
}

void RoleTalks::negotiate(const std::string& action) {
  const interaction::Automaton& automaton = course_.play().automaton();
  const std::string& modality = automaton[*automaton.find(action)].action()->modality;
  if (modality == kAreaSharing) return share_area(action);
  if (gives_places(modality)) return negotiate_places(action);
  if (modality != kRoleAllocation) {
    note("nobody negotiates '" + modality + "'");
    return course_.tell_status(action, Word::kAborted);
  }
  if (roles_stand_until_ && now() < *roles_stand_until_) {
    note(action + ": roles were confirmed a moment ago, and stand");
    return course_.tell_status(action, Word::kEnded);
  }
  negotiate_roles(action, modality);
}

void RoleTalks::withdraw(const std::string& action) {
  const auto negotiated = actions_.find(action);
  if (negotiated != actions_.end()) {
    interaction_.withdraw(negotiated->second, my_.why.empty() ? "left" : my_.why);
    actions_.erase(negotiated);
  }
  sharing_.stop(action);
  places_.stop(action);
  course_.tell_status(action, Word::kAborted);
}

bool RoleTalks::decided(const interaction::Terms& terms,
                        const interaction::NegotiationOutcome& outcome) {
  if (outcome.kind == Kind::kUndecided) {
    undecided_.insert(terms.subject);
    return false;
  }
  undecided_.erase(terms.subject);
  if (terms.modality == kAreaSharing) {
    area_shared(terms, outcome);
    return false;
  }
  if (gives_places(terms.modality)) {
    places_agreed(terms, outcome);
    return false;
  }
  return roles_agreed(terms, outcome);
}

// Nobody may be left who knows what became of it.
void RoleTalks::settle_anew(const std::string& action) {
  host_.bus().post([this, action] {
    if (actions_.contains(action) && !task_.over()) negotiate(action);
  });
}

// What was promised is settled with whom it was promised to. Who is left alone does not hurry to
// take all: somebody may be back before the session is over.
void RoleTalks::lose() {
  roles_stand_until_.reset();
  const std::set<std::string> undecided = std::exchange(undecided_, {});
  for (const auto& [action, subject] : std::map(actions_)) {
    if (undecided.contains(subject)) {
      settle_anew(action);
      continue;
    }
    const auto parties = my_.parties_of(course_.play().role(), action, self_);
    if (!sharing_.asks(action) || parties.size() < 2) continue;
    interaction_.withdraw(subject, "somebody is lost");
    sharing_.renew(now());
  }
}

void RoleTalks::time_passes() {
  if (const auto action = sharing_.due(now())) share_area(*action);
  if (const auto action = places_.due(now())) negotiate_places(*action);
}

std::optional<MissionTime> RoleTalks::next_wakeup() const {
  return earliest(sharing_.next(), places_.next());
}

// ---- who plays what ----

void RoleTalks::negotiate_roles(const std::string& action, const std::string& modality) {
  interaction::BeginNegotiation begin = session(action, modality, kReallocation);
  std::map<std::string, int> held;
  for (const std::string& uav : begin.members) ++held[my_.holders.at(uav)];
  for (const auto& [role, count] : held) {
    begin.parameters.push_back({role, "", {double(count), double(count)}});
  }
  actions_[action] = begin.subject;
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  actions_.erase(action);
  course_.tell_status(action, Word::kAborted);
}

bool RoleTalks::roles_agreed(const interaction::Terms& terms,
                             const interaction::NegotiationOutcome& outcome) {
  const bool is_agreed = outcome.kind == Kind::kAgreed;
  Holders agreed = my_.holders;
  if (is_agreed) {
    for (const interaction::Row& row : outcome.result) agreed[row.name] = row.text;
  }
  if (agreed != my_.holders) {
    my_.holders = std::move(agreed);
    my_.allocation = to_text(terms.id());
    return true;
  }
  if (is_agreed) roles_stand_until_ = now() + kStand;
  while (const auto action = action_about(terms.subject)) {
    actions_.erase(*action);
    course_.tell_status(*action, is_agreed ? Word::kEnded : Word::kAborted);
  }
  return false;
}

}  // namespace skein::decision_node
