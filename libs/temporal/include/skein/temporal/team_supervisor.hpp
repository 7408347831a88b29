// SPDX-License-Identifier: Apache-2.0
// The supervisor of CIP: knows the networks of all agents, and sends each the dates of its
// partners.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/temporal/team_dates.hpp"

namespace skein::temporal {

/// Sans-IO. Each agent sends its whole network; the supervisor sends each agent, for each partner,
/// the arrivals of the partner at common meetings and the dates by which it needs the agent there.
/// Both are states: the last message counts. Agents evaluate them with `TeamDates`, whose laws
/// hold. Cost of an input: `TeamDates::bounds_for` of every pair. Thread rule: not safe to share.
/// Source: M 4.1 (CIP); spec 5.3.
class TeamSupervisor {
 public:
  explicit TeamSupervisor(std::vector<std::string> agents);

  /// A changed frontier of one agent, for another.
  struct Word {
    std::string to, about;
    Frontier frontier;
    bool operator==(const Word&) const = default;
  };
  /// Takes the network of an agent; returns the frontiers to send. Unknown agents are ignored.
  /// Precondition: no fault (fault_of).
  std::vector<Word> hear(const std::string& agent, const Frontier& whole);
  /// As `TeamDates::out_of_reach`.
  std::vector<Word> out_of_reach(const std::string& agent, std::optional<MissionTime> since);

 private:
  std::vector<Word> news();

  std::map<std::string, TeamDates> agents_;  ///< each agent's view if it knew all networks
  std::map<std::pair<std::string, std::string>, Frontier> told_;
};

}  // namespace skein::temporal
