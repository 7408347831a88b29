// SPDX-License-Identifier: Apache-2.0
// A real executive over a functional layer that takes the time it is told.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elementary_plans.hpp"
#include "skein/executive/executive.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

using Durations = std::map<executive::TaskId, Duration>;

/// Durations inside those of the tasks: each the least, the greatest, or between, a third of the
/// time. Tasks with a stop have none.
Durations draw_durations(const Tasks& tasks, Random& random);

/// All requests are given at zero, in order. Statuses come at once: running when a task is
/// dispatched, aborted when it is interrupted; the other UAV's message after the duration of a
/// synchronisation.
class ScriptedFlight {
 public:
  ScriptedFlight(const Tasks& tasks, Durations durations);

  void begin(const std::vector<executive::Input>& requests);
  /// Up to `end`, or until nothing is to come.
  void run_until(MissionTime end = MissionTime::max());
  /// What comes next, if it comes by `end`; absent: nothing does.
  std::optional<MissionTime> step(MissionTime end = MissionTime::max());
  void tell(const executive::Input& request, MissionTime now) { take(request, now); }

  const Observations& seen() const { return seen_; }
  /// In order: "dispatch 103", "interrupt 103", "refused: …".
  const std::vector<std::string>& told() const { return told_; }
  executive::TaskState state(std::uint64_t task) const;

 private:
  void take(const executive::Input& input, MissionTime now);
  void on(const executive::Effect& effect, MissionTime now);
  void on(const executive::TaskEvent& event, MissionTime now);
  void later(executive::TaskId task, executive::Input input, MissionTime now);

  executive::Executive executive_;
  std::map<executive::TaskId, mission::ElementaryTask> tasks_;
  Durations durations_;
  std::multimap<MissionTime, executive::Input> to_come_;
  Observations seen_;
  std::vector<std::string> told_;
};

}  // namespace skein::supervisor
