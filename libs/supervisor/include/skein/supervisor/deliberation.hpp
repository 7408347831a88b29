// SPDX-License-Identifier: Apache-2.0
// The long computations of the supervisor, as jobs: values in, values out.
#pragma once

#include <cstdint>
#include <variant>

#include "skein/supervisor/insertion.hpp"
#include "skein/supervisor/repair.hpp"

namespace skein::supervisor {

using DeliberationRequest = std::variant<InsertionRequest, RepairRequest>;
using DeliberationResult = std::variant<InsertionOutcome, RepairOutcome>;

/// Any thread; touches nothing shared but what the request points to, which nobody changes.
DeliberationResult deliberate(const DeliberationRequest& request);

}  // namespace skein::supervisor
