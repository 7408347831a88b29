// SPDX-License-Identifier: Apache-2.0
// Members that share an area agree on who maps what.
#include "interaction/interaction.hpp"
#include "interaction/role_talks.hpp"
#include "interaction/role_tasks.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;
using Word = interaction::Status::Word;

// A session. In half of it each reckons the division, beside whatever its computer has to do.
constexpr Duration kSharing = Duration::milliseconds(120'000);

// At first the area that the action names, or what is left of it to those who are at it; then what
// is nobody's any more.
interaction::Rows what_to_share(const AreaShare& share, const RolePlay& play,
                                const std::string& action, const world::World& world) {
  if (share.agreed() || share.comes_later()) return share.to_share();
  const interaction::Automaton& automaton = play.automaton();
  const config::Value* named = automaton[*automaton.find(action)].action()->in.find("area");
  const auto zone = named == nullptr ? std::nullopt : zone_of(*named, play.scope(), world);
  return zone ? interaction::Rows{interaction::row_of(kArea, *zone)} : interaction::Rows{};
}

std::vector<world::Polygon> areas_in(const interaction::Rows& parameters) {
  std::vector<world::Polygon> areas;
  for (const interaction::Row& row : parameters)
    if (row.name == kArea) areas.push_back(interaction::polygon_of(row));
  return areas;
}

}  // namespace

void RoleTalks::share_area(const std::string& action) {
  interaction::BeginNegotiation begin = session(action, kAreaSharing, kSharing);
  begin.parameters = what_to_share(share_, course_.play(), action, *host_.world());
  const std::vector<world::Polygon> areas = areas_in(begin.parameters);
  begin.parameters.push_back({interaction::kDivisions, "", {double(share_.divisions())}});
  if (begin.members.size() == 1 || (share_.comes_later() && areas.empty())) {
    sharing_.stop();
    share_.take(areas);
    return course_.tell_status(action, Word::kEnded);
  }
  sharing_.ask(action, now());  // it may fail at once
  if (!sharing_.lasts(now()) && task_.companions().all_have_begun()) {
    const std::string why = sharing_.why();
    sharing_.stop();
    return task_.leave("the area could not be shared: " + why);
  }
  actions_[action] = begin.subject;
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  sharing_.stop();
  actions_.erase(action);
  // Nothing was left to whoever was lost, and nobody asks for more.
  if (areas.empty() && share_.agreed()) return course_.tell_status(action, Word::kEnded);
  record_.failed(action, "the area cannot be shared");
  course_.tell_status(action, Word::kAborted);
}

void RoleTalks::area_shared(const interaction::Terms& terms,
                            const interaction::NegotiationOutcome& outcome) {
  const std::optional<std::string> action = action_about(terms.subject);
  if (outcome.kind == Kind::kAgreed) {
    share_.agree(outcome.result, terms.parameters);
    if (action) {
      actions_.erase(*action);
      sharing_.stop();
      course_.tell_status(*action, Word::kEnded);
    }
    return lose_who_has_left(outcome.result);
  }
  if (!action) return;
  note("the area is not shared yet: " + outcome.why);
  sharing_.not_agreed(outcome.why, now());
}

// Word that somebody left may be here before the word that all agreed.
void RoleTalks::lose_who_has_left(const interaction::Rows& parts) {
  bool lost = false;
  for (const interaction::Row& part : parts) {
    if (part.name == self_ || my_.holders.contains(part.name)) continue;
    share_.lose(part.name);
    lost = true;
  }
  if (lost) course_.tell(interaction::Message{kMemberLost});
}

}  // namespace skein::decision_node
