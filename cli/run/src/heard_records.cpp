// SPDX-License-Identifier: Apache-2.0
#include "heard_records.hpp"

namespace skein::run_tool {

bool HeardRecords::is_news(blackboard::NodeNumber origin, const wire::JournalEntry& entry) {
  Last& last = last_[{origin, entry.header.incarnation}];
  if (entry.header.sequence_number <= last.sequence) return false;
  last.sequence = entry.header.sequence_number;
  if (entry.line == 0) return true;
  if (entry.line <= last.line) return false;
  last.line = entry.line;
  return true;
}

}  // namespace skein::run_tool
