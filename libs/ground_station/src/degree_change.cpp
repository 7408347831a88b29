// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/degree_change.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::ground_station {

void DegreeChange::begin(CommandNumber command, const mission::ChangeDegree& wanted,
                         MissionTime until) {
  change_ = Change{command, wanted, until, std::nullopt};
}

std::optional<CommandNumber> DegreeChange::command() const {
  return change_ ? std::optional(change_->command) : std::nullopt;
}

std::optional<MissionTime> DegreeChange::until() const {
  return change_ ? std::optional(change_->until) : std::nullopt;
}

std::optional<Degree> DegreeChange::on_board(Degree told, std::optional<MissionTime> at) {
  const bool is_stale = at && told_at_ && *at <= *told_at_;
  if (is_stale) return std::nullopt;
  told_at_ = at;
  if (!change_) return told;
  change_->seen = told;
  return std::nullopt;
}

bool DegreeChange::ended(CommandNumber command, CommandState state, Degree degree) {
  if (!change_ || change_->command != command) return false;
  if (state == CommandState::kExpired) unanswered_ = change_->wanted;
  const bool acknowledged = state == CommandState::kAcknowledged;
  const bool hand_over_follows = acknowledged && change_->wanted.degree != degree;
  tells_again_ = acknowledged && !hand_over_follows;
  return !hand_over_follows;
}

DegreeChange::Meaning DegreeChange::handed_over(Degree to, Degree degree,
                                                std::optional<MissionTime> at) {
  if (at) told_at_ = std::max(*at, told_at_.value_or(*at));
  Meaning meaning;
  meaning.wanted = change_ && change_->wanted.degree == to;
  const auto asked = meaning.wanted ? std::optional(change_->wanted) : unanswered_;
  meaning.resumes = mission::deliberates(to) && asked && asked->degree == to && asked->resume;
  const bool told_again = std::exchange(tells_again_, false);
  meaning.unasked = !asked && !told_again && to == degree;
  unanswered_.reset();
  if (meaning.wanted) change_->seen.reset();
  return meaning;
}

std::optional<Degree> DegreeChange::settle() {
  SKEIN_EXPECTS(change_.has_value());
  return std::exchange(change_, std::nullopt)->seen;
}

}  // namespace skein::ground_station
