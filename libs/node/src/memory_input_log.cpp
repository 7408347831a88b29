// SPDX-License-Identifier: Apache-2.0
#include "skein/node/input_log.hpp"

namespace skein::node {

Result<void, Failure> MemoryInputLog::append(const LogEntry& entry) {
  entries_.push_back(entry);
  return {};
}

Result<void, Failure> MemoryInputLog::recall(
    const std::function<Result<void, Failure>(const LogEntry&)>& take) const {
  for (const LogEntry& entry : entries_) {
    if (auto taken = take(entry); !taken) return taken;
  }
  return {};
}

}  // namespace skein::node
