// SPDX-License-Identifier: Apache-2.0
// Why a role's motion that waited for its air in vain is given up.
#pragma once

#include <string_view>

namespace skein::decision_node {

/// The beginning of the reason; for whom it waited follows.
inline constexpr std::string_view kNoAir = "others leave it no air: it waits for ";

}  // namespace skein::decision_node
