// SPDX-License-Identifier: Apache-2.0
// Elementary tasks become requests, and the executive makes of them what was planned.
#include "skein/supervisor/commitment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "skein/supervisor/schedule.hpp"
#include "testing/scripted_flight.hpp"

namespace skein::supervisor {
namespace {

using executive::Clause;
using executive::Formula;
using executive::Literal;
using executive::Modality;
using executive::TaskInState;
using executive::TaskState;
using executive::TimeIs;
using testing::ElementsAre;
using testing::IsEmpty;

Clause is(std::uint64_t task, TaskState state, Modality modality = Modality::kMandatory) {
  return {Literal{TaskInState{id(task), state}, false, modality}};
}

mission::TaskDates dates(double earliest_start, std::optional<double> latest_start = {}) {
  mission::TaskDates result;
  result.earliest_start = at(earliest_start);
  result.latest_start = latest_start ? at(*latest_start) : MissionTime::max();
  return result;
}

executive::Task made(const mission::ElementaryTask& task, const mission::TaskDates& when = dates(0),
                     const std::set<executive::TaskId>& stopped = {}) {
  return to_start(task, when, stopped).task;
}

// Source: spec 2.7, 3.5.
TEST(ToStart, TakeshotOfKarmaRunsBesideItsWaitAndStopsWithIt) {
  const executive::Task shot = made(karma_plan()[3]);

  EXPECT_EQ(shot.id, id(103));
  EXPECT_EQ(shot.type, "takeshot");
  EXPECT_EQ(shot.parameters, karma_plan()[3].parameters);
  EXPECT_EQ(shot.preconditions, Formula{is(102, TaskState::kRunning)});
  EXPECT_EQ(shot.exit, Formula{is(102, TaskState::kEnded, Modality::kOptional)});
}

TEST(ToStart, IsSequential) {
  EXPECT_EQ(to_start(karma_plan()[0], dates(0), {}).mode, executive::InsertionMode::kSeq);
}

TEST(ToStart, EachDependenceIsAClause) {
  const executive::Task go = made(a_task(104, "goto").ended(103).ended(102).over(9));

  EXPECT_EQ(go.preconditions, (Formula{is(103, TaskState::kEnded), is(102, TaskState::kEnded),
                                       is(9, TaskState::kEnded, Modality::kOptional)}));
  EXPECT_THAT(go.exit, IsEmpty());
}

TEST(ToStart, TheEndOfATaskWithAStopIsAnyEnd) {
  const executive::Task go = made(a_task(104, "goto").ended(103).ended(102), dates(0), {id(103)});

  EXPECT_EQ(go.preconditions,
            (Formula{is(103, TaskState::kEnded, Modality::kOptional), is(102, TaskState::kEnded)}));
}

TEST(ToStart, WithoutConstraintsThereIsNoConditionOnTime) {
  EXPECT_THAT(made(a_task(1, "goto"), dates(10, 20)).preconditions, IsEmpty());
}

TEST(ToStart, AfterConstraintsHoldItBackToItsEarliestStart) {
  const Clause expected{Literal{TimeIs{at(40), true}}};

  EXPECT_EQ(made(a_task(1, "goto").start_after(40), dates(40)).preconditions, Formula{expected});
  EXPECT_EQ(made(a_task(1, "goto").end_after(90), dates(40)).preconditions, Formula{expected});
}

TEST(ToStart, BeforeConstraintsLetItStartUpToItsLatestStartIncluded) {
  const MissionTime too_late = at(70) + Duration::nanoseconds(1);
  const Clause expected{Literal{TimeIs{too_late, false}}};

  EXPECT_EQ(made(a_task(1, "goto").start_before(70), dates(0, 70)).preconditions,
            Formula{expected});
  EXPECT_EQ(made(a_task(1, "goto").end_before(90), dates(0, 70)).preconditions, Formula{expected});
  EXPECT_THAT(made(a_task(1, "goto").end_before(90), dates(0)).preconditions, IsEmpty());
}

TEST(ToStart, AStopWaitsForAnEndAfter) {
  EXPECT_EQ(made(a_task(3, "takeshot").stopped_by(2).end_after(90), dates(0)).exit,
            (Formula{is(2, TaskState::kEnded, Modality::kOptional),
                     Clause{Literal{TimeIs{at(90), true}}}}));
}

TEST(ToStart, ASynchronisationIsCarriedOver) {
  const mission::ElementaryTask meeting = a_task(42, "synchronise").running(41);

  EXPECT_EQ(made(meeting).synchronisation, meeting.synchronisation);
  EXPECT_EQ(made(meeting).synchronisation->id, 551U);
}

std::vector<executive::Input> requests_of(const Tasks& tasks) {
  return to_requests(tasks, schedule(tasks, {}, MissionTime()).dates, {});
}

TEST(ToRequests, AWaitStoppedByALaterTaskIsGivenItsExitConditionOnceThatIsThere) {
  const auto requests = requests_of(marvin_plan());

  ASSERT_EQ(requests.size(), 8U);
  EXPECT_THAT(std::get<executive::Start>(requests[1]).task.exit, IsEmpty());
  const auto& update = std::get<executive::UpdateConditions>(requests[7]);
  EXPECT_EQ(update.id, id(41));
  EXPECT_EQ(update.preconditions, std::nullopt);
  EXPECT_EQ(update.exit, Formula{is(42, TaskState::kEnded, Modality::kOptional)});
}

TEST(ToRequests, TasksThatTheExecutiveHasMayHaveStopsToo) {
  const Tasks tasks{a_task(5, "goto").ended(4).lasts(1, 2)};

  const auto requests = to_requests(tasks, {{id(5), dates(0)}}, {id(4)});

  EXPECT_EQ(std::get<executive::Start>(requests[0]).task.preconditions,
            Formula{is(4, TaskState::kEnded, Modality::kOptional)});
}

// Source: spec 3.5: the whole plan, through the executive itself.
TEST(ToRequests, KarmaFliesHerPlanInOrder) {
  Durations durations;
  for (const auto& [task, seconds] :
       {std::pair{100, 5}, {101, 30}, {102, 20}, {104, 40}, {105, 300}, {107, 50}, {108, 5}})
    durations[id(static_cast<std::uint64_t>(task))] = Duration::seconds(seconds);
  ScriptedFlight flight(karma_plan(), durations);

  flight.begin(requests_of(karma_plan()));
  flight.run_until();

  EXPECT_THAT(flight.told(),
              ElementsAre("dispatch 100", "dispatch 101", "dispatch 102", "dispatch 103",
                          "interrupt 103", "dispatch 104", "dispatch 105", "dispatch 106",
                          "interrupt 106", "dispatch 107", "dispatch 108"));
  EXPECT_EQ(flight.state(108), TaskState::kEnded);
  EXPECT_EQ(flight.seen().at(id(103)).over, at(55));
  EXPECT_EQ(flight.seen().at(id(108)).over, at(450));
}

// Source: spec 3.5 (VI.13).
TEST(ToRequests, MarvinWaitsForTheMeetingAndGoesOn) {
  Durations durations;
  for (const auto& [task, seconds] : {std::pair{40, 10}, {42, 7}, {43, 120}, {45, 20}, {46, 5}})
    durations[id(static_cast<std::uint64_t>(task))] = Duration::seconds(seconds);
  ScriptedFlight flight(marvin_plan(), durations);

  flight.begin(requests_of(marvin_plan()));
  flight.run_until();

  EXPECT_THAT(flight.told(),
              ElementsAre("dispatch 40", "dispatch 41", "interrupt 41", "dispatch 43",
                          "dispatch 44", "interrupt 44", "dispatch 45", "dispatch 46"));
  EXPECT_EQ(flight.seen().at(id(43)).started, at(17));
  EXPECT_EQ(flight.state(46), TaskState::kEnded);
}

TEST(ToRequests, ATaskThatIsTooLateIsNotStarted) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 20),
                    a_task(2, "goto").ended(1).lasts(10, 20).start_before(30)};
  ScriptedFlight flight(tasks, {{id(1), Duration::seconds(31)}, {id(2), Duration::seconds(10)}});

  flight.begin(requests_of(tasks));
  flight.run_until();

  EXPECT_THAT(flight.told(), ElementsAre("dispatch 1"));
  EXPECT_EQ(flight.state(2), TaskState::kAborted);
}

TEST(ToRequests, ATaskStartsAtItsLastInstantToo) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 20),
                    a_task(2, "goto").ended(1).lasts(10, 20).start_before(20)};
  ScriptedFlight flight(tasks, {{id(1), Duration::seconds(20)}, {id(2), Duration::seconds(10)}});

  flight.begin(requests_of(tasks));
  flight.run_until();

  EXPECT_EQ(flight.state(2), TaskState::kEnded);
}

}  // namespace
}  // namespace skein::supervisor
