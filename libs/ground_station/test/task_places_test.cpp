// SPDX-License-Identifier: Apache-2.0
#include "../src/task_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using testing::a_task;
using testing::abort_of;
using testing::at;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Task 5 of marvin is in the executive at the ground, 6 was told from on board.
struct Places : ::testing::Test {
  Places() {
    executive::Config config;
    config.name = "marvin";
    local = LocalExecutives({{"marvin", config}});
    local.of("marvin").handle(executive::Start{a_task(5), executive::InsertionMode::kSeq}, at(1));
    tell(5, TaskState::kRunning, true);
    tell(6, TaskState::kRunning, false);
  }
  void tell(std::uint64_t task, TaskState state, bool at_ground) {
    monitoring.handle(TaskEventReceived{"marvin", id(task), "goto", state, "", at_ground}, at(1));
  }
  SendRequest request(Request what) const {
    SendRequest request;
    request.uav = "marvin";
    request.request = std::move(what);
    return request;
  }
  /// START 9 once the task has ended, without what cannot change.
  executive::Formula adapted(std::uint64_t task, bool at_ground) const {
    executive::Start start{a_task(9), executive::InsertionMode::kSeq};
    start.task.preconditions = {in_state(task, TaskState::kEnded)};
    const Request adapted = places.adapted(request(start), at_ground);
    return std::get<executive::Start>(adapted).task.preconditions;
  }

  Monitoring monitoring{{{"marvin", 3}, {"heliv", 1}}};
  LocalExecutives local{{}};
  TaskPlaces places{monitoring, local};
};

TEST_F(Places, ARequestGoesToWhoHasItsTask) {
  EXPECT_TRUE(places.is_at_ground(request(abort_of(5))));
  EXPECT_FALSE(places.is_at_ground(request(abort_of(6))));
}

TEST_F(Places, ARequestAboutWhatNobodyHasGoesWhereTheDegreeSays) {
  SendRequest of_heliv = request(abort_of(7));
  of_heliv.uav = "heliv";

  EXPECT_FALSE(places.is_at_ground(request(abort_of(7))));
  EXPECT_TRUE(places.is_at_ground(of_heliv));
}

TEST_F(Places, WhatTheReceiverDoesNotKnowIsSettledInItsConditions) {
  tell(5, TaskState::kEnded, true);
  tell(6, TaskState::kEnded, false);

  EXPECT_THAT(adapted(6, true), IsEmpty());
  EXPECT_THAT(adapted(5, false), IsEmpty());
}

TEST_F(Places, WhatTheReceiverKnowsOrCanStillChangeStays) {
  EXPECT_THAT(adapted(6, true), SizeIs(1));
  tell(5, TaskState::kEnded, true);
  tell(6, TaskState::kEnded, false);

  EXPECT_THAT(adapted(5, true), SizeIs(1));
  EXPECT_THAT(adapted(6, false), SizeIs(1));
}

TEST_F(Places, ATaskIsStartedWithoutWaitingForWhatIsOverOnTheBoard) {
  tell(6, TaskState::kEnded, false);
  mission::HeldTask after_ended;
  after_ended.task = a_task(8);
  after_ended.task.preconditions = {in_state(6, TaskState::kEnded)};

  const auto requests = places.starting("marvin", {after_ended});

  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_THAT(std::get<executive::Start>(requests[0]).task.preconditions, IsEmpty());
}

}  // namespace
}  // namespace skein::ground_station
