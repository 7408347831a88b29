// SPDX-License-Identifier: Apache-2.0
// Who gets which request, and what is answered where nobody does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using testing::FlownNode;
using ::testing::HasSubstr;

constexpr const char* kAtDegree1 = "at degree 1 the ground station runs the plan";

TEST(Routes, RequestsToTheExecutiveAreTakenFromDegreeTwo) {
  for (const int degree : {2, 3}) {
    FlownNode node(degree);
    EXPECT_TRUE(node.answer_to(testing::start_of(1, "goto")).accepted) << degree;
  }
}

TEST(Routes, AtDegreeOneTheyAreTheGroundsOwn) {
  const std::vector<mission::Request> requests = {
      testing::start_of(1, "goto"), executive::Abort{executive::TaskId(1)},
      executive::ProcessMessage{"go"}, executive::UpdateConditions{executive::TaskId(1), {}, {}},
      executive::Suppress{executive::TaskId(1)}};
  for (const mission::Request& request : requests) {
    FlownNode node(1);
    const Answer answer = node.answer_to(request);
    EXPECT_FALSE(answer.accepted);
    EXPECT_EQ(answer.why, kAtDegree1);
    EXPECT_EQ(answer.kind, kind_of(request));
    EXPECT_EQ(answer.id, id_of(request));
  }
}

TEST(Routes, WithoutAPlanningDomainMissionsAndDegreeFourAreRefusedAndTheWorldIsNot) {
  FlownNode node(3);

  EXPECT_THAT(node.answer_to(mission::UnitMission()).why, HasSubstr("no planning domain"));
  EXPECT_THAT(node.answer_to(mission::CancelGoals()).why, HasSubstr("no planning domain"));
  EXPECT_THAT(node.answer_to(mission::ChangeDegree{4}).why, HasSubstr("no planning domain"));
  EXPECT_TRUE(node.answer_to(mission::ChangeWorld()).accepted);
  EXPECT_TRUE(node.answer_to(mission::ChangeDegree{2}).accepted);
}

TEST(Routes, WhatCannotBeReadIsRefusedWithItsReason) {
  FlownNode node(3);

  const Effects effects =
      node.give(UnreadableCommand{{1, 9}, mission::RequestKind::kMission, 4, "tasks[0]: no name"});

  const auto answers = testing::all<Answer>(effects);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_FALSE(answers[0].accepted);
  EXPECT_EQ(answers[0].kind, mission::RequestKind::kMission);
  EXPECT_EQ(answers[0].id, 4U);
  EXPECT_EQ(answers[0].why, "tasks[0]: no name");
}

TEST(Routes, AnAnswerGoesOutAgainWhenItsCommandComesAgainAndNothingElseHappens) {
  FlownNode node(3);
  const Command command{{1, 5}, testing::start_of(1, "goto")};

  const Effects first = node.give(command);
  const Effects again = node.give(command);
  const Effects other_life = node.give(Command{{2, 5}, testing::start_of(1, "goto")});

  EXPECT_EQ(testing::all<ToVehicle>(first).size(), 1U);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_TRUE(std::get<Answer>(again[0]).accepted);
  EXPECT_FALSE(testing::all<Answer>(other_life)[0].accepted) << "task 1 is there already";
}

}  // namespace
}  // namespace skein::decision_node
