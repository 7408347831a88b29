// SPDX-License-Identifier: Apache-2.0
// Joint tasks as all their members know them.
#include "planning/partners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/elementary_plans.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using ::testing::ElementsAre;

const std::vector<std::string> kTeam{"marvin", "heliv", "karma"};

mission::ElementaryTask watch(const std::string& members, const std::string& place,
                              double seconds = 90) {
  mission::ElementaryTask task = a_task(7, "joint:watch");
  task.parameters.add({"uavs", members, {}});
  task.parameters.add({"where", place, {}});
  task.parameters.add({"for", "", {seconds}});
  return task;
}

mission::ElementaryTask known(mission::ElementaryTask task) {
  mission::ElementaryPlan plan;
  plan.tasks.push_back(std::move(task));
  world::World world = testing::PlanningLab().world;
  world.places["Fire"] = {1, 2, 0};
  world.zones.push_back({"Field", {}});
  know_partners(plan, world, kTeam);
  return plan.tasks.front();
}

TEST(Partners, OfAJointTaskAreTheUavsThatItNames) {
  EXPECT_THAT(known(watch("marvin heliv", "fire")).gathering->members,
              ElementsAre("heliv", "marvin"));
}

TEST(Partners, KnowAJointTaskByTheSameNumberInWhateverOrderTheyAreNamed) {
  const auto number = [](const mission::ElementaryTask& task) { return known(task).gathering->id; };
  const auto one = number(watch("marvin heliv", "fire"));

  EXPECT_EQ(number(watch("heliv marvin", "FIRE")), one);
  EXPECT_NE(number(watch("heliv karma", "fire")), one);
  EXPECT_NE(number(watch("heliv marvin", "elsewhere")), one);
  EXPECT_NE(number(watch("heliv marvin", "fire", 91)), one);
}

TEST(Partners, AreSpelledPlacesAsTheWorldHasThem) {
  EXPECT_EQ(known(watch("marvin heliv", "FIRE")).parameters.find("where")->text, "Fire");
}

TEST(Partners, AreSpelledZonesAsTheWorldHasThem) {
  EXPECT_EQ(known(watch("marvin heliv", "field")).parameters.find("where")->text, "Field");
}

TEST(Partners, AreNoneOfATaskOfOneUavOrOfNoJointTask) {
  EXPECT_FALSE(known(watch("marvin", "fire")).gathering);
  EXPECT_FALSE(known(watch("marvin somebody", "fire")).gathering);
  mission::ElementaryTask alone = a_task(7, "goto");
  alone.parameters.add({"uavs", "marvin heliv", {}});
  EXPECT_FALSE(known(alone).gathering);
}

}  // namespace
}  // namespace skein::supervisor
