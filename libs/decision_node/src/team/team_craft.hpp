// SPDX-License-Identifier: Apache-2.0
// Estimates for the UAV's bids.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "skein/auction/catalogue.hpp"
#include "skein/auction/craft.hpp"
#include "skein/interaction/requirement.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/supervisor/detours.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::decision_node {

/// From where to where.
using LegEnds = std::pair<auction::Stopover, auction::Stopover>;
/// Legs without an entry are flown straight.
using Detours = std::map<LegEnds, supervisor::Detour>;

/// What the UAV knows of itself and of the tasks on sale.
struct Vantage {
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  world::Telemetry telemetry;
  MissionTime now;
  Duration busy;  ///< until its own current tasks are over
  /// The work behind the ledger's tasks, and the places where the UAV would begin and end it.
  std::map<auction::TaskNumber, mission::HighLevelTask> tasks;
  std::map<auction::TaskNumber, interaction::Requirements> needs = {};
  std::map<auction::TaskNumber, std::optional<refiners::Gate>> visits;
  /// The task that it is at, and how long its plan takes until what remains is the task itself.
  struct Begun {
    auction::TaskNumber task;
    Duration way;
    double slower = 1;  ///< how many times cruise speed is what it flies at, if it is behind
  };
  std::optional<Begun> begun = {};
  /// Tasks that this UAV tried in vain, with the reason.
  std::map<auction::TaskNumber, std::string> failed;
  Detours detours = {};
};

/// What the UAV lacks as it is now, with the sensors that work and the energy that is left; empty:
/// nothing.
std::string lacks_now(const interaction::Requirements& needs, const world::VehicleModel& vehicle,
                      const world::Telemetry& telemetry);

/// Estimates flights as straight lines between the places of tasks, at cruise speed in the wind,
/// from the UAV's position and home again, and adds the detours that are known; the length of a
/// sweep is added to the flight to it. There is no way to a task in a place that no way leads to,
/// unless a sensor may see it from elsewhere, or it is done with others.
/// Operator 1 in evaluation mode would be more exact, but takes a job of some 0.1 s per insertion,
/// while one call of a sale asks for the legs between all its tasks. The winner's supervisor plans
/// the task when it begins, and puts back what it cannot plan. Source: spec 6.3;
/// docs/decisions/0018-degree-5.md, docs/decisions/0085-bids-go-around.md.
class TeamCraft final : public auction::Craft {
 public:
  explicit TeamCraft(Vantage vantage) : at_(std::move(vantage)) {}

  auction::Abilities abilities() const override { return 0; }
  double free_from() const override { return at_.busy.to_seconds(); }
  double energy() const override;
  std::optional<auction::Leg> leg(auction::Stopover from, auction::Stopover to) const override;
  /// The flight of a leg as a straight line; none: one of its ends has no place.
  std::optional<supervisor::StraightLeg> straight(auction::Stopover from,
                                                  auction::Stopover to) const;
  double energy_of(const auction::Task& task) const override;
  std::optional<std::string> objection(const auction::Task& task) const override;

 private:
  std::optional<refiners::Gate> visit(auction::TaskNumber task) const;
  std::optional<world::Vector3> leaves_from(auction::Stopover from) const;
  world::Vector3 begins_at() const;
  bool is_begun(auction::Stopover place) const;
  bool has_to_be_there(auction::Stopover place) const;

  Vantage at_;
};

}  // namespace skein::decision_node
