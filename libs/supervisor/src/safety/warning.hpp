// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "skein/foundation/time.hpp"

namespace skein::supervisor {

/// Time before a volume closes that a UAV has for leaving it and planning anew.
inline constexpr Duration kWarning = Duration::milliseconds(60'000);

}  // namespace skein::supervisor
