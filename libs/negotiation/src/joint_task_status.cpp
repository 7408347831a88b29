// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::interaction {

std::string_view to_text(JointPhase phase) {
  constexpr std::string_view kNames[] = {"loading", "loaded",  "running",   "leaving",
                                         "ended",   "aborted", "not-loaded"};
  return kNames[static_cast<std::size_t>(phase)];
}

}  // namespace skein::interaction
