// SPDX-License-Identifier: Apache-2.0
// Checks of path queries before the search.
#pragma once

#include <optional>

#include "skein/refiners/path.hpp"

namespace skein::sampling {

std::optional<refiners::Refusal> check_query(const refiners::PathQuery& query,
                                             const world::World& world);

}  // namespace skein::sampling
