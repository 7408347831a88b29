// SPDX-License-Identifier: Apache-2.0
#include "../src/transfer_requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../src/request_facts.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::Formula;
using executive::Literal;
using executive::Modality;
using executive::TaskInState;
using executive::TaskState;
using mission::HeldTask;
using testing::a_task;
using ::testing::ElementsAre;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using ::testing::SizeIs;

HeldTask held(std::uint64_t task, TaskState state = TaskState::kScheduled,
              Formula preconditions = {}, Formula exit = {}) {
  HeldTask out;
  out.task = a_task(task);
  out.task.preconditions = std::move(preconditions);
  out.task.exit = std::move(exit);
  out.state = state;
  return out;
}

executive::Clause not_in_state(std::uint64_t task, TaskState state,
                               Modality modality = Modality::kMandatory) {
  return {Literal{TaskInState{id(task), state}, true, modality}};
}

executive::Clause message(const std::string& text) {
  return {Literal{executive::MessageReceived{text}, false, Modality::kMandatory}};
}

/// Task 1 has ended, 2 was aborted, 3 is running elsewhere; "go" was processed.
TransferFacts facts() {
  TransferFacts facts;
  facts.state_of = [](executive::TaskId task) -> std::optional<TaskState> {
    if (task == id(1)) return TaskState::kEnded;
    if (task == id(2)) return TaskState::kAborted;
    if (task == id(3)) return TaskState::kRunning;
    return std::nullopt;
  };
  facts.messages = {"go"};
  return facts;
}

std::vector<std::string> words(const std::vector<Request>& requests) {
  std::vector<std::string> out;
  for (const Request& request : requests) out.push_back(what_of(request));
  return out;
}

const executive::Task& started(const std::vector<Request>& requests, std::uint64_t task) {
  for (const Request& request : requests) {
    const auto* start = std::get_if<executive::Start>(&request);
    if (start != nullptr && start->task.id == id(task)) return start->task;
  }
  static const executive::Task kNone;
  ADD_FAILURE() << "task " << task << " is not started";
  return kNone;
}

TEST(TransferRequests, WhatIsUnderWayIsStartedFirstWithoutPreconditions) {
  const auto requests =
      requests_to_start({held(5, TaskState::kScheduled, {in_state(8, TaskState::kEnded)}),
                         held(8, TaskState::kRunning, {in_state(5, TaskState::kEnded)}),
                         held(9, TaskState::kStarted, {in_state(1, TaskState::kEnded)})},
                        facts());

  EXPECT_THAT(words(requests), ElementsAre("START 8 goto", "START 9 goto", "START 5 goto"));
  EXPECT_THAT(started(requests, 8).preconditions, IsEmpty());
  EXPECT_THAT(started(requests, 9).preconditions, IsEmpty());
  EXPECT_EQ(started(requests, 5).preconditions, Formula{in_state(8, TaskState::kEnded)});
}

// Found by random missions (--anything --busy 1002023): who awaited the look alone began with the
// flight behind it.
TEST(TransferRequests, WhatIsUnderWayComesLastToWhoAwaitsIt) {
  const auto requests =
      requests_to_start({held(8, TaskState::kRunning),
                         held(9, TaskState::kScheduled, {in_state(8, TaskState::kEnded)})},
                        facts(), FirstGiven::kWaiting);

  EXPECT_THAT(words(requests), ElementsAre("START 9 goto", "START 8 goto", "UPDATE-COND 9"));
  EXPECT_THAT(started(requests, 9).preconditions, SizeIs(1)) << "waits until they follow";
}

TEST(TransferRequests, WhatWasAbortingIsStartedAndAborted) {
  const auto requests = requests_to_start({held(5, TaskState::kAborting)}, facts());

  EXPECT_THAT(words(requests), ElementsAre("START 5 goto", "ABORT 5"));
}

TEST(TransferRequests, ConditionsOnLaterTasksFollow) {
  const auto requests =
      requests_to_start({held(5, TaskState::kRunning, {}, {in_state(6, TaskState::kEnded)}),
                         held(6, TaskState::kScheduled, {in_state(7, TaskState::kEnded)}), held(7)},
                        facts());

  EXPECT_THAT(words(requests), ElementsAre("START 5 goto", "START 6 goto", "START 7 goto",
                                           "UPDATE-COND 5", "UPDATE-COND 6"));
  EXPECT_THAT(started(requests, 5).exit, IsEmpty());
  EXPECT_THAT(started(requests, 6).preconditions, SizeIs(1)) << "holds the task back meanwhile";
  EXPECT_NE(started(requests, 6).preconditions, Formula{in_state(7, TaskState::kEnded)});
  EXPECT_EQ(std::get<executive::UpdateConditions>(requests[3]).exit,
            Formula{in_state(6, TaskState::kEnded)});
  EXPECT_EQ(std::get<executive::UpdateConditions>(requests[4]).preconditions,
            Formula{in_state(7, TaskState::kEnded)});
}

struct Case {
  std::string name;
  Formula before;  ///< Π of task 9; task 8 is running and moves too
  Formula after;
};
class ReducedConditions : public ::testing::TestWithParam<Case> {};

TEST_P(ReducedConditions, AreWhatCanStillChange) {
  const auto requests = requests_to_start(
      {held(8, TaskState::kRunning), held(9, TaskState::kScheduled, GetParam().before)}, facts());

  EXPECT_EQ(started(requests, 9).preconditions, GetParam().after);
}

const Formula kNever = {executive::Clause{}};
const executive::Clause kAfterRunning = {
    Literal{TaskInState{id(8), TaskState::kAborting}, false, Modality::kMandatory},
    Literal{TaskInState{id(8), TaskState::kEnded}, false, Modality::kMandatory},
    Literal{TaskInState{id(8), TaskState::kAborted}, false, Modality::kMandatory}};

INSTANTIATE_TEST_SUITE_P(
    TransferRequests, ReducedConditions,
    ::testing::Values(
        Case{"ended", {in_state(1, TaskState::kEnded)}, {}},
        Case{"ended_among_others",
             {in_state(1, TaskState::kEnded), in_state(8, TaskState::kEnded)},
             {in_state(8, TaskState::kEnded)}},
        Case{"ended_though_aborted", {in_state(2, TaskState::kEnded)}, kNever},
        Case{"optional", {in_state(2, TaskState::kEnded, Modality::kOptional)}, {}},
        Case{"not_ended_though_ended", {not_in_state(1, TaskState::kEnded)}, kNever},
        Case{"not_ended_optional", {not_in_state(1, TaskState::kEnded, Modality::kOptional)}, {}},
        Case{"not_ended_for_ever", {not_in_state(2, TaskState::kEnded)}, {}},
        Case{"unknown", {in_state(99, TaskState::kEnded)}, kNever},
        Case{"unknown_optional", {in_state(99, TaskState::kEnded, Modality::kOptional)}, {}},
        Case{"elsewhere", {in_state(3, TaskState::kEnded)}, {in_state(3, TaskState::kEnded)}},
        Case{"passed_state", {in_state(8, TaskState::kStarted)}, kNever},
        Case{"not_a_passed_state", {not_in_state(8, TaskState::kStarted)}, {}},
        Case{"present_state",
             {in_state(8, TaskState::kRunning)},
             {in_state(8, TaskState::kRunning)}},
        Case{"not_the_present_state", {not_in_state(8, TaskState::kRunning)}, {kAfterRunning}},
        Case{"message_heard", {message("go")}, {}},
        Case{"message_to_come", {message("come")}, {message("come")}},
        Case{"dead_alternative",
             {{in_state(2, TaskState::kEnded)[0], message("come")[0]}},
             {message("come")}}),
    [](const auto& one) { return one.param.name; });

TEST(TransferRequests, WhatShouldHaveStoppedIsStopped) {
  const Formula over = {in_state(1, TaskState::kEnded)};

  const auto requests = requests_to_start(
      {held(8, TaskState::kRunning, {}, over), held(9, TaskState::kScheduled, {}, over)}, facts());

  EXPECT_THAT(words(requests), ElementsAre("START 8 goto", "START 9 goto", "ABORT 8"));
  EXPECT_THAT(started(requests, 8).exit, IsEmpty());
  EXPECT_THAT(started(requests, 9).exit, SizeIs(1)) << "holds from the beginning";
}

}  // namespace
}  // namespace skein::ground_station
