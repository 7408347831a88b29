// SPDX-License-Identifier: Apache-2.0
// Calls of the middleware that may not return.
#pragma once

#include <functional>

#include "skein/foundation/time.hpp"

namespace skein::blackboard::cyclonedds {

/// Runs `call` in a thread of its own and waits for its end, at most `limit` on the steady clock.
/// False: the call has not returned, and its thread goes on: everything that it uses must stay
/// alive.
bool returns_within(Duration limit, std::function<void()> call);

}  // namespace skein::blackboard::cyclonedds
