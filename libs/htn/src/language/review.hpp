// SPDX-License-Identifier: Apache-2.0
// Warnings about well-formed but suspicious domains and problems.
#pragma once

#include <cstddef>

#include "language/read_context.hpp"

namespace skein::htn {

/// Warns about the domains from `domains` on and the problems from `problems` on, and about older
/// ones as far as the new ones say more about them: tasks that nothing can do, numbers of arguments
/// that never match, predicates that nothing provides, unknown domains, static predicates that an
/// operator changes.
void review(const ReadContext& context, std::size_t domains, std::size_t problems);

}  // namespace skein::htn
