// SPDX-License-Identifier: Apache-2.0
// What a runner has heard of the daemons' event logs.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::run_tool {

/// Tells lines of event logs that are new from those that come once more: to a participant that was
/// opened anew, or from a restarted node that was killed before it had noted that it said them.
class HeardRecords {
 public:
  /// True once for each line of each process; then it is the last of that process.
  bool is_news(blackboard::NodeNumber origin, const wire::JournalEntry& entry);

 private:
  struct Last {
    std::uint64_t sequence = 0;
    std::uint64_t line = 0;  ///< of those that have a number
  };
  /// Node and incarnation: of two processes with one name both may speak.
  using Process = std::pair<blackboard::NodeNumber, std::uint64_t>;
  std::map<Process, Last> last_;
};

}  // namespace skein::run_tool
