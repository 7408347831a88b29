// SPDX-License-Identifier: Apache-2.0
// Constants common to the reader and the writer of GraphML.
#pragma once

namespace skein::temporal {

/// Name of the origin in the CSTNU Tool.
inline constexpr const char* kGraphmlOrigin = "Z";

}  // namespace skein::temporal
