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
using ::testing::ElementsAre;
using testing::FlownNode;
using ::testing::IsEmpty;

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

}  // namespace
}  // namespace skein::decision_node
