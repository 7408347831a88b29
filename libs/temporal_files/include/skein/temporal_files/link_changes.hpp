// SPDX-License-Identifier: Apache-2.0
// Changes of a network as text, to be applied one after the other to an incrementally checked
// network.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// `[{"from": "a", "to": "b", "min": 2, "max": null}, …]`: new bounds between two nodes of the
/// network, in seconds, in the order in which they come; null is no bound. All errors at once; also
/// of an interval that is empty, and of one from a node to itself.
Result<std::vector<Arc>, Diagnostics> read_changes(std::string_view text, const Stnu& network,
                                                   const std::string& file = "");

}  // namespace skein::temporal
