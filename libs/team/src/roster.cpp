// SPDX-License-Identifier: Apache-2.0
#include "skein/team/roster.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::team {

std::optional<auction::MemberNumber> Roster::number_of(const std::string& name) const {
  const auto found = std::find(members_.begin(), members_.end(), name);
  if (found == members_.end()) return std::nullopt;
  return auction::MemberNumber(static_cast<std::uint32_t>(found - members_.begin()));
}

std::string Roster::name_of(auction::MemberNumber number) const {
  return number.value() < members_.size() ? members_[number.value()] : "?";
}

auction::TeamSetup setup_of(const Config& config, const std::string& self) {
  const auto number = config.roster.number_of(self);
  SKEIN_EXPECTS(number.has_value());
  auction::TeamSetup setup;
  setup.self = *number;
  for (std::uint32_t i = 0; i < config.roster.names().size(); ++i) {
    setup.roster.emplace_back(i);
    setup.names.emplace(setup.roster.back(), config.roster.names()[i]);
  }
  setup.limits = config.limits;
  setup.seed = config.seed;
  return setup;
}

}  // namespace skein::team
