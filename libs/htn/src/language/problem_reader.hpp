// SPDX-License-Identifier: Apache-2.0
// Reads one (defproblem …) or (make-problem …).
#pragma once

#include "language/read_context.hpp"

namespace skein::htn {

/// A form whose parts are computed by Lisp code is left out with a warning.
void read_problem(const ReadContext& context, Expression form);

}  // namespace skein::htn
