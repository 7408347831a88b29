// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/team_member.hpp"

#include "team_core.hpp"

namespace skein::auction {

TeamMember::TeamMember(TeamSetup setup) : core_(std::make_unique<Core>(std::move(setup))) {}
TeamMember::~TeamMember() = default;
TeamMember::TeamMember(TeamMember&&) noexcept = default;
TeamMember& TeamMember::operator=(TeamMember&&) noexcept = default;

TeamEffects TeamMember::handle(const TeamInput& input, MissionTime now) {
  return core_->handle(input, now);
}
std::optional<MissionTime> TeamMember::next_wakeup() const { return core_->next_wakeup(); }
bool TeamMember::holds_token() const { return core_->holds_token(); }
bool TeamMember::are_most(const std::set<MemberNumber>& members) const {
  return core_->majority(members);
}
bool TeamMember::has_ended(const Claim& claim) const { return core_->has_ended(claim); }
const Ledger& TeamMember::ledger() const { return core_->ledger(); }

}  // namespace skein::auction
