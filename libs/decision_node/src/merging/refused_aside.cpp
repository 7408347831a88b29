// SPDX-License-Identifier: Apache-2.0
#include "merging/refused_aside.hpp"

#include <algorithm>

namespace skein::decision_node {

void RefusedAside::told(const functional::Status& status, MissionTime now) {
  if (status.state == functional::TaskState::kRunning) {
    running_ = status.id;
    pause_ = kFirst;
  } else if (status.state == functional::TaskState::kAborted && status.id != running_) {
    next_ = now + pause_;
    pause_ = std::min(kMost, pause_ + pause_);
  }
}

}  // namespace skein::decision_node
