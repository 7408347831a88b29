// SPDX-License-Identifier: Apache-2.0
// What a UAV does that was left in the air, and what it tells those who have it in hand.
// Source: spec 2.6.
#include <gmock/gmock.h>

#include "testing/kept_uav.hpp"

namespace skein::decision_node {
namespace {

using testing::closed;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::goto_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kDue;
using testing::KeptUav;
using testing::KeptUavSetup;
using testing::kLost;
using ::testing::Not;
using testing::of;
using testing::start_of;
using world::Vector3;

/// At degree 4, its deliberation stopped by a loss of contact that is over, and its hold ended by
/// an operator who then did nothing more.
KeptUav left_alone(const std::vector<world::Volume>& volumes = {}, int degree = 4) {
  KeptUavSetup setup = of(ContactPolicy::kHold, degree);
  setup.volumes = volumes;
  KeptUav uav(setup);
  uav.loses_the_ground(kLost);
  uav.at(kDue);
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.command(goto_of(13, {100, 0, 50}));
  uav.ends("goto");
  uav.news();
  return uav;
}

TEST(LeftInTheAir, ComesHomeOnceItsEnergyLastsNoLongerThanThat) {
  KeptUav uav = left_alone();

  uav.at(100);
  uav.flies_at({100, 0, 50}, 0.5);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.at(200);
  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(206);

  EXPECT_THAT(uav.news(),
              ElementsAre("notice: its energy lasts no longer than to come home",
                          "policy return: left in the air without a task, and its deliberation "
                          "was stopped",
                          "dispatch goto"));
}

const std::string kIdles =
    "notice: in the air with nothing under way for 60 s, at degree 3: who has it in hand decides";

TEST(LeftInTheAir, BelowDegreeFourItOnlySaysSoOnceAFlight) {
  KeptUav uav = left_alone({}, 3);

  for (double now = 100; now < 130; now += 6) {
    uav.flies_at({100, 0, 50}, 0.11);
    uav.at(now);
  }
  EXPECT_THAT(uav.news(),
              ElementsAre("notice: its energy lasts no longer than to come home", kIdles));

  uav.flies_at({0, 0, 0}, 0.11);
  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(140);
  EXPECT_THAT(uav.news(), ElementsAre("notice: its energy lasts no longer than to come home"));
}

TEST(LeftInTheAir, WhileATaskOfAnOperatorIsUnderWayItOnlySaysSo) {
  KeptUav uav = left_alone();
  uav.command(start_of(14, "wait"));
  uav.news();

  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(100);

  EXPECT_THAT(uav.news(), ElementsAre("notice: its energy lasts no longer than to come home"));
}

// Found by random missions (--anything --clean 990014): an operator's plan had been given up at its
// first task, and two others waited 2,000 s for the UAV to leave.
TEST(LeftInTheAir, BelowDegreeFourItSaysOnceThatNothingIsUnderWay) {
  KeptUav uav = left_alone({}, 3);

  for (double now = kDue; now < kDue + 60; now += 6) {
    uav.at(now);
    uav.flies_at({100, 0, 50});
  }
  EXPECT_THAT(uav.news(), IsEmpty());
  for (double now = kDue + 60; now < 400; now += 6) {
    uav.at(now);
    uav.flies_at({100, 0, 50});
  }
  EXPECT_THAT(uav.news(), ElementsAre(kIdles));
}

TEST(LeftInTheAir, BelowDegreeFourItSaysAgainWhatComesAfterATask) {
  KeptUav uav = left_alone({}, 3);
  const auto idles = [&](double from) {
    for (double now = from; now < from + 100; now += 6) {
      uav.at(now);
      uav.flies_at({100, 0, 50});
    }
    return uav.news();
  };
  EXPECT_THAT(idles(100), ElementsAre(kIdles));
  uav.command(start_of(14, "wait"));
  EXPECT_THAT(idles(300), Not(Contains(kIdles))) << "it waits";

  uav.ends("wait");
  EXPECT_THAT(idles(500), ElementsAre(kIdles));
}

TEST(LeftInTheAir, LeavesAirThatClosesAroundIt) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)});
  uav.at(200);
  EXPECT_THAT(uav.news(), IsEmpty());

  uav.at(245);

  EXPECT_THAT(uav.news(),
              ElementsAre("policy hold: the air around it is closed (volume 'smoke'): it leaves",
                          "dispatch goto"));
}

TEST(LeftInTheAir, WhileItDeliberatesItsSupervisorLeavesClosedAir) {
  KeptUavSetup setup = of(ContactPolicy::kHold, 4);
  setup.volumes = {closed("smoke", {100, 0, 0}, 50, 300)};
  KeptUav uav(setup);
  uav.flies_at({100, 0, 50});
  uav.news();

  uav.at(245);

  EXPECT_THAT(uav.news(), Not(Contains(HasSubstr("policy"))));
}

const std::string kInSmoke = "notice: it is in air that is closed or about to be (volume 'smoke')";

TEST(LeftInTheAir, BelowDegreeFourItTellsItsOperatorOfClosedAirAndStays) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)}, 3);

  uav.at(235);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.at(245);
  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke));
  for (const double later : {265.0, 290.0, 310.0}) uav.at(later);
  EXPECT_THAT(uav.news(), ElementsAre(kIdles)) << "of the smoke once is enough";
}

TEST(LeftInTheAir, UnderATaskOfAnOperatorItTellsThemOfClosedAir) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)});
  uav.command(start_of(14, "wait"));
  uav.news();

  uav.at(245);

  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke));
}

TEST(InAnOperatorsHand, OnlyWhoWasOutOfClosedAirForAWhileTellsOfItAgain) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50)}, 3);
  const Vector3 in{100, 0, 50}, out{300, 0, 50};
  const auto seen = [&](double seconds, const Vector3& at) {
    uav.flies_at(at);
    uav.at(seconds);
    return uav.news();
  };
  seen(100, in);

  EXPECT_THAT(seen(110, out), IsEmpty());
  EXPECT_THAT(seen(115, in), IsEmpty()) << "wavers on the border";
  EXPECT_THAT(seen(120, out), IsEmpty());
  EXPECT_THAT(seen(150, out), IsEmpty());
  EXPECT_THAT(seen(155, in), ElementsAre(kInSmoke));
}

TEST(InAnOperatorsHand, OneThatDrivesTellsOfClosedAirToo) {
  KeptUavSetup setup = of(ContactPolicy::kHold);
  setup.drives = true;
  setup.volumes = {closed("smoke", {100, 0, 0}, 50)};
  KeptUav robot(setup);

  robot.flies_at({100, 0, 0});

  EXPECT_THAT(robot.news(), ElementsAre(kInSmoke));
}

// It stands there until its energy is used up: whoever has it in hand is to know (missions of an
// outsider 178, 255).
TEST(InAnOperatorsHand, OneThatDrivesSaysOnceThatItsEnergyIsShortAndStandsWhereItIs) {
  KeptUavSetup setup = of(ContactPolicy::kHold);
  setup.drives = true;
  KeptUav robot(setup);
  robot.flies_at({100, 0, 0}, 0.5);
  EXPECT_THAT(robot.news(), IsEmpty());

  for (double now = 100; now < 130; now += 6) {
    robot.flies_at({100, 0, 0}, 0.11);
    robot.at(now);
  }
  EXPECT_THAT(robot.news(), ElementsAre("notice: its energy lasts no longer than to come home"));
}

TEST(InAnOperatorsHand, AllVolumesAroundAreNamed) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300), closed("far", {300, 0, 0}, 50),
                            closed("storm", {90, 0, 0}, 60, 300)},
                           3);

  uav.at(245);

  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke, HasSubstr("'storm'")));
}

}  // namespace
}  // namespace skein::decision_node
