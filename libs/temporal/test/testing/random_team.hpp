// SPDX-License-Identifier: Apache-2.0
// Teams with random plans that meet each other, and when they do by the network of all together.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/team_dates.hpp"

namespace skein::temporal::testing {

struct OracleDates {
  MissionTime soonest, slowest;
  std::optional<MissionTime> needed;
  bool contradicted = false;  ///< what the others bound leads to a circle that asks for ever more
};

/// Two to four agents whose plans are chains of tasks with meetings between them, some with bounds
/// from above. `change` makes the plans of some anew and lets time pass; what is said meanwhile is
/// heard at `deliver`, by all, once.
class RandomTeam {
 public:
  /// `orders`: some wait for others to leave their air, too.
  explicit RandomTeam(std::uint64_t seed, bool orders = false);

  void change();
  void deliver();
  std::vector<std::string> agents() const;
  MissionTime now() const { return now_; }
  /// What is left of its network, and all of it.
  Frontier plan_of(const std::string& agent) const { return frontier_of(plans_.at(agent)); }
  Frontier network_of(const std::string& agent) const {
    return {plans_.at(agent).meetings, plans_.at(agent).links};
  }
  const TeamDates& heard_by(const std::string& agent) const { return heard_.at(agent); }
  /// By Floyd and Warshall. Nothing of meetings that another sender does not plan.
  std::map<MeetingId, OracleDates> dates_of(const std::string& agent) const;

 private:
  /// Local nodes: origin, present, arrival and end of each meeting, then tasks.
  struct Plan {
    std::vector<Meeting> meetings;
    std::size_t nodes = 0;
    std::vector<FrontierLink> links;
  };
  class Whole;
  Plan make_plan(const std::string& agent);
  void take_part(Plan& plan, const std::string& agent, std::size_t meeting, std::uint32_t& before);
  std::vector<Meeting> meetings_of(const std::string& agent) const;
  void bound(Plan& plan, std::uint32_t node, Ticks date);
  Frontier frontier_of(const Plan& plan) const;

  Random random_;
  std::vector<Meeting> meetings_, orders_;
  std::map<std::string, Plan> plans_;
  std::map<std::string, TeamDates> heard_;
  MissionTime now_;
};

}  // namespace skein::temporal::testing
