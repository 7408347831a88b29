// SPDX-License-Identifier: Apache-2.0
// What a UAV has of what is asked of it.
#include "skein/interaction/capabilities.hpp"

#include <gtest/gtest.h>

#include "skein/interaction/describe.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {
namespace {

using Needs = std::vector<Requirement>;

std::vector<std::string> missing(const Needs& needs, const Capabilities& capabilities) {
  std::vector<std::string> all;
  for (const Requirement& one : unmet(needs, capabilities)) all.push_back(describe(one));
  return all;
}

TEST(Capabilities, NamesEveryRequirementThatIsNotMet) {
  const Needs needs = {{"hovering", {}},
                       {"camera", "visible"},
                       {"endurance", Requirement::Bound{Relation::kAtLeast, 900}}};

  EXPECT_EQ(missing(needs, {}),
            (std::vector<std::string>{"hovering", "camera: visible", "endurance ≥ 900"}));
  EXPECT_EQ(missing(needs, {{"hovering", {}}, {"camera", {{"ir"}, {}}}, {"endurance", {{}, 899}}}),
            (std::vector<std::string>{"camera: visible", "endurance ≥ 900"}));
  EXPECT_TRUE(
      missing(needs,
              {{"hovering", {}}, {"camera", {{"ir", "visible"}, {}}}, {"endurance", {{}, 900}}})
          .empty());
}

TEST(Capabilities, AFigureThatIsAskedForMustBeThere) {
  const Needs needs = {{"endurance", Requirement::Bound{Relation::kLess, 900}}};

  EXPECT_EQ(missing(needs, {{"endurance", {{"long"}, {}}}}).size(), 1U);
}

TEST(Capabilities, EveryRelationIsWhatItSays) {
  const auto met = [](Relation relation, double figure) {
    return unmet({{"x", Requirement::Bound{relation, 5}}}, {{"x", {{}, figure}}}).empty();
  };
  const std::vector<std::pair<Relation, std::vector<bool>>> expected{
      {Relation::kLess, {true, false, false}},
      {Relation::kAtMost, {true, true, false}},
      {Relation::kEqual, {false, true, false}},
      {Relation::kAtLeast, {false, true, true}},
      {Relation::kGreater, {false, false, true}}};
  for (const auto& [relation, holds] : expected) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(met(relation, 4.0 + static_cast<double>(i)), holds[i]) << to_text(relation) << i;
  }
}

TEST(Capabilities, AreThoseOfItsModelWithTheFiguresThatItDeclares) {
  world::VehicleModel vehicle;
  vehicle.hovers = true;
  vehicle.max_speed = 12;
  vehicle.ceiling = 150;
  vehicle.energy.capacity = 1000;
  vehicle.energy.hover_power = 4;
  vehicle.energy.reserve = 0.2;
  vehicle.sensors.emplace_back().device = "ir";
  vehicle.sensors.back().range = 300;
  vehicle.abilities = {{"payload", 1.5}};
  const auto needs = [](const std::string& figure, double least) {
    return Needs{{"hovering", {}},
                 {"camera", "ir"},
                 {figure, Requirement::Bound{Relation::kAtLeast, least}}};
  };
  const auto lacks = [&](const std::string& figure, double least) {
    return lacking(needs(figure, least), capabilities_of(vehicle, 0.7));
  };

  for (const auto& [figure, has] : std::map<std::string, double>{
           {"payload", 1.5}, {"ir-range", 300}, {"speed", 12}, {"ceiling", 150}}) {
    EXPECT_EQ(lacks(figure, has), "");
    EXPECT_NE(lacks(figure, has + 0.1), "") << figure;
  }
  EXPECT_EQ(lacks("endurance", 124.9), "") << "half of it is left over the reserve";
  EXPECT_NE(lacks("endurance", 125.1), "");
  EXPECT_EQ(lacks("payload", 2), "it lacks payload ≥ 2 (it has 1.5)");
  EXPECT_EQ(lacks("resolution", 2), "it lacks resolution ≥ 2");
  vehicle.sensors.clear();
  vehicle.hovers = false;
  EXPECT_EQ(lacks("payload", 1), "it lacks hovering, camera: ir");
}

}  // namespace
}  // namespace skein::interaction
