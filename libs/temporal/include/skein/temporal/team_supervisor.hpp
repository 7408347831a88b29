// SPDX-License-Identifier: Apache-2.0
// The supervisor of CIP: one that knows the networks of all, and says to each when others come.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/temporal/team_dates.hpp"

namespace skein::temporal {

/// Sans-IO. Each agent tells it its whole network; it tells each, of each other one, when that
/// comes to their meetings and by when it needs the agent there. Both are states: the last word
/// counts. An agent puts what it is told together by `TeamDates`, whose laws hold for it. Cost of a
/// word: `TeamDates::bounds_for` of every pair. Thread rule: not safe to share.
/// Source: M 4.1 (CIP); spec 5.3.
class TeamSupervisor {
 public:
  explicit TeamSupervisor(std::vector<std::string> agents);

  /// Of one agent to another, where that is not as it was.
  struct Word {
    std::string to, about;
    Frontier frontier;
    bool operator==(const Word&) const = default;
  };
  /// Precondition: no fault. Of somebody else nothing follows.
  std::vector<Word> hear(const std::string& agent, const Frontier& whole);
  /// As `TeamDates::out_of_reach`.
  std::vector<Word> out_of_reach(const std::string& agent, std::optional<MissionTime> since);

 private:
  std::vector<Word> news();

  std::map<std::string, TeamDates> agents_;  ///< what each would know, were it told all
  std::map<std::pair<std::string, std::string>, Frontier> told_;
};

}  // namespace skein::temporal
