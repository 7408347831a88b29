// SPDX-License-Identifier: Apache-2.0
#include "skein/node/input_log.hpp"

#include <utility>

namespace skein::node {

bool is_of_lives(const LoggedInput& input) {
  return std::holds_alternative<Started>(input) || std::holds_alternative<Resumed>(input) ||
         std::holds_alternative<Unsent>(input);
}

Result<void, Failure> InputLog::recall_lives(const Take& take) const {
  bool first = true;
  return recall([&](const LogEntry& entry) -> Result<void, Failure> {
    const bool wanted = std::exchange(first, false) || is_of_lives(entry.input);
    return wanted ? take(entry) : Result<void, Failure>();
  });
}

Result<void, Failure> MemoryInputLog::append(const LogEntry& entry) {
  entries_.push_back(entry);
  return {};
}

Result<void, Failure> MemoryInputLog::recall(const Take& take) const {
  for (const LogEntry& entry : entries_) {
    if (auto taken = take(entry); !taken) return taken;
  }
  return {};
}

}  // namespace skein::node
