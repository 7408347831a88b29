// SPDX-License-Identifier: Apache-2.0
// Dates against Floyd–Warshall, and verdicts against flights of the executive itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "schedule/plan_network.hpp"
#include "skein/supervisor/commitment.hpp"
#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "test_cases.hpp"
#include "testing/rebuilt_dates.hpp"
#include "testing/rebuilt_network.hpp"
#include "testing/scripted_flight.hpp"

namespace skein::supervisor {
namespace {

using temporal::kInfinite;
using temporal::Ticks;

enum class Course { kAny, kLeast, kGreatest };

/// All shortest distances, by three loops.
class FloydWarshall {
 public:
  FloydWarshall(const temporal::Stnu& network, Course course)
      : n_(network.nodes.size()), d_(n_ * n_, kInfinite) {
    for (std::size_t i = 0; i < n_; ++i) at(i, i) = 0;
    for (const auto& arc : network.arcs) add(arc);
    if (course == Course::kLeast)
      for (const auto& arc : implied_by(network)) add(arc);
    for (const auto& link : network.contingent) {
      const Ticks min = course == Course::kGreatest ? link.max : link.min;
      const Ticks max = course == Course::kLeast ? link.min : link.max;
      add({link.activation, link.contingent, min, max});
    }
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t i = 0; i < n_; ++i)
        for (std::size_t j = 0; j < n_; ++j)
          if (at(i, k) != kInfinite && at(k, j) != kInfinite)
            at(i, j) = std::min(at(i, j), at(i, k) + at(k, j));
  }
  bool consistent() {
    for (std::size_t i = 0; i < n_; ++i)
      if (at(i, i) < 0) return false;
    return true;
  }
  MissionTime earliest(std::size_t node) { return MissionTime::nanoseconds(-at(node, 0)); }
  MissionTime latest(std::size_t node) {
    return at(0, node) == kInfinite ? MissionTime::max() : MissionTime::nanoseconds(at(0, node));
  }

 private:
  Ticks& at(std::size_t i, std::size_t j) { return d_[i * n_ + j]; }
  void add(const temporal::Arc& arc) {
    if (arc.max != kInfinite) at(arc.from, arc.to) = std::min(at(arc.from, arc.to), arc.max);
    if (arc.min != temporal::kMinusInfinite)
      at(arc.to, arc.from) = std::min(at(arc.to, arc.from), -arc.min);
  }

  std::size_t n_;
  std::vector<Ticks> d_;
};

// Dates by the rules of the header: those of every course when controllable, else of free choice.
bool dates_agree(const Tasks& tasks, const Observations& seen, MissionTime now,
                 const Schedule& result) {
  const temporal::Stnu network = network_of(tasks, seen, now);
  FloydWarshall any(network, Course::kAny);
  if (any.consistent() != result.consistent) return false;
  if (!result.consistent) return result.dates.empty() && result.foreseen.empty();
  FloydWarshall low(network, result.controllable ? Course::kLeast : Course::kAny);
  FloydWarshall high(network, result.controllable ? Course::kGreatest : Course::kAny);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const mission::TaskDates expected{low.earliest(2 * i + 1), high.latest(2 * i + 1),
                                      low.earliest(2 * i + 2), high.latest(2 * i + 2)};
    if (result.dates.at(tasks[i].id) != expected) return false;
  }
  return true;
}

std::vector<std::optional<Ticks>> dates_seen(const Tasks& tasks, const Observations& seen) {
  std::vector<std::optional<Ticks>> dates{0};
  for (const auto& task : tasks) {
    const auto found = seen.find(task.id);
    const Observation one = found == seen.end() ? Observation() : found->second;
    dates.push_back(one.started ? std::optional(one.started->count()) : std::nullopt);
    dates.push_back(one.over ? std::optional(one.over->count()) : std::nullopt);
  }
  return dates;
}

/// What a flight did not keep to; empty: all of it.
std::string broken_by(const Tasks& tasks, const ScriptedFlight& flight, const Schedule& promised) {
  const auto dates = dates_seen(tasks, flight.seen());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const std::string name = to_text(tasks[i].id);
    if (!dates[2 * i + 1] || !dates[2 * i + 2]) return "task " + name + " did not come about";
    const auto& window = promised.foreseen.at(tasks[i].id);
    const auto start = MissionTime::nanoseconds(*dates[2 * i + 1]);
    const auto end = MissionTime::nanoseconds(*dates[2 * i + 2]);
    if (start < window.earliest_start || start > window.latest_start) return "start of " + name;
    if (end < window.earliest_end || end > window.latest_end) return "end of " + name;
  }
  const temporal::Stnu network = network_of(tasks, {}, MissionTime());
  const auto violated = temporal::find_violations(network, dates);
  return violated.empty() ? "" : "link " + std::to_string(violated.front().index);
}

/// A flight with the network beside it, that tells the executive of holds as a supervisor does.
class HeldFlight {
 public:
  HeldFlight(const Tasks& tasks, const Schedule& plan, Durations durations)
      : tasks_(tasks), plan_(plan), told_(plan.holds), flight_(tasks, std::move(durations)) {
    flight_.begin(to_requests(tasks, plan.dates, {}, plan.holds));
    look(MissionTime());
  }

  void run_until(MissionTime end = MissionTime::max()) {
    while (const auto now = flight_.step(end)) look(*now);
  }
  const ScriptedFlight& flight() const { return flight_; }
  const Schedule& schedule() const { return network_.schedule(); }

 private:
  void look(MissionTime now) {
    std::vector<TaskView> views;
    std::set<executive::TaskId> stopped;
    for (const auto& task : tasks_) {
      const auto seen = flight_.seen().find(task.id);
      views.push_back({&task, seen == flight_.seen().end() ? Observation() : seen->second});
      if (!task.stop.empty()) stopped.insert(task.id);
    }
    network_.update(views, now);
    for (const TaskView& view : views) {
      if (view.seen.started || view.seen.over) continue;
      const auto found = schedule().holds.find(view.task->id);
      const auto holds = found == schedule().holds.end() ? std::vector<Hold>() : found->second;
      if (holds == told_[view.task->id]) continue;
      told_[view.task->id] = holds;
      auto start = to_start(*view.task, plan_.dates.at(view.task->id), stopped, holds);
      flight_.tell(executive::UpdateConditions{view.task->id, start.task.preconditions, {}}, now);
    }
  }

  const Tasks& tasks_;
  const Schedule& plan_;
  Holds told_;
  ScriptedFlight flight_;
  PlanNetwork network_;
};

HeldFlight flown(const Tasks& tasks, const Schedule& plan, Random& random) {
  return HeldFlight(tasks, plan, draw_durations(tasks, random));
}

RC_GTEST_PROP(ScheduleLaws, DatesAreThoseOfFloydAndWarshall, (std::uint64_t seed, bool odd)) {
  Random random(seed);
  const Tasks tasks = random_plan(random, odd);

  const Schedule result = schedule(tasks, {}, MissionTime());

  RC_ASSERT(dates_agree(tasks, {}, MissionTime(), result));
  RC_ASSERT(result.conflicts.empty() == result.controllable);
  for (const Conflict& one : result.conflicts) RC_ASSERT(!one.why.empty());
}

/// What the first of ten flights that breaks anything breaks; empty: none does.
std::string broken_in_flights(std::uint64_t seed, bool odd) {
  Random random(seed);
  const Tasks tasks = random_plan(random, odd);
  const Schedule plan = schedule(tasks, {}, MissionTime());
  if (!plan.controllable) return "";
  for (int i = 0; i < 10; ++i) {
    HeldFlight flight = flown(tasks, plan, random);
    flight.run_until();
    const std::string why = broken_by(tasks, flight.flight(), plan);
    if (!why.empty()) return why;
  }
  return "";
}

// Starting each task as early as its conditions and holds allow is a strategy that succeeds.
TEST(ScheduleLaws, FlightsOfAControllablePlanKeepEverything) {
  const std::uint64_t plans = skein::testing::cases<std::uint64_t>(60, 4000);
  std::vector<std::string> broken;
  for (std::uint64_t seed = 1; seed <= plans; ++seed) {
    for (const bool odd : {false, true}) {
      const std::string why = broken_in_flights(seed, odd);
      if (!why.empty()) broken.push_back(std::to_string(seed) + (odd ? " odd: " : ": ") + why);
    }
  }

  EXPECT_EQ(broken, std::vector<std::string>());
}

RC_GTEST_PROP(ScheduleLaws, AControllablePlanStaysSoWhileItIsFlown, (std::uint64_t seed)) {
  Random random(seed);
  const Tasks tasks = random_plan(random, false);
  const Schedule plan = schedule(tasks, {}, MissionTime());
  if (!plan.controllable) return;
  HeldFlight flight = flown(tasks, plan, random);

  for (int i = 1; i <= 5; ++i) {
    const MissionTime now = at(20.0 * i + random.uniform());
    flight.run_until(now);
    const Schedule then = schedule(tasks, flight.flight().seen(), now);

    RC_ASSERT(then.controllable);
    RC_ASSERT(dates_agree(tasks, flight.flight().seen(), now, then));
    RC_ASSERT(then.latest_end <= plan.latest_end);
    RC_ASSERT(then.earliest_end >= plan.earliest_end);
  }
}

// The laws above would hold of nothing at all: how much they are about.
TEST(ScheduleLaws, RandomPlansAreOfEverySort) {
  int controllable = 0, only_consistent = 0, inconsistent = 0, constrained = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    const Tasks tasks = random_plan(random, seed % 2 == 0);
    const Schedule result = schedule(tasks, {}, MissionTime());

    controllable += result.controllable ? 1 : 0;
    only_consistent += result.consistent && !result.controllable ? 1 : 0;
    inconsistent += result.consistent ? 0 : 1;
    constrained += result.controllable && std::any_of(tasks.begin(), tasks.end(),
                                                      [](auto& task) { return task.time.any(); })
                       ? 1
                       : 0;
  }

  EXPECT_GT(controllable, 100);
  EXPECT_GT(only_consistent, 10);
  EXPECT_GT(inconsistent, 30);
  EXPECT_GT(constrained, 30);
}

/// A wait of 20 s beside which a takeshot must start that waits for a relay of up to 100 s.
Tasks late_companion() {
  return {a_task(1, "joint:relay").lasts(10, 100), a_task(2, "wait").lasts(20),
          a_task(3, "takeshot").running(2).ended(1).stopped_by(2)};
}

TEST(ScheduleLaws, AHeldBackWaitIsThereWhenItsLateCompanionStarts) {
  const Tasks tasks = late_companion();
  const Schedule plan = schedule(tasks, {}, MissionTime());
  for (const double relay : {10.0, 50.0, 79.0, 80.0, 81.0, 100.0}) {
    HeldFlight flight(tasks, plan,
                      {{id(1), Duration::seconds(relay)}, {id(2), Duration::seconds(20)}});

    flight.run_until();

    EXPECT_EQ(broken_by(tasks, flight.flight(), plan), "") << "relay of " << relay << " s";
  }
}

// What a hold is worth: without it some flight fails.
TEST(ScheduleLaws, SomeFlightOfAPlanWithoutItsHoldsFails) {
  const Tasks tasks = late_companion();
  const Schedule plan = schedule(tasks, {}, MissionTime());
  ScriptedFlight flight(tasks, {{id(1), Duration::seconds(100)}, {id(2), Duration::seconds(20)}});

  flight.begin(to_requests(tasks, plan.dates, {}));
  flight.run_until();

  EXPECT_NE(broken_by(tasks, flight, plan), "");
}

/// A wait of 7 s beside which a takeshot must start that waits for a relay of 4 to 6 s, which
/// begins at 5 s.
Tasks companion_of_a_later_relay() {
  return {a_task(1, "goto").lasts(5), a_task(2, "joint:relay").ended(1).lasts(4, 6),
          a_task(3, "wait").lasts(7), a_task(4, "takeshot").running(3).ended(2).stopped_by(3)};
}

TEST(ScheduleLaws, AWaitBeginsNoEarlierThanWhatItsCompanionFollowsLeavesRoomFor) {
  const Tasks tasks = companion_of_a_later_relay();
  const Schedule plan = schedule(tasks, {}, MissionTime());

  EXPECT_EQ(plan.foreseen.at(id(3)).earliest_start, at(4.001));
  for (const double relay : {4.0, 5.0, 6.0}) {
    HeldFlight flight(tasks, plan,
                      {{id(1), Duration::seconds(5)},
                       {id(2), Duration::seconds(relay)},
                       {id(3), Duration::seconds(7)}});
    flight.run_until();

    EXPECT_EQ(broken_by(tasks, flight.flight(), plan), "") << "relay of " << relay << " s";
  }
}

/// A flight of 8 s at least beside which a takeshot must start that waits for a relay of 14 s,
/// which begins when a first flight is over.
Tasks companion_of_a_flight_that_may_be_short() {
  return {a_task(1, "goto").lasts(35, 67), a_task(2, "joint:relay").ended(1).lasts(14),
          a_task(3, "goto").ended(1).lasts(8, 45),
          a_task(4, "takeshot").running(3).ended(2).stopped_by(3)};
}

TEST(ScheduleLaws, WhatMayBeShortBeginsNotBeforeItsCompanionIsSureToComeInTime) {
  const Tasks tasks = companion_of_a_flight_that_may_be_short();
  const Schedule plan = schedule(tasks, {}, MissionTime());

  EXPECT_EQ(plan.foreseen.at(id(3)).earliest_start, at(41.001));
  EXPECT_EQ(plan.foreseen.at(id(3)).latest_start, at(73.001));
  for (const double first : {35.0, 50.0, 67.0}) {
    for (const double second : {8.0, 45.0}) {
      HeldFlight flight(tasks, plan,
                        {{id(1), Duration::seconds(first)},
                         {id(2), Duration::seconds(14)},
                         {id(3), Duration::seconds(second)}});
      flight.run_until();

      EXPECT_EQ(broken_by(tasks, flight.flight(), plan), "") << first << " and " << second << " s";
    }
  }
}

}  // namespace
}  // namespace skein::supervisor
