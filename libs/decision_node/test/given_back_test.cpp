// SPDX-License-Identifier: Apache-2.0
// What the ground station's executive gives back to a UAV that has planned anew meanwhile.
// Source: spec 1.2, 6.2.
#include <gmock/gmock.h>

#include "testing/kept_uav.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using testing::goto_of;
using testing::KeptUav;
using ::testing::Not;
using testing::of;
using testing::start_of;

supervisor::JobFinished a_flight_and_a_look() {
  mission::ElementaryTask flight, look;
  const executive::Start to = goto_of(7, {100, 0, 50});
  flight.id = to.task.id;
  flight.type = to.task.type;
  flight.parameters = to.task.parameters;
  flight.duration = {Duration::seconds(1), Duration::seconds(300)};
  look.id = executive::TaskId(8);
  look.type = "takeshot";
  look.dependences = {{mission::DependenceKind::kEnded, flight.id}};
  look.duration = {Duration::seconds(20), Duration::seconds(20)};
  flight.origin = look.origin = mission::GoalId(701);
  supervisor::InsertionOutcome outcome;
  outcome.plan.emplace().tasks = {flight, look};
  outcome.order = {{flight.origin, "visit", {}, {}}};
  outcome.chosen = mission::Placement::kLast;
  return {1, outcome};
}

/// The look of its plan waits at the ground station's executive when it is given back.
KeptUav given_back() {
  KeptUav uav(of(ContactPolicy::kHold, 4));
  uav.flies_at({0, 0, 50});
  mission::UnitMission mission;
  mission.id = mission::MissionId(1);
  mission.tasks.push_back({mission::GoalId(701), "visit", {}, {}});
  uav.command(mission);
  uav.give(a_flight_and_a_look());
  uav.command(mission::ChangeDegree{1});
  uav.flies_at({100, 0, 50});
  uav.ends("goto");
  uav.command(mission::ChangeDegree{4, false, true});
  uav.news();
  return uav;
}

TEST(GivenBack, WhatComesInTimeIsDone) {
  KeptUav uav = given_back();
  uav.at(2);

  uav.command(start_of(8, "takeshot"));

  EXPECT_THAT(uav.news(), Contains("dispatch takeshot"));
}

// Found by random missions (--anything --busy 1008002): a wait came 39 s late and began in the
// middle of a flight.
TEST(GivenBack, WhatComesAfterThePlanWasMadeAnewIsRefused) {
  KeptUav uav = given_back();
  uav.at(6);

  uav.command(start_of(8, "takeshot"));

  EXPECT_THAT(uav.news(), Not(Contains("dispatch takeshot")));
}

// Found by storm handover/synchronised 12: a ground station that has forgotten all never gives it
// back, and nobody else could say that it is over.
TEST(GivenBack, WhatDoesNotComeIsToldToBeOver) {
  KeptUav uav = given_back();
  EXPECT_NE(uav.last_told_of(8), "aborted");

  uav.at(6);

  EXPECT_EQ(uav.last_told_of(8), "aborted");
}

// Found by random missions (--anything --busy --minds --merged 1008105): its ground station had let
// go of the task meanwhile, and who watched saw it under way to the end of the mission.
TEST(GivenBack, WhatTheVehicleEndsThatWasTheGroundsIsToldFromOnBoard) {
  KeptUav uav(of(ContactPolicy::kHold, 1));
  uav.flies_at({0, 0, 50});
  uav.give(ElementaryRequest{{functional::Verb::kDispatch, functional::TaskId(7), "goto",
                              goto_of(7, {100, 0, 50}).task.parameters}});
  EXPECT_EQ(uav.last_told_of(7), "") << "at degree 1 the ground station's executive tells";

  uav.command(mission::ChangeDegree{4});
  uav.ends("goto");

  EXPECT_EQ(uav.last_told_of(7), "ended");
}

// Found by random missions (--anything --busy --minds --merged 1008105): the ground station had not
// heard that it was over, and it began again.
TEST(GivenBack, WhatHasEndedIsNotBegunAgain) {
  KeptUav uav = given_back();

  uav.command(goto_of(7, {100, 0, 50}));

  EXPECT_THAT(uav.news(), Not(Contains("dispatch goto")));
}

}  // namespace
}  // namespace skein::decision_node
