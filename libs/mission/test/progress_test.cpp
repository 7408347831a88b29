// SPDX-License-Identifier: Apache-2.0
// What was done of a high-level task, and changes of the world, in words.
#include "skein/mission/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/mission/alarm_name.hpp"
#include "skein/mission/autonomy.hpp"

namespace skein::mission {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Progress, OfNothingSaysNothing) {
  EXPECT_TRUE(Progress{}.none());
  EXPECT_EQ(to_text(Progress{}), "");
}

TEST(Progress, AddsUpWhatWasPerceived) {
  Progress progress;
  progress.looks = {{"ir", {0, 0, 40}, Duration::seconds(200.04)},
                    {"visible", {9, 0, 40}, Duration::seconds(90)}};

  EXPECT_EQ(progress.looked(), Duration::seconds(290.04));
  EXPECT_EQ(to_text(progress), "perceived 290 s");
}

TEST(Progress, SaysAllThatWasDone) {
  Progress progress;
  progress.waited = Duration::seconds(12.5);
  progress.reached = {{1, 2, 3}};
  progress.synchronised = {551};

  EXPECT_EQ(to_text(progress), "waited 12.5 s, 1 place reached, synchronised 551");
  EXPECT_FALSE(progress.none());
}

// ---- changes of the world ----

ChangeWorld known_place() {
  ChangeWorld change;
  change.place = {name_of_alarm(3), {10, 20, 0}, 5, world::CellState::kAlarm};
  return change;
}

ChangeWorld known_ground() {
  ChangeWorld change;
  change.ground = {"A", {{0, 0}, {9, 0}, {9, 9}}, 0.8, false, std::nullopt};
  return change;
}

TEST(ChangesOfTheWorld, SayWhatTheyAreAbout) {
  ChangeWorld opened;
  opened.volume.name = "tower";
  opened.remove = true;

  EXPECT_EQ(to_text(known_place()), "place 'alarm:3' known");
  EXPECT_EQ(to_text(known_ground()), "ground of 'A' known");
  EXPECT_EQ(to_text(opened), "volume 'tower' opened");
}

TEST(ChangesOfTheWorld, ThatMakeSenseHaveNoProblems) {
  EXPECT_THAT(problems_of(known_place()), IsEmpty());
  EXPECT_THAT(problems_of(known_ground()), IsEmpty());
}

TEST(ChangesOfTheWorld, AreRefusedWithEveryReason) {
  ChangeWorld place = known_place(), ground = known_ground();
  place.place = {"", {std::nan(""), 0, 0}, -1, std::nullopt};
  ground.ground->risk = 1.5;
  ground.ground->area.pop_back();

  EXPECT_THAT(problems_of(place), SizeIs(3));
  EXPECT_THAT(problems_of(ground), SizeIs(2));
  ground = known_ground();
  ground.ground->risk.reset();
  EXPECT_THAT(problems_of(ground),
              ElementsAre("nothing is said of the ground: risk, mapped or cells"));
}

}  // namespace
}  // namespace skein::mission
