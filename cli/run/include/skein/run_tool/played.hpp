// SPDX-License-Identifier: Apache-2.0
// The outcome of playing a scenario, in whichever runtime.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::run_tool {

struct Played {
  enum class End {
    kFinished,     ///< the mission said so
    kTimeLimit,    ///< the scenario's duration limit came first
    kIdle,         ///< nothing was left to happen (virtual runtime)
    kInterrupted,  ///< by the user
    kFailed        ///< the system failed: `why`
  };
  End end = End::kFinished;
  std::string why;                       ///< kFailed: the daemon, and its last output
  bool timed_out = false;                ///< kFailed: an expected event did not occur in time
  std::vector<journal::Record> records;  ///< in order of time
};

}  // namespace skein::run_tool
