// SPDX-License-Identifier: Apache-2.0
// The long computations of the supervisor, as jobs: values in, values out.
#pragma once

#include <cstdint>
#include <functional>
#include <variant>

#include "skein/supervisor/insertion.hpp"
#include "skein/supervisor/repair.hpp"

namespace skein::supervisor {

using DeliberationRequest = std::variant<InsertionRequest, RepairRequest>;
using DeliberationResult = std::variant<InsertionOutcome, RepairOutcome>;

/// Carries out one job, in any thread: shares nothing with others except the immutable data that
/// the request points to. `time_is_up`, if given, is polled during the search; once it returns
/// true, the result is the best plan found so far, or that there is none.
DeliberationResult deliberate(const DeliberationRequest& request,
                              std::function<bool()> time_is_up = {});

}  // namespace skein::supervisor
