// SPDX-License-Identifier: Apache-2.0
// The instance number of a LinkState.
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

}  // namespace skein::blackboard
