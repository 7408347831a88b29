// SPDX-License-Identifier: Apache-2.0
// The one way to the functional layer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using functional::TaskId;
using functional::TaskState;
using functional::Verb;
using testing::asked_of_vehicle;
using ::testing::ElementsAre;
using testing::FlownNode;
using ::testing::IsEmpty;
using testing::start_of;

std::vector<std::uint64_t> dispatched(const Effects& effects) {
  std::vector<std::uint64_t> ids;
  for (const ToVehicle& one : testing::all<ToVehicle>(effects))
    if (one.request.verb == Verb::kDispatch) ids.push_back(one.request.id.value());
  return ids;
}

ElementaryRequest dispatch(std::uint64_t id, const std::string& type) {
  return {{Verb::kDispatch, TaskId(id), type, {}}};
}
ElementaryRequest interrupt(std::uint64_t id) { return {{Verb::kInterrupt, TaskId(id)}}; }
StatusTold status(std::uint64_t id, TaskState state) { return {{TaskId(id), state, ""}}; }

// A radio cut lets both arrive at once, and the vehicle needs a moment to come to rest.
TEST(Vehicle, WhatHoldsItWaitsUntilWhatWasInterruptedIsOver) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));
  node.give(status(12, TaskState::kRunning));

  node.give(interrupt(12));
  EXPECT_THAT(dispatched(node.give(dispatch(21, "goto"))), IsEmpty());
  EXPECT_THAT(dispatched(node.give(status(12, TaskState::kRunning))), IsEmpty());

  EXPECT_THAT(dispatched(node.give(status(12, TaskState::kAborted))), ElementsAre(21U));
}

// Found by random missions (--long-deaths): it had begun within a second, while the node was dead.
TEST(Vehicle, WhatBeganWhileTheNodeWasDeadIsHeardBeforeItIsGivenUp) {
  FlownNode node(2);
  node.answer_to(start_of(12, "goto"));

  node.wake_at(1);
  node.restarts_at(400);
  node.give(status(12, TaskState::kRunning));

  EXPECT_THAT(asked_of_vehicle(node.wake_at(600)), IsEmpty()) << "it goes on";
  EXPECT_THAT(testing::all<TaskChanged>(node.give(status(12, TaskState::kEnded))),
              ::testing::Not(IsEmpty()));
}

TEST(Vehicle, ALookWaitsForNothing) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));
  node.give(interrupt(12));

  EXPECT_THAT(dispatched(node.give(dispatch(22, "takeshot"))), ElementsAre(22U));
}

TEST(Vehicle, WhatWasNotInterruptedHoldsNothingUp) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));

  EXPECT_THAT(dispatched(node.give(dispatch(21, "goto"))), ElementsAre(21U));  // and is refused
}

TEST(Vehicle, WhatWaitsCanBeInterruptedItself) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));
  node.give(interrupt(12));
  node.give(dispatch(21, "goto"));

  const auto told = testing::all<StatusPassedOn>(node.give(interrupt(21)));

  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].status.state, TaskState::kAborted);
  EXPECT_THAT(dispatched(node.give(status(12, TaskState::kAborted))), IsEmpty());
}

// The ground gives it back while the vehicle still brakes: what comes next waits for that.
TEST(Vehicle, WhatIsInterruptedAndAskedForAgainEndsWhenTheVehicleSaysSo) {
  FlownNode node(1);
  node.give(dispatch(12, "goto"));
  node.give(status(12, TaskState::kRunning));
  node.give(interrupt(12));
  node.give(dispatch(21, "wait"));

  const auto again = node.give(dispatch(12, "goto"));
  const auto stopped = node.give(interrupt(12));

  EXPECT_THAT(dispatched(again), IsEmpty());
  EXPECT_THAT(testing::all<StatusPassedOn>(stopped), IsEmpty());
  EXPECT_THAT(dispatched(stopped), IsEmpty());
  EXPECT_THAT(dispatched(node.give(status(12, TaskState::kAborted))), ElementsAre(21U));
}

// ---- a functional layer that has lost its memory ----

std::vector<std::uint64_t> interrupted(const Effects& effects) {
  std::vector<std::uint64_t> ids;
  for (const ToVehicle& one : testing::all<ToVehicle>(effects))
    if (one.request.verb == Verb::kInterrupt) ids.push_back(one.request.id.value());
  return ids;
}

class Forgotten : public ::testing::TestWithParam<std::pair<const char*, bool>> {};

TEST_P(Forgotten, IsAskedForAgainOrGivenUpByWhatItsTypeSays) {
  const auto [type, again] = GetParam();
  FlownNode node(1);
  node.give(dispatch(12, type));
  node.give(status(12, TaskState::kRunning));

  const Effects effects = node.give(LayerForgot{});

  EXPECT_EQ(dispatched(effects).size(), again ? 1U : 0U);
  EXPECT_EQ(interrupted(effects).size(), again ? 0U : 1U);
}
INSTANTIATE_TEST_SUITE_P(Types, Forgotten,
                         ::testing::Values(std::pair("goto", false), std::pair("takeoff", false),
                                           std::pair("perceive", false), std::pair("land", true),
                                           std::pair("wait", true), std::pair("monitor", true),
                                           std::pair("takeshot", true)),
                         [](const auto& one) { return std::string(one.param.first); });

TEST(Forgotten, WhatIsOverIsNotAskedForAgain) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));
  node.give(status(12, TaskState::kEnded));

  const Effects effects = node.give(LayerForgot{});

  EXPECT_THAT(testing::all<ToVehicle>(effects), IsEmpty());
}

TEST(Forgotten, WhatWasInterruptedIsInterruptedOnceMoreAndHoldsUpWhatComesNext) {
  FlownNode node(1);
  node.give(dispatch(12, "wait"));
  node.give(interrupt(12));
  node.give(dispatch(21, "goto"));

  const Effects effects = node.give(LayerForgot{});

  EXPECT_THAT(interrupted(effects), ElementsAre(12U));
  EXPECT_THAT(dispatched(effects), IsEmpty());
  EXPECT_THAT(dispatched(node.give(status(12, TaskState::kAborted))), ElementsAre(21U));
}

// At degree 3 the executive has it; the answer to the interruption ends it.
TEST(Forgotten, ATaskThatIsGivenUpIsAbortedOnceTheLayerSaysThatItKnowsNoSuchTask) {
  FlownNode node(3);
  node.give(Command{{1, 1}, testing::start_of(7, "goto")});
  node.give(status(7, TaskState::kRunning));
  EXPECT_THAT(interrupted(node.give(LayerForgot{})), ElementsAre(7U));

  const Effects effects =
      node.give(StatusTold{{TaskId(7), TaskState::kAborted, "no such task here"}});

  const auto changed = testing::all<TaskChanged>(effects);
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].event.state, TaskState::kAborted);
  EXPECT_EQ(changed[0].event.reason, "no such task here");
}

}  // namespace
}  // namespace skein::decision_node
