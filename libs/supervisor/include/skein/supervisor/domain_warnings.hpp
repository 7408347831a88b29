// SPDX-License-Identifier: Apache-2.0
// What is suspicious in a planning domain, but no error.
#pragma once

#include "skein/foundation/diagnostics.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Tasks without method or operator, calls whose number of arguments matches no head, variables
/// used once: what the planner meets only when it comes there, and then as a task that cannot be
/// done. Errors are left to vocabulary_of(). Cost: reading the domain.
Diagnostics warnings_of(const DomainText& domain);

}  // namespace skein::supervisor
