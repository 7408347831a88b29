// SPDX-License-Identifier: Apache-2.0
// What the reader and the writer of GraphML have in common.
#pragma once

namespace skein::temporal {

/// What the CSTNU Tool calls the origin.
inline constexpr const char* kGraphmlOrigin = "Z";

}  // namespace skein::temporal
