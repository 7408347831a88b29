// SPDX-License-Identifier: Apache-2.0
// What may be wrong with a path query; private.
#pragma once

#include <optional>

#include "skein/refiners/path.hpp"

namespace skein::refiners {

/// Most relays of a query.
inline constexpr std::size_t kMostRelays = 64;

std::optional<Refusal> check(const PathQuery& query, const world::World& world);

}  // namespace skein::refiners
