// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_lab/troubles.hpp"

#include <algorithm>

#include "parts.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::mission_lab {

namespace {

class Drawing {
 public:
  Drawing(std::uint64_t seed, const Stage& stage)
      : random_(seed, "troubles"), stage_(stage), latest_(std::max(20.0, stage.until)) {}

  Troubles draw() {
    for (std::uint64_t left = 1 + random_.below(4); left > 0; --left) add();
    return std::move(troubles_);
  }

 private:
  void add() {
    switch (random_.below(6)) {
      case 0:
      case 1:
        return add_death();
      case 2:
        return add_cut();
      case 3:
        troubles_.faults.push_back(draw_refusals(random_, one().name, latest_));
        return;
      case 4:
        troubles_.loss = random_.uniform(0.01, 0.3);
        return;
      default:
        add_fault();
    }
  }

  void add_death() {
    std::string death = draw_death(random_, stage_.daemons, latest_);
    troubles_.faults.push_back(random_.chance(0.2) ? forgetting(std::move(death))
                                                   : std::move(death));
  }

  void add_cut() {
    const std::string first = one().name;
    const std::string& second = one().name;
    troubles_.cuts.push_back(
        draw_cut(random_, first, second == first ? "ground" : second, latest_));
  }

  void add_fault() {
    const Stage::Vehicle& vehicle = one();
    if (vehicle.devices.empty()) return add_cut();
    const auto device = [&](Random& random) {
      return vehicle.devices[random.below(vehicle.devices.size())];
    };
    troubles_.faults.push_back(draw_fault(random_, vehicle.name, device, latest_));
  }

  const Stage::Vehicle& one() { return stage_.vehicles[random_.below(stage_.vehicles.size())]; }

  Random random_;
  const Stage& stage_;
  double latest_;
  Troubles troubles_;
};

}  // namespace

void let_die_for_long(Mission& mission) {
  Random random(mission.seed, "random mission: long deaths");
  double from = 5;
  for (std::uint64_t left = 1 + random.below(2); left > 0; --left) {
    const double at = random.uniform(from, from + 350), away = random.uniform(60, 600);
    const std::string& who = mission.team[random.below(mission.team.size())].name;
    mission.faults.push_back("{at: " + tenths(at) + ", kill: " + who +
                             ", restart_after: " + tenths(away) + "}");
    from = 350;
  }
}

Troubles draw_troubles(std::uint64_t seed, const Stage& stage) {
  SKEIN_EXPECTS(!stage.vehicles.empty() && !stage.daemons.empty());
  Troubles troubles = Drawing(seed, stage).draw();
  Random computers(seed, "computers");
  if (stage.plans && computers.chance(0.5)) troubles.planning_takes = computers.uniform(0.5, 8);
  return troubles;
}

}  // namespace skein::mission_lab
