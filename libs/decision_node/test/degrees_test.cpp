// SPDX-License-Identifier: Apache-2.0
// The degree of autonomy: what it lets pass, and what is handed over when it changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using functional::TaskId;
using functional::TaskState;
using ::testing::ElementsAre;
using testing::FlownNode;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::uint64_t kMeeting = 551;

executive::Start synchronisation_of(std::uint64_t id, const std::string& with = "heliv") {
  executive::Start start = testing::start_of(id, "synchronise");
  start.task.synchronisation =
      executive::Synchronisation{kMeeting, {"marvin", with}, {"marvin", with}, {}};
  return start;
}

SyncMessage there(std::uint64_t id, double second, executive::SyncWord word) {
  return {id, "heliv", "marvin", word, MissionTime::seconds(second)};
}

std::vector<std::uint64_t> ids_of(const HandedOver& told) {
  std::vector<std::uint64_t> ids;
  for (const mission::HeldTask& one : told.hand_over.tasks) ids.push_back(one.task.id.value());
  return ids;
}

HandedOver handed_over(const Effects& effects) {
  const auto all = testing::all<HandedOver>(effects);
  return all.size() == 1 ? all[0] : HandedOver{{-1, {}, {}}};
}

TEST(Degrees, TheFirstIsToldAtTheStart) {
  for (const int degree : {1, 2, 3}) {
    const FlownNode node(degree);
    const auto told = testing::all<DegreeChanged>(node.born());
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_EQ(told[0].degree, degree);
    EXPECT_EQ(told[0].by, "");
    EXPECT_EQ(told[0].held, std::nullopt);
  }
}

TEST(Degrees, AChangeIsAnsweredThenToldWithWhoAskedThenThePlanIsHandedOver) {
  FlownNode node(3);
  node.give(Command{{1, 1}, testing::start_of(1, "goto")});

  const Effects effects = node.give(Command{{1, 2}, mission::ChangeDegree{2}, "anna"});

  ASSERT_THAT(effects, SizeIs(4));
  EXPECT_TRUE(std::get<Answer>(effects[0]).accepted);
  EXPECT_EQ(std::get<DegreeChanged>(effects[1]).by, "anna");
  EXPECT_EQ(std::get<DegreeChanged>(effects[1]).held, 1U);
  EXPECT_EQ(std::get<HandedOver>(effects[2]).hand_over.degree, 2);
  EXPECT_THAT(ids_of(std::get<HandedOver>(effects[2])), ElementsAre(1));
  EXPECT_EQ(std::get<BoardChanged>(effects[3]).degree, 2);
}

TEST(Degrees, WhatTheNodeCannotHaveIsRefusedWithWhatIsMissing) {
  FlownNode node(3);

  EXPECT_EQ(node.answer_to(mission::ChangeDegree{4}).why,
            "no planning domain in the scenario: degree 4 cannot be had");
  EXPECT_FALSE(node.answer_to(mission::ChangeDegree{5}).accepted);
  EXPECT_TRUE(node.answer_to(testing::start_of(1, "goto")).accepted) << "it is where it was";
}

TEST(Degrees, TheSameDegreeAgainTellsThePlanAgain) {
  FlownNode node(3);
  node.give(Command{{1, 1}, testing::start_of(4, "goto")});

  const Effects effects = node.give(Command{{1, 2}, mission::ChangeDegree{3}});

  EXPECT_THAT(ids_of(handed_over(effects)), ElementsAre(4));
  EXPECT_THAT(testing::asked_of_vehicle(effects), IsEmpty());
}

TEST(Degrees, BetweenTwoAndThreeWhatRunsGoesOnAndIsReportedAsBefore) {
  FlownNode node(3);
  node.give(Command{{1, 1}, testing::start_of(1, "goto")});

  node.give(Command{{1, 2}, mission::ChangeDegree{2}});
  const Effects over = node.give(testing::status_of(1, TaskState::kEnded));

  EXPECT_THAT(testing::all<StatusPassedOn>(over), IsEmpty());
  const auto told = testing::all<TaskChanged>(over);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().event.state, TaskState::kEnded);
}

// With its id, so that its status finds it there.
TEST(Degrees, DownToOneWhatRunsIsTheGroundsFromThenOn) {
  FlownNode node(3);
  node.give(Command{{1, 1}, testing::start_of(1, "goto")});
  executive::Start second = testing::start_of(2, "land");
  second.mode = executive::InsertionMode::kDep;
  node.give(Command{{1, 2}, second});
  node.give(testing::status_of(1, TaskState::kRunning));

  const Effects change = node.give(Command{{1, 3}, mission::ChangeDegree{1}});
  EXPECT_THAT(ids_of(handed_over(change)), ElementsAre(1, 2));
  EXPECT_THAT(testing::asked_of_vehicle(change), IsEmpty()) << "it flies on";

  const Effects over = node.give(testing::status_of(1, TaskState::kEnded));
  ASSERT_THAT(testing::all<StatusPassedOn>(over), SizeIs(1));
  EXPECT_THAT(testing::asked_of_vehicle(over), IsEmpty()) << "the next is the ground's to ask for";
}

TEST(Degrees, AtDegreeOneElementaryRequestsPassAndTheirStatusesComeBackUnchanged) {
  FlownNode node(1);

  const Effects asked =
      node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "goto", {}}});
  const Effects told = node.give(testing::status_of(3, TaskState::kAborted, "wind"));

  EXPECT_THAT(testing::asked_of_vehicle(asked), ElementsAre("dispatch goto"));
  ASSERT_THAT(testing::all<StatusPassedOn>(told), SizeIs(1));
  EXPECT_EQ(testing::all<StatusPassedOn>(told)[0].status.reason, "wind");
}

TEST(Degrees, AboveOneElementaryRequestsAreAbortedAtOnceWithTheReason) {
  for (const int degree : {2, 3}) {
    FlownNode node(degree);
    const Effects asked =
        node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "goto", {}}});
    EXPECT_THAT(testing::asked_of_vehicle(asked), IsEmpty());
    const auto told = testing::all<StatusPassedOn>(asked);
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_EQ(told[0].status.state, TaskState::kAborted);
    EXPECT_EQ(told[0].status.reason, "elementary requests are taken at degree 1 only");
  }
}

TEST(Degrees, IdsOfTheNodesOwnAreNoElementaryRequestsAtDegreeOneEither) {
  FlownNode node(1);

  const Effects asked = node.give(
      ElementaryRequest{{functional::Verb::kDispatch, functional::kFirstOwnId, "goto", {}}});

  EXPECT_THAT(testing::asked_of_vehicle(asked), IsEmpty());
  ASSERT_THAT(testing::all<StatusPassedOn>(asked), SizeIs(1));
  EXPECT_EQ(testing::all<StatusPassedOn>(asked)[0].status.state, TaskState::kAborted);
}

TEST(Degrees, WhatTheGroundStillHasInTheAirAfterDegreeOneIsPassedOnToItsEnd) {
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "goto", {}}});

  node.give(Command{{1, 1}, mission::ChangeDegree{3}});

  EXPECT_THAT(testing::all<StatusPassedOn>(node.give(testing::status_of(3, TaskState::kEnded))),
              SizeIs(1));
  EXPECT_THAT(testing::all<StatusPassedOn>(node.give(testing::status_of(3, TaskState::kEnded))),
              IsEmpty());
}

// With its id: it is the same flight.
TEST(Degrees, UpFromOneTheGroundGivesBackWhatItHasByStart) {
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "goto", {}}});
  node.give(Command{{1, 1}, mission::ChangeDegree{3}});

  EXPECT_TRUE(node.answer_to(testing::start_of(3, "goto")).accepted);

  const Effects over = node.give(testing::status_of(3, TaskState::kEnded));
  EXPECT_THAT(testing::all<StatusPassedOn>(over), IsEmpty());
  EXPECT_FALSE(testing::all<TaskChanged>(over).empty());
}

// The ground may be out of reach: the vehicle would refuse every motion while its task runs.
TEST(Degrees, UpFromOneWhatTheGroundHasNotGivenBackGivesWayToTheNextMotion) {
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "wait", {}}});
  node.give(testing::status_of(3, TaskState::kRunning));
  node.give(Command{{1, 1}, mission::ChangeDegree{3}});

  const Effects asked = node.give(Command{{1, 2}, testing::start_of(4, "goto")});
  const Effects over = node.give(testing::status_of(3, TaskState::kAborted, "interrupted"));

  EXPECT_THAT(testing::asked_of_vehicle(asked), ElementsAre("interrupt 3"));
  EXPECT_THAT(testing::asked_of_vehicle(over), ElementsAre("dispatch goto"));
  EXPECT_THAT(testing::all<StatusPassedOn>(over), SizeIs(1)) << "the ground hears how it ended";
}

TEST(Degrees, UpFromOneALookLeavesWhatTheGroundHasNotGivenBack) {
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "wait", {}}});
  node.give(Command{{1, 1}, mission::ChangeDegree{3}});

  const Effects asked = node.give(Command{{1, 2}, testing::start_of(4, "takeshot")});

  EXPECT_THAT(testing::asked_of_vehicle(asked), ElementsAre("dispatch takeshot"));
}

// Found by storms (handover/cut 702): the ground station's look was never ended, and each look of
// the plan on board was refused.
TEST(Degrees, UpFromOneALookOfTheGroundGivesWayToOneByTheSameDevice) {
  const auto look_by = [](const char* device) {
    functional::Parameters parameters;
    parameters.add("device", device);
    return parameters;
  };
  for (const bool same : {true, false}) {
    FlownNode node(1);
    node.give(ElementaryRequest{
        {functional::Verb::kDispatch, TaskId(3), "takeshot", look_by("visible")}});
    node.give(testing::status_of(3, TaskState::kRunning));
    node.give(Command{{1, 1}, mission::ChangeDegree{3}});
    executive::Start look = testing::start_of(4, "takeshot");
    look.task.parameters = look_by(same ? "visible" : "infrared");

    const Effects asked = node.give(Command{{1, 2}, look});
    const Effects over = node.give(testing::status_of(3, TaskState::kAborted, "interrupted"));

    EXPECT_THAT(testing::asked_of_vehicle(asked),
                ElementsAre(same ? "interrupt 3" : "dispatch takeshot"));
    if (same) {
      EXPECT_THAT(testing::asked_of_vehicle(over), ElementsAre("dispatch takeshot"));
    }
  }
}

// Found by an outsider's missions: each perception of the plan on board was refused for ten
// minutes.
TEST(Degrees, UpFromOneALookOfTheGroundGivesWayToAPerceptionByTheSameDevice) {
  functional::Parameters by_camera;
  by_camera.add("device", "visible");
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "takeshot", by_camera}});
  node.give(testing::status_of(3, TaskState::kRunning));
  node.give(Command{{1, 1}, mission::ChangeDegree{3}});
  executive::Start perception = testing::start_of(4, "perceive");
  perception.task.parameters = by_camera;

  const Effects asked = node.give(Command{{1, 2}, perception});
  const Effects over = node.give(testing::status_of(3, TaskState::kAborted, "interrupted"));

  EXPECT_THAT(testing::asked_of_vehicle(asked), ElementsAre("interrupt 3"));
  EXPECT_THAT(testing::asked_of_vehicle(over), ElementsAre("dispatch perceive"));
}

TEST(Degrees, UpFromOneWhatTheGroundHasNotGivenBackCanBeAborted) {
  FlownNode node(1);
  node.give(ElementaryRequest{{functional::Verb::kDispatch, TaskId(3), "goto", {}}});
  node.give(Command{{1, 1}, mission::ChangeDegree{3}});

  const Effects effects = node.give(Command{{1, 2}, executive::Abort{TaskId(3)}});

  EXPECT_THAT(testing::asked_of_vehicle(effects), ElementsAre("interrupt 3"));
  const auto answers = testing::all<Answer>(effects);
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_TRUE(answers[0].accepted);
}

TEST(Degrees, InterruptedInTheAirItHoldsAndOnTheGroundItDoesNot) {
  for (const bool airborne : {true, false}) {
    FlownNode node(3);
    node.give(testing::flying(airborne));
    node.give(Command{{1, 1}, mission::ChangeDegree{2, true}});

    const Effects again = node.give(Command{{1, 2}, mission::ChangeDegree{2}});
    EXPECT_THAT(ids_of(handed_over(again)), SizeIs(airborne ? 1 : 0));
  }
}

// Found by an outsider's missions: who asked for all to be aborted was refused it.
TEST(Degrees, WhatItDoesOfItsOwnCanBeAbortedAtDegreeOneToo) {
  for (const int degree : {1, 2}) {
    FlownNode node(3);
    node.give(testing::flying(true));
    const auto holds =
        ids_of(handed_over(node.give(Command{{1, 1}, mission::ChangeDegree{2, true}})));
    ASSERT_THAT(holds, SizeIs(1));
    node.give(Command{{1, 2}, mission::ChangeDegree{degree}});

    const Effects effects = node.give(Command{{1, 3}, executive::Abort{TaskId(holds[0])}});

    const auto answers = testing::all<Answer>(effects);
    ASSERT_THAT(answers, SizeIs(1)) << degree;
    EXPECT_TRUE(answers[0].accepted) << degree;
    EXPECT_THAT(testing::asked_of_vehicle(effects), SizeIs(1)) << "interrupted";
  }
}

// ---- synchronisation ----

struct SyncCase {
  int own, other;
  bool direct;
};
class SyncWays : public ::testing::TestWithParam<SyncCase> {};

TEST_P(SyncWays, GoDirectlyOnlyBetweenTwoThatMay) {
  FlownNode node(GetParam().own);
  if (GetParam().other > 0) node.give(DegreeTold{"heliv", GetParam().other});

  const auto sent = testing::all<SendSync>(node.give(Command{{1, 1}, synchronisation_of(1)}));

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].direct, GetParam().direct);
  EXPECT_EQ(sent[0].message.to, "heliv");
  EXPECT_EQ(sent[0].message.id, kMeeting);
  EXPECT_EQ(sent[0].expires, MissionTime::max());
}

INSTANTIATE_TEST_SUITE_P(Degrees, SyncWays,
                         ::testing::Values(SyncCase{2, 2, false}, SyncCase{2, 3, false},
                                           SyncCase{3, 1, false}, SyncCase{3, 2, false},
                                           SyncCase{3, 3, true}, SyncCase{3, 4, true},
                                           SyncCase{3, 0, true}, SyncCase{2, 0, false}));

TEST(Synchronisation, AWordThatCountsForSoLongExpiresThen) {
  Config config = FlownNode::config(3, ContactPolicy::kContinue, std::nullopt);
  config.sync_validity = Duration::seconds(30);
  FlownNode node(config);
  node.wake_at(5);

  const auto sent = testing::all<SendSync>(node.give(Command{{1, 1}, synchronisation_of(1)}));

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].expires, MissionTime::seconds(35));
}

TEST(Synchronisation, WithAUavThatIsNotThereIsToldAndNotSent) {
  FlownNode node(3);

  const Effects effects = node.give(Command{{1, 1}, synchronisation_of(1, "karma")});

  EXPECT_THAT(testing::all<SendSync>(effects), IsEmpty());
  const auto notices = testing::all<Notice>(effects);
  ASSERT_THAT(notices, SizeIs(1));
  EXPECT_EQ(notices[0].text, "no UAV 'karma' to synchronise with");
}

TEST(Synchronisation, ItEndsWhenTheOtherIsThere) {
  FlownNode node(3);
  node.give(Command{{1, 1}, synchronisation_of(1)});

  const Effects effects = node.give(there(kMeeting, 1, executive::SyncWord::kThere));

  EXPECT_THAT(testing::all<SyncHeard>(effects), SizeIs(1));
  const auto told = testing::all<TaskChanged>(effects);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().event.state, TaskState::kEnded);
}

TEST(Synchronisation, AtDegreeOneWordsAreForTheGround) {
  FlownNode node(1);

  const Effects effects = node.give(there(kMeeting, 1, executive::SyncWord::kThere));

  ASSERT_THAT(testing::all<SyncPassedOn>(effects), SizeIs(1));
  EXPECT_THAT(testing::all<SyncHeard>(effects), IsEmpty());
}

TEST(Synchronisation, OnTheWayDownToOneTheLatestWordOfEachMeetingIsPassedOn) {
  FlownNode node(3);
  node.give(there(1, 5, executive::SyncWord::kThere));
  node.give(there(1, 4, executive::SyncWord::kThere));  // overtaken on its way
  node.give(there(2, 6, executive::SyncWord::kThere));
  node.give(there(2, 7, executive::SyncWord::kThere));

  const auto passed =
      testing::all<SyncPassedOn>(node.give(Command{{1, 1}, mission::ChangeDegree{1}}));

  ASSERT_THAT(passed, SizeIs(2));
  EXPECT_EQ(passed[0].message.said, MissionTime::seconds(5));
  EXPECT_EQ(passed[1].message.said, MissionTime::seconds(7));
}

}  // namespace
}  // namespace skein::decision_node
