// SPDX-License-Identifier: Apache-2.0
// The UAV as its bids see it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "skein/auction/catalogue.hpp"
#include "skein/auction/craft.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::decision_node {

/// What a UAV knows of itself and of what is on sale. Refers to what outlives the bid.
struct Vantage {
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  world::Telemetry telemetry;
  MissionTime now;
  Duration busy;  ///< until what it has of its own is over
  /// What the tasks of the ledger come down to, and where that takes the UAV.
  std::map<auction::TaskNumber, mission::HighLevelTask> tasks;
  std::map<auction::TaskNumber, std::optional<refiners::Gate>> visits;
  /// Tasks that it tried, and why that came to nothing.
  std::map<auction::TaskNumber, std::string> failed;
};

/// Straight flights between the places of tasks, at cruise speed in the wind, from where the UAV is
/// and home again; a sweep counts on the way to it. Not operator 1 in evaluation, which is a job of
/// some 0.1 s for one insertion: a sale asks for the ways between all its tasks, in one call, many
/// times. The winner's supervisor plans the task when it begins, and puts back what it cannot plan.
/// Source: spec 6.3; docs/decisions/0018-degree-5.md.
class TeamCraft final : public auction::Craft {
 public:
  explicit TeamCraft(Vantage vantage) : at_(std::move(vantage)) {}

  auction::Abilities abilities() const override { return 0; }
  double free_from() const override { return at_.busy.to_seconds(); }
  double energy() const override;
  std::optional<auction::Leg> leg(auction::Stopover from, auction::Stopover to) const override;
  double energy_of(const auction::Task& task) const override;
  std::optional<std::string> objection(const auction::Task& task) const override;

 private:
  std::optional<refiners::Gate> visit(auction::TaskNumber task) const;
  std::optional<world::Vector3> leaves_from(auction::Stopover from) const;
  world::Vector3 begins_at() const;

  Vantage at_;
};

}  // namespace skein::decision_node
