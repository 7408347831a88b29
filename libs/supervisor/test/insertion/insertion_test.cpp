// SPDX-License-Identifier: Apache-2.0
// Where new high-level tasks go, with a planner of straight flights.
#include "skein/supervisor/insertion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "insertion/orders.hpp"
#include "insertion/trials.hpp"
#include "insertion/with.hpp"
#include "testing/straight_planner.hpp"

namespace skein::supervisor::testing {
namespace {

using mission::Placement;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Lab = InsertionLab;

InsertionOutcome insert(Lab& lab, Goals planned, Goals added,
                        Placement placement = Placement::kBest) {
  return insert_tasks(lab.insertion(std::move(planned), std::move(added), placement),
                      lab.straight.planner());
}

/// East of home, at 100, 200, 300 m.
Lab eastern() {
  Lab lab;
  lab.flying().place("A", 100, 0).place("B", 200, 0).place("C", 300, 0).place("D", 400, 0);
  return lab;
}

TEST(Insertion, AMissionByItselfIsPlannedInTheOrderAskedForWithOnePlanOnly) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {}, {Lab::visit(1, "C"), Lab::visit(2, "A")});

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 2));
  EXPECT_EQ(outcome.chosen, Placement::kLast);
  EXPECT_THAT(lab.straight.requested, SizeIs(1));
  EXPECT_TRUE(outcome.schedule.controllable);
}

TEST(Insertion, AfterAllPutsNewTasksBehindWhatIsPlanned) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "C")}, {Lab::visit(2, "A")}, Placement::kLast);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 2));
}

TEST(Insertion, FirstPutsNewTasksBeforeWhatIsPlanned) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "A")}, {Lab::visit(2, "C")}, Placement::kFirst);

  EXPECT_THAT(ids(outcome.order), ElementsAre(2, 1));
  EXPECT_EQ(outcome.chosen, Placement::kFirst);
}

TEST(Insertion, TourPutsNewTasksWhereTheyAreOnTheWay) {
  Lab lab = eastern();

  const auto outcome =
      insert(lab, {Lab::visit(1, "A"), Lab::visit(2, "C")}, {Lab::visit(3, "B")}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 3, 2));
}

TEST(Insertion, BestTakesTheTourWhenItCostsLess) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "A"), Lab::visit(2, "C")}, {Lab::visit(3, "B")});

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 3, 2));
  EXPECT_EQ(outcome.chosen, Placement::kTour);
  ASSERT_THAT(outcome.trials, SizeIs(2));
  EXPECT_LT(outcome.trials[1].cost, outcome.trials[0].cost);
}

TEST(Insertion, OfEqualOnesTheFirstTriedIsKeptAndNoOrderIsPlannedTwice) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "A")}, {Lab::visit(2, "B")});

  EXPECT_EQ(outcome.chosen, Placement::kLast);
  EXPECT_THAT(outcome.trials, SizeIs(2));
  EXPECT_EQ(std::count(lab.straight.requested.begin(), lab.straight.requested.end(),
                       std::vector<std::uint64_t>{1, 2}),
            1);
}

// ---- missions of which some cannot be planned ----

InsertionOutcome insert_any(Lab& lab, Goals planned, Goals added) {
  InsertionRequest request = lab.insertion(std::move(planned), std::move(added));
  request.any = true;
  return insert_tasks(request, lab.straight.planner());
}

TEST(Insertion, WithoutAPlanTheTaskBecauseOfWhichIsNamed) {
  Lab lab = eastern();
  lab.straight.blocked = {"B"};

  const auto outcome =
      insert(lab, {}, {Lab::visit(1, "A"), Lab::visit(2, "B"), Lab::visit(3, "C")});

  EXPECT_FALSE(outcome.plan);
  ASSERT_THAT(outcome.dropped, SizeIs(1));
  EXPECT_EQ(outcome.dropped[0].goal, mission::GoalId{2});
  EXPECT_FALSE(outcome.dropped[0].why.empty());
}

TEST(Insertion, WhatCannotBePlannedIsLeftOutWhenTheMissionAllowsIt) {
  Lab lab = eastern();
  lab.straight.blocked = {"B", "D"};

  const auto outcome =
      insert_any(lab, {Lab::visit(9, "A")},
                 {Lab::visit(1, "A"), Lab::visit(2, "B"), Lab::visit(3, "C"), Lab::visit(4, "D")});

  ASSERT_TRUE(outcome.plan);
  EXPECT_THAT(ids(outcome.order), ::testing::UnorderedElementsAre(9, 1, 3));
  ASSERT_THAT(outcome.dropped, SizeIs(2));
  EXPECT_EQ(outcome.dropped[0].goal, mission::GoalId{2});
  EXPECT_EQ(outcome.dropped[1].goal, mission::GoalId{4});
}

TEST(Insertion, WithNothingLeftToFlyForTheUavStaysOnTheGround) {
  Lab lab = eastern();
  lab.situation = {};
  lab.straight.blocked = {"B"};

  const auto outcome =
      insert_any(lab, {}, {Lab::simple(1, "take-off"), Lab::visit(2, "B"), Lab::simple(3, "land")});

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.dropped, SizeIs(3));
}

TEST(Insertion, WhatIsPlannedAlreadyIsNeverLeftOutForWhatIsNew) {
  Lab lab = eastern();
  const auto outcome =
      insert_any(lab, {Lab::visit(1, "A", ends_before(60))}, {Lab::visit(2, "B", ends_before(1))});

  EXPECT_FALSE(outcome.plan);  // nothing of the mission is left: what is planned stays as it is
  ASSERT_THAT(outcome.dropped, SizeIs(1));
  EXPECT_EQ(outcome.dropped[0].goal, mission::GoalId{2});
}

TEST(Insertion, TakeoffsComeFirstWaitsForOrdersThenLandingsLast) {
  for (const Placement placement : {Placement::kBest, Placement::kLast, Placement::kInTime,
                                    Placement::kTour, Placement::kFirst}) {
    Lab lab = eastern();
    lab.situation = {};

    const auto outcome =
        insert(lab,
               {Lab::simple(1, "take-off"), Lab::visit(2, "A"), Lab::simple(3, "await-orders"),
                Lab::simple(4, "land")},
               {Lab::simple(5, "take-off"), Lab::visit(6, "B"), Lab::simple(7, "land")}, placement);

    ASSERT_THAT(outcome.order, SizeIs(7)) << mission::to_text(placement);
    const auto order = ids(outcome.order);
    EXPECT_THAT(std::vector(order.begin(), order.begin() + 2), ElementsAre(1, 5));
    EXPECT_THAT(std::vector(order.begin() + 4, order.end()), ElementsAre(3, 4, 7));
  }
}

TEST(Insertion, ATaskWithoutAPlaceStaysBehindItsPredecessor) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "D"), Lab::stay(2, 30), Lab::visit(3, "A")},
                              {Lab::visit(4, "C"), Lab::stay(5, 30)}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(3, 4, 5, 1, 2));
}

TEST(Insertion, TasksWithoutAnyPlaceKeepTheirTurn) {
  Lab lab = eastern();

  const auto outcome =
      insert(lab, {Lab::stay(1, 30)}, {Lab::visit(2, "C"), Lab::visit(3, "A")}, Placement::kTour);
  const auto other =
      insert(lab, {Lab::visit(2, "C"), Lab::visit(3, "A")}, {Lab::stay(1, 30)}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 3, 2));
  EXPECT_THAT(ids(other.order), ElementsAre(3, 2, 1));
}

TEST(Insertion, TasksThatSynchroniseKeepTheirOrder) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::meet(1, 551, "C"), Lab::meet(2, 552, "A")},
                              {Lab::visit(3, "B")}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 3, 2));
}

// The partner was asked for them in that order, and waits in the first for this UAV.
TEST(Insertion, WhatIsDoneWithOthersKeepsItsOrderInATour) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::meet(1, 551, "C"), Lab::join(2, "A")},
                              {Lab::visit(3, "B")}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 3, 2));
}

TEST(Insertion, WhatIsDoneWithOthersKeepsItsOrderWhateverItsDeadlines) {
  Lab lab = eastern();
  const Goals goals = {Lab::join(1, "C"), Lab::visit(2, "B"),
                       Lab::meet(3, 551, "A", ends_before(60))};
  const PlanningRequest base = lab.base();
  const Standing standing;
  Judge judge(base, standing, lab.straight.planner());
  Roles roles(judge);
  const Movable movable = movable_of(goals, {}, roles, base);

  const Blocks order = urgent_in_time(movable, sketch_of(judge, goals), base);

  EXPECT_THAT(ids(order_of(movable, order)), ElementsAre(1, 3, 2));
}

// One that takes a landing for done on the ground: it comes true where another leads to.
TEST(Insertion, WhatComesTrueBehindAGoalThatIsToFollowItIsNoOrder) {
  Lab lab = eastern();
  InsertionRequest request =
      lab.insertion({}, {Lab::visit(1, "A"), Lab::simple(2, "land"), Lab::simple(3, "land")});
  mission::GoalBound after;
  after.goal = mission::GoalId(3);
  request.standing.bounds.of[mission::GoalId(1)] = {after};

  const auto outcome = insert_tasks(request, lab.straight.planner());

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.reasons, Contains(HasSubstr("goal 1 is to come after goal 3")));
}

TEST(Insertion, TheTourEndsWhereTheUavLands) {
  Lab lab;
  lab.flying().place("near", -50, 10).place("far", 500, 0);

  const auto outcome = insert(lab, {Lab::visit(1, "far"), Lab::simple(2, "land")},
                              {Lab::visit(3, "near")}, Placement::kTour);

  EXPECT_EQ(outcome.order.back().id, mission::GoalId(2));
  EXPECT_THAT(outcome.order, SizeIs(3));
}

TEST(Insertion, InTimePutsAnUrgentTaskWhereItsDeadlineCanBeKept) {
  Lab lab = eastern();
  const Goals planned = {Lab::visit(1, "A"), Lab::visit(2, "B"), Lab::visit(3, "D")};

  // B and back to C: 20 s out, 10 s there, 10 s on, 10 s there; 1.2 times as long at the most.
  const auto outcome =
      insert(lab, planned, {Lab::visit(4, "C", ends_before(80))}, Placement::kInTime);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 2, 4, 3));
  EXPECT_TRUE(outcome.schedule.controllable);
}

TEST(Insertion, InTimeDoesWhatIsPlannedBeforeWhatMayNotStartYet) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "D"), Lab::visit(2, "C")},
                              {Lab::visit(3, "A", starts_after(500))}, Placement::kInTime);

  EXPECT_THAT(ids(outcome.order), ElementsAre(1, 2, 3));
}

TEST(Insertion, NewTasksKeepTheirOrderInTime) {
  Lab lab = eastern();

  const auto outcome =
      insert(lab, {Lab::visit(1, "A")}, {Lab::visit(2, "D", ends_before(60)), Lab::visit(3, "B")},
             Placement::kInTime);

  EXPECT_THAT(ids(outcome.order), ElementsAre(2, 3, 1));
}

TEST(Insertion, BestTriesInTimeOnlyWhereThereIsAConstraint) {
  Lab lab = eastern();
  const Goals planned = {Lab::visit(1, "A"), Lab::visit(2, "D")};

  const auto free = insert(lab, planned, {Lab::visit(3, "B")});
  const auto bounded = insert(lab, planned, {Lab::visit(3, "B", ends_before(200))});

  EXPECT_THAT(free.trials, SizeIs(2));
  EXPECT_THAT(bounded.trials, SizeIs(3));
}

TEST(Insertion, WithoutRoomEveryReasonOfEveryTrialIsGivenOnce) {
  Lab lab = eastern();
  lab.straight.blocked = {"B"};

  const auto outcome = insert(lab, {Lab::visit(1, "C")}, {Lab::visit(2, "B"), Lab::visit(3, "A")});

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.order, IsEmpty());
  EXPECT_THAT(outcome.trials, SizeIs(2));
  EXPECT_THAT(outcome.reasons, ElementsAre("B is closed"));
}

TEST(Insertion, ADeadlineThatNoOrderKeepsIsRefusedWithTheTaskThatIsLate) {
  Lab lab = eastern();

  const auto outcome = insert(lab, {Lab::visit(1, "A")}, {Lab::visit(2, "D", ends_before(20))});

  EXPECT_FALSE(outcome.plan);
  ASSERT_FALSE(outcome.reasons.empty());
}

TEST(Insertion, APlanThatGoesBelowTheReserveIsRefused) {
  Lab lab = eastern();
  lab.energy(0.12);

  const auto outcome = insert(lab, {}, {Lab::visit(1, "D"), Lab::simple(2, "land")});

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.reasons, ElementsAre(HasSubstr("8.0 % of the energy")));
}

TEST(Insertion, NewTasksComeAfterWhatTheExecutiveHas) {
  Lab lab = eastern();
  lab.situation.next_id = executive::TaskId(8);
  lab.situation.motion = {
      {Duration::seconds(50), Duration::seconds(60)},
      mission::Dependence{mission::DependenceKind::kEnded, executive::TaskId(7)}};
  InsertionRequest request = lab.insertion({}, {Lab::visit(1, "A")});
  mission::ElementaryTask standing;
  standing.id = executive::TaskId(7);
  standing.type = "goto";
  standing.duration = {Duration::seconds(50), Duration::seconds(60)};
  request.standing.tasks = {standing};

  const auto outcome = insert_tasks(request, lab.straight.planner());

  ASSERT_TRUE(outcome.plan);
  EXPECT_EQ(outcome.schedule.dates.at(executive::TaskId(8)).earliest_start,
            MissionTime::seconds(50));
}

TEST(Insertion, AnAreaIsEnteredAtTheCornerThatIsNear) {
  Lab lab = eastern();
  lab.world.zones.push_back({"Z", {{150, -40}, {350, -40}, {350, 40}, {150, 40}}});
  world::SensorModel camera;
  camera.device = "camera";
  camera.aperture = 0.5;
  camera.range = 500;
  lab.knowledge.vehicle.sensors = {camera};
  const mission::HighLevelTask map{mission::GoalId(9), "map", {std::string("Z")}, {}};

  const auto outcome =
      insert(lab, {Lab::visit(1, "D"), Lab::visit(2, "A")}, {map}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(2, 9, 1));
}

TEST(Insertion, APlaceThatIsClosedDoesNotKeepTheOthersFromBeingOrdered) {
  Lab lab = eastern();
  world::Volume closed;
  closed.name = "closed";
  closed.polygon = {{90, -10}, {110, -10}, {110, 10}, {90, 10}};
  lab.world.volumes.push_back(closed);

  const auto outcome =
      insert(lab, {Lab::visit(1, "D"), Lab::visit(2, "A")}, {Lab::visit(3, "C")}, Placement::kTour);

  EXPECT_THAT(ids(outcome.order), ElementsAre(2, 3, 1));
}

Goals random_goals(Lab& lab, std::size_t count, std::uint64_t first) {
  Goals goals;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t id = first + i;
    const std::string name = "X" + std::to_string(id);
    lab.place(name, *rc::gen::inRange(-1000, 1000), *rc::gen::inRange(-1000, 1000));
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        goals.push_back(Lab::stay(id, 10));
        break;
      case 1:
        goals.push_back(Lab::visit(id, name, ends_before(*rc::gen::inRange(50, 900))));
        break;
      case 2:
        goals.push_back(Lab::meet(id, 551, name));
        break;
      default:
        goals.push_back(Lab::visit(id, name));
    }
  }
  return goals;
}

RC_GTEST_PROP(Insertion, EveryTrialOrdersAllTasksAndThePlanIsTheCheapestThatServes, ()) {
  Lab lab;
  lab.flying();
  const Goals planned = random_goals(lab, *rc::gen::inRange<std::size_t>(0, 6), 1);
  const Goals added = random_goals(lab, *rc::gen::inRange<std::size_t>(1, 4), 11);
  std::vector<mission::GoalId> all = ids_of(planned);
  for (const auto& goal : added) all.push_back(goal.id);

  const auto outcome = insert(lab, planned, added);

  double least = std::numeric_limits<double>::infinity();
  for (const Trial& trial : outcome.trials) {
    RC_ASSERT(std::is_permutation(trial.order.begin(), trial.order.end(), all.begin(), all.end()));
    if (trial.feasible) least = std::min(least, trial.cost);
    RC_ASSERT(trial.feasible == trial.reasons.empty());
  }
  RC_ASSERT(outcome.plan.has_value() == (least < 1e9));
  if (!outcome.plan) return;
  RC_ASSERT(outcome.plan->cost == least);
  RC_ASSERT(schedule(outcome.plan->tasks, {}, {}).controllable);
}

/// Lateness of an order at most speed, as the fake planner flies.
bool in_time(const Lab& lab, const Goals& order) {
  world::Vector2 at(0, 0);
  double time = 0;
  for (const auto& goal : order) {
    const world::Vector2 to =
        lab.world.places.at(std::get<std::string>(goal.arguments[0])).head<2>();
    time += 0.12 * (to - at).norm() + 10;
    at = to;
    if (goal.time.end_before && time > goal.time.end_before->to_seconds()) return false;
  }
  return true;
}

RC_GTEST_PROP(Insertion, InTimeFindsAMergeWhereverOneKeepsAllDeadlines, ()) {
  Lab lab;
  lab.flying();
  Goals planned, added;
  for (std::uint64_t id = 1; id <= 6; ++id) {
    const std::string name = "X" + std::to_string(id);
    lab.place(name, *rc::gen::inRange(-500, 500), *rc::gen::inRange(-500, 500));
    const bool bounded = *rc::gen::arbitrary<bool>();
    const auto time =
        bounded ? ends_before(*rc::gen::inRange(100, 600)) : mission::TimeConstraints{};
    (id <= 3 ? planned : added).push_back(Lab::visit(id, name, time));
  }
  bool possible = false;
  std::vector<bool> of_added = {false, false, false, true, true, true};
  do {
    Goals order;
    std::size_t i = 0, j = 0;
    for (const bool one : of_added) order.push_back(one ? added[j++] : planned[i++]);
    possible = possible || in_time(lab, order);
  } while (std::next_permutation(of_added.begin(), of_added.end()));

  const auto outcome = insert(lab, planned, added, Placement::kInTime);

  RC_ASSERT(outcome.plan.has_value() == possible);
}

}  // namespace
}  // namespace skein::supervisor::testing
