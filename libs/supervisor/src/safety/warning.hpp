// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "skein/foundation/time.hpp"

namespace skein::supervisor {

/// Time that a UAV is given to leave air before that closes, and to plan anew.
inline constexpr Duration kWarning = Duration::milliseconds(60'000);

}  // namespace skein::supervisor
