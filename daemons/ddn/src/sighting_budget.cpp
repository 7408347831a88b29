// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn/sighting_budget.hpp"

#include <algorithm>

namespace skein::ddn {

bool SightingBudget::take(const std::string& device, MissionTime now) {
  const auto [full, is_new] = full_.try_emplace(device, now);
  const MissionTime from = std::max(full->second, now);
  if (from - now > Duration::nanoseconds(kEach.count() * (kAtOnce - 1))) return false;
  full->second = from + kEach;
  return true;
}

}  // namespace skein::ddn
