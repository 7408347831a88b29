// SPDX-License-Identifier: Apache-2.0
#include "rights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace skein::daemon_main {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// Who has a right of this kind on a slot, in any partition.
std::set<std::string> who(const std::string& verb, const std::string& slot) {
  std::istringstream lines(rights_of(node::Roster({"marvin", "heliv"}, {{"heliv", "autopilot"}})));
  std::set<std::string> found;
  std::string node, does, partition, what;
  while (lines >> node >> does >> partition >> what) {
    if (does == verb && what == slot) found.insert(node);
  }
  return found;
}

TEST(Rights, OnlyTheGroundStationCommands) {
  for (const char* slot : {"TaskRequest", "MissionRequest", "DegreeCommand", "WorldChange"}) {
    EXPECT_THAT(who("publish", slot), ElementsAre("ground")) << slot;
  }
}

TEST(Rights, OnlyTheSimulatorLeadsTheClockAndTheRadio) {
  EXPECT_THAT(who("publish", "Clock"), ElementsAre("sim"));
  EXPECT_THAT(who("publish", "LinkState"), ElementsAre("sim"));
}

TEST(Rights, OnlyWhoPlaysVehiclesSaysWhereTheyAre) {
  EXPECT_THAT(who("publish", "Truth"), UnorderedElementsAre("sim", "autopilot"));
}

TEST(Rights, OnlyOperatorsAskAndOnlyTheGroundStationHearsAndAnswersThem) {
  EXPECT_THAT(who("publish", "OperatorRequest"), ElementsAre("operator"));
  EXPECT_THAT(who("subscribe", "OperatorRequest"), UnorderedElementsAre("ground", "spy"));
  EXPECT_THAT(who("publish", "OperatorReply"), ElementsAre("ground"));
  EXPECT_THAT(who("publish", "UavBoard"), ElementsAre("ground"));
}

TEST(Rights, ARunnerAndASpyOnlyRead) {
  std::istringstream lines(rights_of(node::Roster({"marvin"})));
  std::vector<std::string> writes;
  for (std::string line; std::getline(lines, line);) {
    const bool theirs = line.starts_with("runner ") || line.starts_with("spy ");
    if (theirs && line.find(" publish ") != std::string::npos) writes.push_back(line);
  }
  EXPECT_THAT(writes, IsEmpty());
}

// Law: nobody writes in the name of another on a radio channel.
TEST(Rights, ANodeWritesOnRadioChannelsThatStartAtIt) {
  std::istringstream lines(rights_of(node::Roster({"marvin", "heliv", "karma"})));
  std::string node, does, partition, what;
  int radio = 0;
  while (lines >> node >> does >> partition >> what) {
    if (does != "publish" || !partition.starts_with("radio/")) continue;
    ++radio;
    EXPECT_TRUE(partition.starts_with("radio/" + node + ">")) << node << " " << partition;
  }
  EXPECT_GT(radio, 50);
}

}  // namespace
}  // namespace skein::daemon_main
