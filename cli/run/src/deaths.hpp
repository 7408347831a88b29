// SPDX-License-Identifier: Apache-2.0
// Which daemons are to be killed and started again, and when.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

/// The deaths of a scenario, played over DDS as in virtual time: they may overlap; who is dead
/// cannot die, who lives is not started again. Who is killed still dies for a moment, and is
/// started once it is dead. Restarts are dated on the steady clock, since mission time stands still
/// while its leader is dead; that never decreases.
class Deaths {
 public:
  enum class Stage { kLives, kDies, kDead };
  /// What is to be done at once; it must be done before the next question.
  struct Deed {
    std::string node;
    bool kills = false;    ///< else it is started
    bool forgets = false;  ///< it starts with nothing it knew
  };

  Deaths(std::vector<scenario::KillSpec> kills, double rate);

  /// The next deed that is due; none: nothing is.
  std::optional<Deed> next(MissionTime mission, Duration steady,
                           const std::function<Stage(const std::string&)>& stage_of);
  /// Whether somebody is to be started again.
  bool awaits_restart() const { return !restarts_.empty(); }

 private:
  struct Restart {
    Duration at;  ///< steady
    std::string node;
    bool forgets = false;
  };

  std::vector<scenario::KillSpec> kills_;  ///< to come, in the order of time
  double rate_;
  std::vector<Restart> restarts_;
};

}  // namespace skein::run_tool
