// SPDX-License-Identifier: Apache-2.0
// Who is in a team, by name and by number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/auction/team_member.hpp"

namespace skein::team {

/// All that vote, UAVs and the ground station; numbered from 0 in their order, the same for all.
class Roster {
 public:
  Roster() = default;
  explicit Roster(std::vector<std::string> members) : members_(std::move(members)) {}

  const std::vector<std::string>& names() const { return members_; }
  std::optional<auction::MemberNumber> number_of(const std::string& name) const {
    const auto found = std::find(members_.begin(), members_.end(), name);
    if (found == members_.end()) return std::nullopt;
    return auction::MemberNumber(static_cast<std::uint32_t>(found - members_.begin()));
  }
  /// "?" of a number that nobody has.
  std::string name_of(auction::MemberNumber number) const;

 private:
  std::vector<std::string> members_;
};

struct Config {
  Roster roster;
  auction::TeamLimits limits;
  std::uint64_t seed = 1;
};

/// Of one that only votes: a UAV adds its craft. Precondition: it is in the roster.
auction::TeamSetup setup_of(const Config& config, const std::string& self);

}  // namespace skein::team
