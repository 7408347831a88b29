// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/task_types.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::functional {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

const TaskType& shipped(const char* name) { return TaskTypes::shipped().of(name); }

TEST(ShippedTypes, WhatMovesTheVehicleOrKeepsItHoldsIt) {
  for (const char* type : {"takeoff", "land", "goto", "wait", "perceive", "monitor", "rendezvous"})
    EXPECT_TRUE(shipped(type).holds_vehicle()) << type;
  EXPECT_TRUE(shipped("joint:monitoring-with-relay").holds_vehicle());
}

TEST(ShippedTypes, WhatRunsAlongDoesNotHoldTheVehicle) {
  EXPECT_FALSE(shipped("takeshot").holds_vehicle());
  EXPECT_FALSE(shipped("synchronise").holds_vehicle());
}

TEST(ShippedTypes, PerceptionsUseTheDeviceThatTheirParameterNames) {
  for (const char* type : {"takeshot", "perceive", "monitor"})
    EXPECT_THAT(shipped(type).devices, ElementsAre("device")) << type;
  EXPECT_TRUE(shipped("goto").devices.empty());
}

TEST(ShippedTypes, OnlyTakeoffAndLandingChangeWhetherItFlies) {
  for (const std::string& name : TaskTypes::shipped().names()) {
    const Leaves expected = name == "takeoff" ? Leaves::kInTheAir
                            : name == "land"  ? Leaves::kOnTheGround
                                              : Leaves::kAsItWas;
    EXPECT_EQ(shipped(name.c_str()).leaves, expected) << name;
  }
}

TEST(ShippedTypes, SynchronisationsAreTheExecutivesAndJointTasksAreAgreedUpon) {
  EXPECT_THAT(TaskTypes::shipped().names(CarriedOutBy::kExecutive),
              UnorderedElementsAre("rendezvous", "synchronise"));
  EXPECT_TRUE(shipped("joint:anything").is_joint());
  EXPECT_FALSE(shipped("jointed").is_joint());
}

TEST(ShippedTypes, WhatIsStoppedByAnotherTaskSaysSo) {
  for (const char* type : {"wait", "takeshot", "monitor"})
    EXPECT_TRUE(shipped(type).can_end(Ending::kByStop)) << type;
  for (const char* type : {"takeoff", "land", "goto", "perceive"})
    EXPECT_FALSE(shipped(type).can_end(Ending::kByStop)) << type;
  EXPECT_TRUE(shipped("wait").can_end(Ending::kByOrder));
}

TEST(TaskTypes, ATypeThatIsNotDeclaredAsksNothing) {
  EXPECT_EQ(TaskTypes::shipped().find("spray"), nullptr);
  EXPECT_FALSE(shipped("spray").holds_vehicle());
  EXPECT_TRUE(shipped("spray").takes("nozzle"));
}

TEST(TaskTypes, ANameOfItsOwnCountsBeforeItsFamilyAndTheLongerFamilyBeforeTheShorter) {
  TaskTypes types;
  const auto declare = [&](const char* name, Motion motion) {
    TaskType type;
    type.name = name;
    type.motion = motion;
    types.declare(type);
  };
  declare("look:*", Motion::kKeeps);
  declare("look:along:*", Motion::kNone);
  declare("look:along:moving", Motion::kMoves);

  EXPECT_EQ(types.of("look:here").motion, Motion::kKeeps);
  EXPECT_EQ(types.of("look:along:lane").motion, Motion::kNone);
  EXPECT_EQ(types.of("look:along:moving").motion, Motion::kMoves);
  EXPECT_THAT(types.names(), ElementsAre("look:along:moving"));
}

TEST(TaskTypes, DeclaringATypeAgainReplacesIt) {
  TaskTypes types = TaskTypes::shipped();
  TaskType still;
  still.name = "goto";
  types.declare(still);

  EXPECT_FALSE(types.of("goto").holds_vehicle());
  EXPECT_TRUE(shipped("goto").holds_vehicle());
}

}  // namespace
}  // namespace skein::functional
