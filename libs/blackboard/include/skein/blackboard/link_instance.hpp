// SPDX-License-Identifier: Apache-2.0
// Which radio directions a LinkState is about.
#pragma once

#include <cstdint>

#include "skein/blackboard/channel.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {

/// The instance for the radio direction `from` to `to`. Precondition: both are below 65,536.
inline std::uint32_t link_instance(NodeNumber from, NodeNumber to) {
  constexpr std::uint32_t kNumbers = 1U << 16;
  SKEIN_EXPECTS(from.value() < kNumbers && to.value() < kNumbers);
  return from.value() * kNumbers + to.value();
}

/// Whether it is about one direction, not about all of which nothing else was said.
inline bool is_of_one(const wire::LinkState& link) {
  return link.from != kEverybody.value() && link.to != kEverybody.value();
}

}  // namespace skein::blackboard
