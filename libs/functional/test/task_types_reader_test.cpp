// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "skein/functional/task_types.hpp"

namespace skein::functional {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string errors_of(const std::string& text) {
  const auto types = read_task_types(text, "types.yaml");
  return types ? "none" : to_text(types.error());
}

TEST(TaskTypesReader, ReadsEveryKey) {
  const auto types = read_task_types(
      "task-types:\n"
      "  spray:\n"
      "    parameters: [nozzle, amount]\n"
      "    motion: keeps\n"
      "    devices: [nozzle]\n"
      "    radio: true\n"
      "    carried-out-by: interaction\n"
      "    ends: [by-order, by-stop]\n",
      "types.yaml");

  ASSERT_TRUE(types.has_value());
  const TaskType& spray = types->of("spray");
  EXPECT_EQ(spray.name, "spray");
  EXPECT_THAT(*spray.parameters, ElementsAre("nozzle", "amount"));
  EXPECT_EQ(spray.motion, Motion::kKeeps);
  EXPECT_EQ(spray.leaves, Leaves::kAsItWas);
  EXPECT_THAT(spray.devices, ElementsAre("nozzle"));
  EXPECT_TRUE(spray.radio);
  EXPECT_EQ(spray.by, CarriedOutBy::kInteraction);
  EXPECT_THAT(spray.ends, ElementsAre(Ending::kByOrder, Ending::kByStop));
}

TEST(TaskTypesReader, WhatIsNotSaidIsNothing) {
  const auto types = read_task_types("task-types: {muse: {ends: [by-itself]}}", "types.yaml");

  ASSERT_TRUE(types.has_value());
  const TaskType& muse = types->of("muse");
  EXPECT_FALSE(muse.parameters.has_value());
  EXPECT_FALSE(muse.holds_vehicle());
  EXPECT_TRUE(muse.devices.empty());
  EXPECT_EQ(muse.by, CarriedOutBy::kFunctionalLayer);
}

TEST(TaskTypesReader, NamesEveryErrorAtOnceWithItsLine) {
  EXPECT_THAT(errors_of("task-types:\n"
                        "  spray:\n"
                        "    motion: hops\n"
                        "    leave: in-the-air\n"
                        "    ends: [by-itself]\n"
                        "  muse:\n"
                        "    ends: []\n"),
              AllOf(HasSubstr("types.yaml:3:"), HasSubstr("hops"), HasSubstr("types.yaml:4:"),
                    HasSubstr("did you mean 'leaves'"), HasSubstr("types.yaml:7:"),
                    HasSubstr("it never ends")));
}

TEST(TaskTypesReader, ADeviceIsNamedByAParameter) {
  EXPECT_THAT(errors_of("task-types: {spray: {parameters: [amount], devices: [nozzle], "
                        "ends: [by-itself]}}"),
              HasSubstr("'nozzle' is none of its parameters"));
}

TEST(TaskTypesReader, OnlyWhatMovesTheVehicleLeavesItElsewhere) {
  EXPECT_THAT(errors_of("task-types: {muse: {leaves: in-the-air, ends: [by-itself]}}"),
              HasSubstr("expected motion: moves"));
}

TEST(TaskTypesReader, TheShippedTypesAreThoseOfTheFileThatPeopleRead) {
  std::ifstream file(std::string(SKEIN_SOURCE_DIR) + "/scenarios/task-types.yaml");
  std::stringstream text;
  text << file.rdbuf();
  const auto types = read_task_types(text.str(), "task-types.yaml");

  ASSERT_TRUE(types.has_value()) << to_text(types.error());
  ASSERT_EQ(types->names(), TaskTypes::shipped().names());
  for (const std::string& name : types->names())
    EXPECT_EQ(types->of(name), TaskTypes::shipped().of(name)) << name;
}

}  // namespace
}  // namespace skein::functional
