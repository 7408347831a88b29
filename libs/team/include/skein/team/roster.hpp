// SPDX-License-Identifier: Apache-2.0
// The members of a team, by name and by number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "skein/foundation/shared_list.hpp"

namespace skein::team {

/// All voting members (UAVs and the ground station), numbered from 0; the same order for all.
class Roster {
 public:
  Roster() = default;
  explicit Roster(std::vector<std::string> members) : members_(std::move(members)) {}

  const std::vector<std::string>& names() const { return members_.values(); }
  std::optional<auction::MemberNumber> number_of(const std::string& name) const {
    const auto found = std::find(members_.begin(), members_.end(), name);
    if (found == members_.end()) return std::nullopt;
    return auction::MemberNumber(static_cast<std::uint32_t>(found - members_.begin()));
  }
  /// "?" for an unknown number.
  std::string name_of(auction::MemberNumber number) const;

 private:
  SharedList<std::string> members_;
};

struct Config {
  Roster roster;
  auction::TeamLimits limits;
  std::uint64_t seed = 1;
};

/// The setup of a member that only votes; a UAV adds its craft. Precondition: `self` is in the
/// roster.
auction::TeamSetup setup_of(const Config& config, const std::string& self);

}  // namespace skein::team
