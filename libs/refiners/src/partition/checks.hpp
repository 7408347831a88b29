// SPDX-License-Identifier: Apache-2.0
// Checks of a partition query.
#pragma once

#include <optional>

#include "skein/refiners/partition.hpp"

namespace skein::refiners {

/// Most members of a query.
inline constexpr std::size_t kMostMembers = 64;

/// The first fault of the query, if any.
std::optional<Refusal> check_partition(const PartitionQuery& query, const world::World& world);

}  // namespace skein::refiners
