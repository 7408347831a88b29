// SPDX-License-Identifier: Apache-2.0
// Reads one (defproblem …) or (make-problem …).
#pragma once

#include "read_context.hpp"

namespace skein::htn {

/// A form whose parts are computed by Lisp code is left out with a warning.
void read_problem(const ReadContext& context, Expression form);

/// Whether an expression among the facts of a problem is one: a list that begins with a name. What
/// is stray there is left out, with a warning.
bool is_fact(Expression expression);

}  // namespace skein::htn
