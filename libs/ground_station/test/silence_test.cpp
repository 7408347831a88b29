// SPDX-License-Identifier: Apache-2.0
// Scripts that wait for a UAV to be silent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/ground_station/mission_planning.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using testing::a_step;
using testing::at;
using ::testing::ElementsAre;
using testing::flat_terrain;
using testing::id;
using ::testing::IsEmpty;
using testing::only;

Trigger when(decltype(Trigger::what) what) { return {std::move(what)}; }

MissionPlanning playing(const Step& step) {
  return {Script{{step}, {}, Duration::seconds(60)}, flat_terrain()};
}

std::vector<std::string> steps_done(const std::vector<MissionPlanning::Effect>& effects) {
  std::vector<std::string> names;
  for (const StepDone& step : only<StepDone>(effects)) names.push_back(step.name);
  return names;
}

Trigger silent_for(double seconds) { return when(OnSilence{"marvin", Duration::seconds(seconds)}); }
PeerReachable contact(const std::string& uav, bool reachable) { return {uav, reachable, false}; }

TEST(Silence, ASilenceCountsFromWhenContactWasLost) {
  MissionPlanning mps = playing(a_step("gone", silent_for(60)));
  mps.handle(contact("marvin", true), at(2));
  mps.handle(contact("marvin", false), at(100));
  mps.handle(contact("heliv", true), at(101));
  mps.handle(contact("marvin", false), at(130));  // it is still not heard

  EXPECT_EQ(mps.next_wakeup(), at(160));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(159.9))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(160))), ElementsAre("gone"));
  EXPECT_EQ(mps.next_wakeup(), std::nullopt);
}

TEST(Silence, OneThatWasNeverHeardIsSilentFromTheStart) {
  MissionPlanning mps = playing(a_step("gone", silent_for(60)));

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(60))), ElementsAre("gone"));
}

TEST(Silence, WhoIsHeardAgainInTimeWasNotSilent) {
  MissionPlanning mps = playing(a_step("gone", silent_for(60)));
  mps.handle(contact("marvin", false), at(10));
  mps.handle(contact("marvin", true), at(50));

  EXPECT_EQ(mps.next_wakeup(), std::nullopt);
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(500))), IsEmpty());
}

// What happened once has happened, for a step that waits for more.
TEST(Silence, ASilenceThatCameAboutIsRemembered) {
  MissionPlanning mps = playing(a_step(
      "gone", when(AllOf{{silent_for(60), when(OnTask{"marvin", id(1), TaskState::kEnded})}})));
  mps.handle(Tick{}, at(60));
  mps.handle(contact("marvin", true), at(70));

  EXPECT_THAT(steps_done(mps.handle(TaskChanged{"marvin", id(1), TaskState::kEnded}, at(80))),
              ElementsAre("gone"));
}

TEST(Silence, AStepThatRepeatsIsDoneOnceInEachSilence) {
  Step gone = a_step("gone", silent_for(60));
  gone.once = false;
  MissionPlanning mps = playing(gone);

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(60))), ElementsAre("gone"));
  EXPECT_EQ(mps.next_wakeup(), std::nullopt);
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(200))), IsEmpty()) << "it is the same silence";
  mps.handle(contact("marvin", true), at(210));
  mps.handle(contact("marvin", false), at(300));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(360))), ElementsAre("gone"));
}

// Whoever comes back has heard nobody meanwhile, and hears first who is there.
TEST(Silence, WhileTheGroundStationWasAwayNobodyWasSilent) {
  MissionPlanning mps = playing(a_step("gone", silent_for(60)));
  mps.handle(contact("marvin", true), at(2));
  mps.handle(contact("marvin", false), at(100));

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(200))), IsEmpty());
  EXPECT_EQ(mps.next_wakeup(), at(260));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(260))), ElementsAre("gone"));
}

}  // namespace
}  // namespace skein::ground_station
