// SPDX-License-Identifier: Apache-2.0
// Progress display of a run: mission time, phase, each UAV's current task.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::run_tool {

/// On a terminal one line that is written over; elsewhere a line when something changed, at most
/// one per ten mission seconds' worth of wall clock, so that logs stay short. Follows the event
/// log.
class Progress {
 public:
  enum class Style { kNone, kLines, kTerminal };

  Progress(std::ostream& out, Style style, std::vector<std::string> uavs);

  /// What the team cannot do is said at once.
  void see(const journal::Record& record);
  /// Updates the display; to be called about ten times per second.
  void show(MissionTime now);
  /// Prints a message on a separate line.
  void say(const std::string& text);
  void finish();

 private:
  struct CurrentTask {
    std::map<std::int64_t, std::string> running;  ///< id → "goto"
  };
  void see_owner(const journal::Record& record);
  std::string line(MissionTime now) const;

  std::ostream& out_;
  Style style_;
  std::vector<std::string> uavs_;
  std::map<std::string, CurrentTask> current_;
  std::map<std::int64_t, std::string> unsold_;  ///< why nobody has these tasks of the team
  std::string phase_;
  std::string shown_;
  bool changed_ = true;
};

}  // namespace skein::run_tool
