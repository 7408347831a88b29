// SPDX-License-Identifier: Apache-2.0
// The laws catch what they are there to catch: deliberation on board is spoilt in one place at a
// time (a dependence dropped, a check skipped, less done than asked), and a law of truth says so.
// The UAVs' nodes are made from a spoilt scenario; simulator and ground have the true one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/laws/laws.hpp"
#include "skein/mission_lab/mission.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::mission_lab {
namespace {

using scenario::Scenario;
using ::testing::IsEmpty;
using Spoil = std::function<void(Scenario&)>;

const std::string kFile = SKEIN_SOURCE_DIR "/scenarios/comets/spoilt.yaml";

Step step(const std::string& uav, int mission, std::vector<std::string> words, int first_goal) {
  Step result;
  result.name = uav + std::to_string(mission);
  result.when = "{time: 5}";
  result.uav = uav;
  result.mission = mission;
  for (std::string& one : words) result.tasks.push_back({first_goal++, std::move(one), ""});
  return result;
}

// Marvin looks at two places and meets Heliv at a third, past a closed tower; Karma maps.
Mission three_at_work() {
  Mission m;
  m.wind = "toward: 0.6, speed: 1.0, gusts: 0.2";
  m.places = {"P1: [150, 60, 0]", "P2: [300, -40, 0]", "P3: [120, 240, 0]", "A1: [120, 240, 70]"};
  m.zones = {"Z1: [[260, 160], [460, 160], [460, 300], [260, 300]]"};
  m.volumes = {"tower: {polygon: [[205, -20], [255, -20], [255, 50], [205, 50]]}"};
  m.team = {{"marvin", "marvin", "start: [0, 0]", 40, 100},
            {"heliv", "heliv", "start: [-40, 40]", 60, 1100},
            {"karma", "karma", "start: [0, -100]", 90, 2100}};
  const std::string meet =
      "[general-combined-goto-and-synchro-and-takeshot, 500, [marvin, heliv], [marvin, heliv], "
      "P3, "
      "20]";
  m.steps = {step("marvin", 1,
                  {"[perceive, P1, 60]", "[general-combined-goto-and-takeshot, P2, 20]", meet,
                   "[general-land]"},
                  700),
             step("heliv", 1, {meet, "[general-land]"}, 800),
             step("karma", 1, {"[perform-mapping, Z1]", "[general-land]"}, 900)};
  return m;
}

// The straight way leads through closed air.
Mission past_the_tower() {
  Mission m = three_at_work();
  m.team = {{"marvin", "marvin", "start: [0, 0]", 40, 100}};
  m.steps = {step("marvin", 1,
                  {"[general-gotoxyz, [150, 20, 50]]", "[general-gotoxyz, [320, 20, 50]]"}, 700)};
  return m;
}

// Orders that never come, and little energy to wait for them with.
Mission no_orders() {
  Mission m = three_at_work();
  m.team = {{"marvin", "marvin", "start: [0, 0], energy: 0.2", 40, 100}};
  m.steps = {step("marvin", 1, {"[general-gotoxyz, A1]", "[wait-for-orders]"}, 700)};
  m.finish_after = -1;
  m.limit = 900;
  return m;
}

/// The names of the laws that are broken.
std::set<std::string> broken(const Mission& mission, const Spoil& spoil) {
  auto truth = scenario::read_scenario_text(to_yaml(mission, ".."), kFile);
  SKEIN_EXPECTS(truth.has_value());
  Scenario believed = *truth;
  spoil(believed);
  std::vector<journal::Record> records;
  node::run_virtual(
      scenario_setup::roster_of(*truth),
      [&](const std::string& name) {
        return assembly::make_node(truth->find_uav(name) != nullptr ? believed : *truth, name);
      },
      assembly::virtual_config(*truth),
      [&](const journal::Record& record) { records.push_back(record); });
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  std::set<std::string> laws;
  for (const laws::Violation& one : laws::broken_laws(*truth, records)) laws.insert(one.law);
  return laws;
}

// Replaces a piece of the planning domain, which must be there.
Spoil in_the_domain(const std::string& piece, const std::string& with) {
  return [=](Scenario& scenario) {
    std::string& text = scenario.planning->domain;
    const std::size_t at = text.find(piece);
    ASSERT_NE(at, std::string::npos) << "the domain has no '" << piece << "'";
    text.replace(at, piece.size(), with);
  };
}

struct Mutation {
  std::string name;
  std::function<Mission()> mission;
  Spoil spoil;
  std::vector<std::string> caught_by;  ///< one of these laws
};

std::ostream& operator<<(std::ostream& out, const Mutation& one) { return out << one.name; }

std::vector<Mutation> mutations() {
  return {
      {"MotionsWaitForNothing",
       three_at_work,
       in_the_domain(
           "(assign ?dependences (append (dependences-of ?reads) (dependence ?event ?task)))))",
           "(assign ?dependences nil)))"),
       {"one-motion", "held", "perceived"}},
      {"PicturesAreNotStopped",
       three_at_work,
       in_the_domain("(!stop-takeshot ?shot ?_e ?_q ?_t ?_v ?tc ?origin)", ""),
       {"held", "one-motion", "ends", "idle"}},
      {"ClosedAirIsNotLookedAt",
       past_the_tower,
       [](Scenario& s) { s.world.volumes.clear(); },
       {"closed-air"}},
      {"EnergyIsNotLookedAt",
       no_orders,
       [](Scenario& s) {
         for (auto& uav : s.uavs) {
           uav.model.energy.capacity *= 20;
           uav.model.energy.reserve = 0;
         }
       },
       {"energy"}},
      {"LooksAreShorterThanAsked",
       three_at_work,
       in_the_domain("((go ?to ?left ?tc ?origin) (!!lcompute-stay ?left) (!!aim",
                     "((go ?to ?left ?tc ?origin) (!!lcompute-stay 5) (!!aim"),
       {"perceived"}},
      {"PartOfTheZoneIsLeftOut",
       three_at_work,
       [](Scenario& s) {
         for (auto& corner : s.world.zones.front().polygon)
           corner.y() = std::min(corner.y(), 190.0);
       },
       {"mapped"}},
  };
}

TEST(Mutations, WithoutOneNoLawIsBroken) {
  EXPECT_THAT(broken(three_at_work(), [](Scenario&) {}), IsEmpty());
  EXPECT_THAT(broken(past_the_tower(), [](Scenario&) {}), IsEmpty());
  EXPECT_THAT(broken(no_orders(), [](Scenario&) {}), IsEmpty());
}

class Caught : public ::testing::TestWithParam<Mutation> {};

TEST_P(Caught, ByALaw) {
  const std::set<std::string> laws = broken(GetParam().mission(), GetParam().spoil);

  EXPECT_TRUE(std::any_of(GetParam().caught_by.begin(), GetParam().caught_by.end(),
                          [&](const std::string& law) { return laws.count(law) > 0; }))
      << "broken: " << ::testing::PrintToString(laws);
}

INSTANTIATE_TEST_SUITE_P(Mutations, Caught, ::testing::ValuesIn(mutations()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::mission_lab
