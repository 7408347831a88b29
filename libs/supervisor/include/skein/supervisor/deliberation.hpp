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

/// Any thread; touches nothing shared but what the request points to, which nobody changes.
/// `time_is_up`, if given, is asked now and then; once it says so, the best that was found is the
/// answer, or that there is none.
DeliberationResult deliberate(const DeliberationRequest& request,
                              std::function<bool()> time_is_up = {});

}  // namespace skein::supervisor
