// SPDX-License-Identifier: Apache-2.0
// Back-off for tasks that the functional layer refuses repeatedly.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "skein/foundation/time.hpp"

namespace skein::supervisor {

/// Time after a refusal and its pause within which the next refusal counts as a repetition.
inline constexpr Duration kRefusedAgain = Duration::milliseconds(120'000);

/// Counts equal refusals and aborts by the functional layer: of one task type, with the same reason
/// except for numbers, and no success of the type in between. A value type.
class Refusals {
 public:
  /// Counts a refusal; returns the number of equal ones so far.
  int count(const std::string& type, const std::string& why, MissionTime now);
  /// A task of this type succeeded: its counts start again.
  void did(const std::string& type);

 private:
  struct Row {
    int times = 0;
    MissionTime last;
  };
  std::map<std::pair<std::string, std::string>, Row> rows_;  ///< by type and words
};

/// Pause before the next attempt after so many refusals: none after the first, then 5 s, doubled
/// each time, at most a minute.
Duration pause_after(int times);

}  // namespace skein::supervisor
