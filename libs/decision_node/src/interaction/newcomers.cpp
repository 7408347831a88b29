// SPDX-License-Identifier: Apache-2.0
#include "interaction/newcomers.hpp"

#include <algorithm>
#include <array>

#include "interaction/interaction.hpp"
#include "interaction/loading_talks.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;

/// Who cannot begin within that asks again when it can.
constexpr Duration kBeginsWithin = Duration::milliseconds(60'000);
/// By these a role is called to begin anew, with all who hold one, what they agreed on without the
/// newcomer.
constexpr std::array kCalls{"area-sharing invitation", "perception-positions invitation",
                            "relay-chain invitation"};

bool hears_calls(const interaction::Automaton& role) {
  return std::ranges::any_of(kCalls, [&](const char* call) { return listens_to(role, call); });
}

bool is_about_roles(const interaction::Terms& terms) { return terms.subject.ends_with(kRoles); }

}  // namespace

Newcomers::Newcomers(const PlaySurroundings& of, const Joint& asked, JointPlay& play,
                     Companions& companions)
    : host_(of.host),
      interaction_(of.interaction),
      task_(of.task),
      my_(of.my),
      asked_(asked),
      self_(of.host.config().uav),
      play_(play),
      companions_(companions) {}

std::vector<std::string> Newcomers::in(const interaction::Terms& terms) const {
  std::vector<std::string> all;
  for (const std::string& uav : terms.members)
    if (!my_.holders.contains(uav)) all.push_back(uav);
  return all;
}

bool Newcomers::come_by(const interaction::Terms& terms) const {
  const bool loads = is_about_roles(terms) || terms.subject.ends_with(kStart);
  return my_.phase == interaction::JointPhase::kRunning && loads && !in(terms).empty();
}

std::optional<Joint> Newcomers::with(const std::vector<std::string>& newcomers) const {
  std::vector<std::string> members = newcomers;
  for (const auto& [uav, role] : my_.holders) members.push_back(uav);
  std::sort(members.begin(), members.end());
  auto joint = among(asked_, members);
  if (!joint || joint->variant != my_.joint.variant) return std::nullopt;
  joint->task = my_.joint.task;
  return joint;
}

// A role that hears no such call does all the same whoever comes, while those answer who hear it.
bool Newcomers::are_taken_in() const {
  const RolePlay* role = play_.role();
  if (role == nullptr) return false;
  const auto may_hear = [&](const char* call) { return role->may_hear(call); };
  if (hears_calls(role->automaton())) return std::ranges::any_of(kCalls, may_hear);
  if (role->has_only_flights_left()) return false;
  return std::ranges::any_of(my_.holders, [&](const auto& one) {
    const auto& [uav, held] = one;
    return uav != self_ && hears_calls(automaton_in(*my_.joint.library, *my_.joint.variant, held));
  });
}

// Who calls others than those who are at it knows less than these do.
void Newcomers::invited(const interaction::Terms& terms) {
  const bool calls_all = std::ranges::all_of(my_.holders, [&](const auto& one) {
    return std::ranges::count(terms.members, one.first) > 0;
  });
  if (!calls_all) return;
  host_.bus().post([this, terms] {
    auto session = is_about_roles(terms) ? roles_session(asked_) : start_session(asked_);
    session.members = terms.members;
    (void)interaction_.begin(asked_, std::move(session));
  });
}

bool Newcomers::called(const interaction::Terms& terms) {
  const auto agreed = agreed_.find(terms.opener);
  if (agreed == agreed_.end()) return false;
  agreed->second.call = terms.modality + " invitation";
  return true;
}

Result<interaction::Rows, Failure> Newcomers::offer_for(const interaction::Terms& terms) const {
  if (!are_taken_in()) return failure("it is at it, and takes nobody in any more");
  if (!with(in(terms))) return failure("it is at it, in a variant for as many as there are");
  if (is_about_roles(terms)) return interaction::Rows{{my_.holders.at(self_), "", {0}}};
  for (const std::string& uav : in(terms))
    if (!agreed_.contains(uav)) return failure("'" + uav + "' has no role");
  const Duration now = host_.bus().now() - MissionTime();
  return offer_of_start({{now, now + kBeginsWithin}}, {});
}

void Newcomers::decided(const interaction::Terms& terms,
                        const interaction::NegotiationOutcome& outcome) {
  if (outcome.kind != Kind::kAgreed) return;
  const std::vector<std::string> newcomers = in(terms);
  if (!is_about_roles(terms)) {
    for (const std::string& uav : newcomers)
      if (const auto agreed = agreed_.extract(uav)) take_in(uav, agreed.mapped());
    return;
  }
  for (const interaction::Row& row : outcome.result)
    if (std::ranges::count(newcomers, row.name) > 0)
      agreed_[row.name] = {row.text, to_text(terms.id()), host_.bus().now()};
}

// In vain, if they are not heard of again.
Holders Newcomers::awaited() const {
  Holders all;
  for (const auto& [uav, agreed] : agreed_)
    if (host_.bus().now() < agreed.at + kBeginsWithin) all[uav] = agreed.role;
  return all;
}

void Newcomers::take_in(const std::string& uav, const Agreed& agreed) {
  auto joint = with({uav});
  if (!joint) return;  // somebody was lost since
  my_.joint = std::move(*joint);
  taken_in_[uav] = host_.bus().now();
  my_.holders[uav] = agreed.role;
  my_.allocation = agreed.allocation;
  companions_.begin_anew(uav);
  if (play_.role() != nullptr) play_.role()->take_in(uav, agreed.role);
  play_.mapping().share().take_in(uav);
  if (agreed.call) play_.tell(interaction::Message{*agreed.call});
  host_.bus().emit(Notice{my_.joint.subject + ": '" + uav + "' takes part again"});
  task_.announce();
}

bool Newcomers::is_from_before(const std::string& uav, MissionTime at) const {
  const auto since = taken_in_.find(uav);
  return since != taken_in_.end() && at <= since->second;
}

}  // namespace skein::decision_node
