// SPDX-License-Identifier: Apache-2.0
// The UAV as a team member: votes at every degree; at degree 5 bids, and carries out what it won.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "component.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/team/roster.hpp"
#include "team/lateness.hpp"
#include "team/team_detours.hpp"

namespace skein::team {
struct Order;
}

namespace skein::decision_node {

class Core;

/// Does nothing if the configuration has no team. Granted tasks go to the supervisor one at a time,
/// each as a goal in a mission of its own. The end of each is reported to the team, which sells a
/// failed task again. Source: spec 6.3; docs/decisions/0018-degree-5.md.
class Team final : public Component {
 public:
  explicit Team(Core& core);

  /// Whether there is a team.
  bool possible() const { return member_.has_value(); }
  void start();
  void hear(const TeamTold& told);
  void detours_planned(const DetoursPlanned& done);
  /// Members out of reach are sent nothing; messages repeat once they are in reach again.
  void contact(const Contact& contact);
  /// The supervisor's answer to a mission of the team.
  void mission_answered(mission::MissionId mission, bool accepted, const std::string& why);
  void goal_changed(const mission::GoalStatus& status);
  /// To be called after each input: starts or stops bidding, and flies home when idle.
  void settle();

  void vehicle_told(const world::Telemetry& telemetry) override { telemetry_ = telemetry; }
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  /// A granted task in the hands of the supervisor.
  struct Job {
    auction::Claim claim;
    mission::GoalId goal;
    mission::MissionId mission;
    std::string statement;
    bool begun = false;        ///< a part of it was carried out
    std::string withdrawn;     ///< why it was withdrawn from this UAV; empty: it was not
    bool handed_over = false;  ///< its goal is with the operator
  };

  void give(auction::TeamInput input);
  void carry_out(const auction::Tell& effect);
  void carry_out(const auction::BeginTask& effect);
  void carry_out(const auction::TokenTaken& effect);
  void carry_out(const auction::TokenLost& effect);
  void carry_out(const auction::SaleTold& effect);
  void carry_out(const auction::Offered& effect);
  void carry_out(const auction::Store&) {}  // the node's memory has it
  std::string why_not_begin(const team::Order* order) const;
  void begin(const auction::Claim& claim, const team::Order& order);
  void put_back(const std::string& why, bool failed);
  void put_back_what_waits(const std::string& why);
  void look_at_the_time();
  void note(const std::string& state, const std::string& why);
  /// Precondition: it has a job.
  void withdraw(const std::string& why);
  void look_at_what_was_handed_over();
  void go_home();
  bool is_idle() const;
  std::unique_ptr<const auction::Craft> craft_for(const auction::Lot& lot, MissionTime since);
  /// Notes since when it reaches too few.
  void see_whether_apart();
  /// From when on it counts on no more work of the team, of which it reaches too few.
  std::optional<MissionTime> left_out_at() const;
  bool is_left_out() const;
  bool may_be_given_work() const;
  Vantage vantage();
  mission::HighLevelTask as_bid_for(const mission::HighLevelTask& task,
                                    std::uint32_t members) const;
  mission::MissionId next_mission();

  Core& core_;
  std::optional<auction::TeamMember> member_;
  world::Telemetry telemetry_;
  bool bids_ = false;
  std::set<std::string> out_of_reach_;
  std::optional<Job> job_;
  Lateness lateness_;  ///< of the job
  std::map<auction::TaskNumber, std::uint32_t> attempts_;
  std::map<auction::TaskNumber, std::string> failed_;
  std::map<auction::TaskNumber, std::optional<refiners::Gate>> visits_;
  std::shared_ptr<const world::World> visited_;  ///< the world for which `visits_` were computed
  std::optional<MissionTime> idle_since_;
  std::optional<MissionTime> apart_since_;  ///< it reaches too few to be sold or granted anything
  std::optional<MissionTime> left_since_;   ///< nobody decides on what was handed over, since then
  std::uint64_t missions_ = 0;
  TeamDetours detours_;
  std::optional<MissionTime> bids_until_;  ///< bids wait for detours until then
};

}  // namespace skein::decision_node
