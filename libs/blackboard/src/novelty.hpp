// SPDX-License-Identifier: Apache-2.0
// Whether a sample says something new.
#pragma once

#include <cstdint>

namespace skein::blackboard {

enum class Novelty : std::uint8_t {
  kNew,
  kKnown,    ///< it was heard before, or is outdated: transports and senders repeat samples
  kReplayed  ///< it comes again although neither its sender nor a transport repeats it so
};

}  // namespace skein::blackboard
