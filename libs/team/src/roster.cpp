// SPDX-License-Identifier: Apache-2.0
#include "skein/team/roster.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::team {

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
