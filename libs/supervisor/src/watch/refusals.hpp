// SPDX-License-Identifier: Apache-2.0
// What the vehicle refuses again and again is asked for more and more seldom.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "skein/foundation/time.hpp"

namespace skein::supervisor {

/// How long after the one before a refusal still counts as one more of the same, beyond the pause.
inline constexpr Duration kRefusedAgain = Duration::milliseconds(120'000);

/// Counts what the functional layer did not do, or left off, alike: tasks of one type, in the same
/// words but for figures, and none of the type done in between. A value type.
class Refusals {
 public:
  /// One more. Returns how many it is of these.
  int count(const std::string& type, const std::string& why, MissionTime now);
  /// A task of this type was done: what went before is past.
  void did(const std::string& type);

 private:
  struct Row {
    int times = 0;
    MissionTime last;
  };
  std::map<std::pair<std::string, std::string>, Row> rows_;  ///< by type and words
};

/// How long to wait before that is asked for again which was refused so often: not at all after the
/// first time, then 5 s, doubled each time, at most a minute.
Duration pause_after(int times);

}  // namespace skein::supervisor
