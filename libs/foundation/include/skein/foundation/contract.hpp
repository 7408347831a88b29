// SPDX-License-Identifier: Apache-2.0
// Contracts: a broken one is a defect in Skein itself; it stops the process loudly, in every build.
#pragma once

namespace skein::detail {
[[noreturn]] void contract_broken(const char* kind, const char* condition, const char* file,
                                  int line);
}  // namespace skein::detail

/// What a caller must guarantee.
#define SKEIN_EXPECTS(condition) \
  (static_cast<bool>(condition)  \
       ? static_cast<void>(0)    \
       : ::skein::detail::contract_broken("precondition", #condition, __FILE__, __LINE__))

/// What the function itself guarantees at this point.
#define SKEIN_ENSURES(condition) \
  (static_cast<bool>(condition)  \
       ? static_cast<void>(0)    \
       : ::skein::detail::contract_broken("invariant", #condition, __FILE__, __LINE__))
