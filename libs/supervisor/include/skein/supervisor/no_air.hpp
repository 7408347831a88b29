// SPDX-License-Identifier: Apache-2.0
// Why a motion that waited for its air in vain is given up.
#pragma once

#include <string_view>

namespace skein::supervisor {

/// The beginning of the reason; for whom it waited follows. Whoever aborts a motion for it says so,
/// and whoever plans again then tries what else there is to do first.
inline constexpr std::string_view kNoAir = "others leave it no air: it waits for ";

}  // namespace skein::supervisor
