// SPDX-License-Identifier: Apache-2.0
// An order of nodes in which sweeps over a temporal network are few.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// "`after` comes no earlier than `before`."
struct Precedence {
  NodeIndex before = 0;
  NodeIndex after = 0;
};

/// All nodes, each after those it must follow, but for circles. Depends on the order of the
/// precedences only; O(nodes + precedences).
std::vector<NodeIndex> sweep_order(std::size_t nodes, const std::vector<Precedence>& precedences);

}  // namespace skein::temporal
