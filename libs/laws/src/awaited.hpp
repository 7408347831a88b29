// SPDX-License-Identifier: Apache-2.0
// Triggers of a script, judged by the event log.
#pragma once

#include <string>
#include <vector>

#include "skein/laws/waiting.hpp"

namespace skein::laws {

/// "446.9 s".
std::string seconds_text(double seconds);

/// What an event log says of triggers. The records must outlive this.
class LogOfWaits {
 public:
  explicit LogOfWaits(const std::vector<journal::Record>& records) : records_(records) {}

  /// Whether there is a line of this kind with this text.
  bool did(std::string_view kind, std::string_view key, std::string_view text) const;
  /// Whether the trigger, which is no AllOf or AnyOf, came about; false where the log cannot tell.
  bool came_about(const ground_station::Trigger& leaf) const;
  /// How what the trigger waits for stands; without the step.
  Waiting standing_of(const ground_station::Trigger& leaf) const;

 private:
  template <class Matches>
  const journal::Record* last(const Matches& matches) const;
  Waiting of_task(const ground_station::OnTask& on) const;
  Waiting of_goal(const ground_station::OnGoal& on) const;
  std::string why_of(const std::string& uav, double at, const std::string& told) const;
  void ask_commands(const std::string& uav, const std::string& what, Waiting& waiting) const;
  std::string deaths() const;

  const std::vector<journal::Record>& records_;
};

/// The leaves for want of which the trigger has not come about.
std::vector<const ground_station::Trigger*> missing(const ground_station::Trigger& trigger,
                                                    const LogOfWaits& log);

}  // namespace skein::laws
