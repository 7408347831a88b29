// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/repair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/repair_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Strings = std::vector<std::string>;
using testing::RepairFixture;

// One UAV: surveys points; reaches each by the corridor or, where it is closed, by the long way.
const std::string kUav = R"((defdomain d (
  (:operator (!takeoff ?u) ((ground ?u)) ((ground ?u)) ((air ?u)))
  (:operator (!goto ?u ?from ?to) ((air ?u) (at ?u ?from)) ((at ?u ?from)) ((at ?u ?to)))
  (:operator (!detour ?u ?from ?to) ((air ?u) (at ?u ?from)) ((at ?u ?from)) ((at ?u ?to)) 5)
  (:operator (!takeshot ?u ?p) ((air ?u) (at ?u ?p) (camera ?u)) () ((shot ?p)))
  (:operator (!swap-camera ?u) ((spare ?u) (ground ?u)) ((spare ?u)) ((camera ?u)))
  (:operator (!land ?u) ((air ?u) (at ?u base)) ((air ?u)) ((ground ?u)))
  (:method (mission ?u ?a ?b) () ((ready ?u) (survey ?u ?a) (survey ?u ?b) (home ?u)))
  (:method (ready ?u)
    in-air ((air ?u) (camera ?u)) ()
    take-off ((ground ?u) (camera ?u)) ((!takeoff ?u))
    repair ((ground ?u)) ((!swap-camera ?u) (!takeoff ?u)))
  (:method (survey ?u ?p)
    done ((shot ?p)) ()
    shoot () ((fly ?u ?p) (!takeshot ?u ?p)))
  (:method (fly ?u ?p)
    there ((at ?u ?p)) ()
    straight ((at ?u ?q) (not (closed ?q ?p))) ((!goto ?u ?q ?p) (fly ?u ?p))
    around ((at ?u ?q)) ((!detour ?u ?q ?p) (fly ?u ?p)))
  (:method (home ?u) () ((fly ?u base) (!land ?u)))))
(defproblem p d ((ground karma) (at karma base) (camera karma)) ((mission karma p1 p2)))
)";
// 0 takeoff, 1 goto p1, 2 takeshot p1, 3 goto p2, 4 takeshot p2, 5 goto base, 6 land

struct Uav : RepairFixture {
  Uav() : RepairFixture(kUav) { make_plan(); }
};

TEST(Repair, APlanThatLostNothingStands) {
  Uav fixture;

  const Repair& repair = fixture.diverge(2, Strings{"(wind strong)"}).repair(2);

  EXPECT_EQ(repair.verdict, RepairVerdict::kStands);
  EXPECT_EQ(fixture.actions(repair.plan), fixture.actions(fixture.plan()));
  EXPECT_EQ(repair.kept.size(), 5U);
  EXPECT_THAT(repair.redone, IsEmpty());
  EXPECT_THAT(repair.dropped, IsEmpty());
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, StandsAtEveryPointWhenNothingHappened) {
  Uav fixture;
  for (StepIndex executed = 0; executed <= fixture.plan().steps.size(); ++executed) {
    const Repair& repair = fixture.repair(executed);

    EXPECT_EQ(repair.verdict, RepairVerdict::kStands) << executed;
    EXPECT_EQ(repair.plan.cost, fixture.plan().cost);
    EXPECT_EQ(fixture.fault(), "");
  }
}

TEST(Repair, ATaskAheadIsDecomposedOtherwise) {
  Uav fixture;

  const Repair& repair = fixture.diverge(1, Strings{"(closed p1 p2)"}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(),
              ElementsAre("(!goto karma base p1)", "(!takeshot karma p1)", "(!detour karma p1 p2)",
                          "(!takeshot karma p2)", "(!goto karma p2 base)", "(!land karma)"));
  EXPECT_THAT(fixture.redone(), ElementsAre("(fly karma p2)"));
  EXPECT_THAT(fixture.actions(repair.plan, repair.added), ElementsAre("(!detour karma p1 p2)"));
  EXPECT_THAT(fixture.actions(fixture.plan(), repair.dropped), ElementsAre("(!goto karma p1 p2)"));
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, WhatWasReachedInTheMiddleOfATaskIsReachedAgain) {
  Uav fixture;
  fixture.diverge(2, Strings{"-(at karma p1)", "(at karma ridge)"});

  const Repair& repair = fixture.repair(2);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(),
              ElementsAre("(!goto karma ridge p1)", "(!takeshot karma p1)", "(!goto karma p1 p2)",
                          "(!takeshot karma p2)", "(!goto karma p2 base)", "(!land karma)"));
  EXPECT_EQ(repair.kept.size(), 5U);
  ASSERT_TRUE(repair.clobbered);
  EXPECT_EQ(fixture.text(repair.clobbered->fact), "(at karma p1)");
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, ATaskInProgressIsBegunAgainAndItsExecutedStepsStay) {
  Uav fixture;
  fixture.diverge(1, Strings{"-(air karma)", "(ground karma)", "-(camera karma)", "(spare karma)"});

  const Repair& repair = fixture.repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.redone(), ElementsAre("again (mission karma p1 p2)"));
  EXPECT_EQ(fixture.rest().front(), "(!swap-camera karma)");
  EXPECT_EQ(repair.kept.size(), 6U);
  EXPECT_EQ(repair.plan.tree[0].kind, TreeNodeKind::kUnordered);
  EXPECT_EQ(fixture.text(repair.plan.tree[2].task), "(!takeoff karma)");
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, SaysThatThereIsNone) {
  Uav fixture;
  fixture.diverge(3, Strings{"-(camera karma)"});

  const Repair& repair = fixture.repair(3);

  EXPECT_EQ(repair.verdict, RepairVerdict::kNoPlan);
  EXPECT_TRUE(repair.plan.steps.empty());
  ASSERT_TRUE(repair.clobbered);
  EXPECT_EQ(fixture.text(repair.clobbered->task), "(!takeshot karma p2)");
}

TEST(Repair, OfARepairedPlanKeepsBothPrefixes) {
  Uav fixture;
  fixture.diverge(2, Strings{"-(at karma p1)", "(at karma ridge)"}).repair(2);
  fixture.adopt();

  const Repair& repair = fixture.diverge(3, Strings{"(closed p1 p2)"}).repair(3);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.redone(), ElementsAre("(fly karma p2)"));
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, OfATaskBegunAgainCanBeRepairedToo) {
  Uav fixture;
  fixture.diverge(1, Strings{"-(air karma)", "(ground karma)", "-(camera karma)", "(spare karma)"});
  fixture.repair(1);
  fixture.adopt();

  const Repair& repair = fixture.diverge(4, Strings{"(closed p1 p2)"}).repair(4);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.redone(), ElementsAre("(fly karma p2)"));
  EXPECT_EQ(fixture.fault(), "");
}

// Parcels by truck; a truck that broke down is replaced only two tasks higher up.
const std::string kLogistics = R"((defdomain d (
  (:operator (!drive ?t ?from ?to) ((at ?t ?from) (runs ?t)) ((at ?t ?from)) ((at ?t ?to)))
  (:operator (!load ?p ?t) ((at ?p ?x) (at ?t ?x)) ((at ?p ?x)) ((in ?p ?t)))
  (:operator (!unload ?p ?t) ((in ?p ?t) (at ?t ?x)) ((in ?p ?t)) ((at ?p ?x)))
  (:method (deliver ?p ?to) ((truck ?t) (runs ?t)) ((carry ?p ?t ?to)))
  (:method (carry ?p ?t ?to)
    aboard ((in ?p ?t)) ((bring ?t ?to) (!unload ?p ?t))
    away ((at ?p ?x)) ((bring ?t ?x) (!load ?p ?t) (bring ?t ?to) (!unload ?p ?t)))
  (:method (bring ?t ?to)
    there ((at ?t ?to)) ()
    away ((at ?t ?x)) ((!drive ?t ?x ?to)))))
)";

struct Logistics : RepairFixture {
  explicit Logistics(const std::string& tasks)
      : RepairFixture(kLogistics + R"((defproblem p d
    ((truck lorry) (runs lorry) (at lorry depot) (truck van) (runs van) (at van depot)
     (at one mill) (at two mine)) )" +
                      tasks + ")") {
    make_plan();
  }
};

TEST(Repair, GoesUpUntilAnotherChoiceIsOpen) {
  Logistics fixture("((deliver one port))");
  ASSERT_THAT(fixture.actions(fixture.plan()),
              ElementsAre("(!drive lorry depot mill)", "(!load one lorry)",
                          "(!drive lorry mill port)", "(!unload one lorry)"));

  const Repair& repair = fixture.diverge(1, Strings{"-(runs lorry)"}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!drive van depot mill)", "(!load one van)",
                                          "(!drive van mill port)", "(!unload one van)"));
  EXPECT_THAT(fixture.redone(), ElementsAre("again (deliver one port)"));
  EXPECT_GE(repair.attempts, 3U);
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, OfOneUnorderedTaskLeavesTheOthersAlone) {
  Logistics fixture("(:unordered (carry one lorry port) (carry two van port))");
  const std::size_t steps = fixture.plan().steps.size();
  fixture.diverge(1, Strings{"-(at two mine)", "(at two farm)"});

  const Repair& repair = fixture.repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_EQ(repair.plan.steps.size(), steps);
  EXPECT_THAT(fixture.redone(), ElementsAre(HasSubstr("(carry two van port)")));
  for (const std::string& action : fixture.actions(repair.plan, repair.added)) {
    EXPECT_THAT(action, HasSubstr("van"));
  }
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, KeepsTheOrderOfUnorderedTasksThatStand) {
  Logistics fixture("(:unordered (carry one lorry port) (carry two van port))");
  for (StepIndex executed = 0; executed <= fixture.plan().steps.size(); ++executed) {
    const Repair& repair = fixture.repair(executed);

    EXPECT_EQ(repair.verdict, RepairVerdict::kStands) << executed;
  }
}

TEST(Repair, ATaskThatIsFinishedStaysFinished) {
  Logistics fixture("((deliver one port) (deliver two port))");
  fixture.diverge(4, Strings{"-(at one port)", "(at one mill)"});

  const Repair& repair = fixture.repair(4);

  EXPECT_EQ(repair.verdict, RepairVerdict::kStands);
}

// A gate is held open for a convoy; closing it meanwhile is forbidden, and cheaper.
const std::string kGate = R"((defdomain d (
  (:operator (!hold ?g) ((open ?g)) () ((:protection (open ?g))))
  (:operator (!release ?g) () ((:protection (open ?g))) ())
  (:operator (!pass ?g ?u) ((open ?g) (fit ?u)) () ((through ?u)))
  (:operator (!shut ?g) ((open ?g)) ((open ?g)) ((shut ?g)))
  (:operator (!heal ?u) () () ((fit ?u)) 3)
  (:operator (!heal-behind-gate ?u ?g) ((shut ?g)) () ((fit ?u)))
  (:method (convoy ?g ?u) () ((!hold ?g) (crossing ?g ?u) (!release ?g)))
  (:method (crossing ?g ?u) fit ((fit ?u)) ((!pass ?g ?u)))
  (:method (crossing ?g ?u) behind () ((!shut ?g) (!heal-behind-gate ?u ?g) (!pass ?g ?u)))
  (:method (crossing ?g ?u) heal () ((!heal ?u) (!pass ?g ?u)))))
(defproblem p d ((open north) (fit a)) ((convoy north a)))
)";

TEST(Repair, KeepsWhatExecutedStepsProtect) {
  RepairFixture fixture(kGate);
  fixture.make_plan();

  const Repair& repair = fixture.diverge(1, Strings{"-(fit a)"}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!heal a)", "(!pass north a)", "(!release north)"));
  EXPECT_THAT(fixture.redone(), ElementsAre("(crossing north a)"));
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, AProtectionThatTheWorldBrokeBindsNobody) {
  RepairFixture fixture(kGate);
  fixture.make_plan();

  const Repair& repair = fixture.diverge(2, Strings{"-(open north)", "(shut north)"}).repair(2);

  EXPECT_EQ(repair.verdict, RepairVerdict::kStands);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!release north)"));
}

// What the old plan bound in a task of the problem is open again when that task has not begun.
TEST(Repair, VariablesOfTheProblemAreBoundAnew) {
  RepairFixture fixture(R"((defdomain d (
    (:operator (!choose ?x) ((free ?x)) ((free ?x)) ((mine ?x)))
    (:operator (!use ?x) ((mine ?x)) () ())
    (:method (pick ?x) ((free ?x)) ((!choose ?x)))))
    (defproblem p d ((free a) (free b)) ((pick ?x) (!use ?x))))");
  fixture.make_plan();
  ASSERT_THAT(fixture.actions(fixture.plan()), ElementsAre("(!choose a)", "(!use a)"));

  const Repair& repair = fixture.diverge(0, Strings{"-(free a)"}).repair(0);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!choose b)", "(!use b)"));
  EXPECT_EQ(fixture.fault(), "");
}

// A preference is used up, so a task that calls itself ends where the world says so.
TEST(Repair, ATaskThatCallsItselfEndsEarlierIfTheWorldHelped) {
  RepairFixture fixture(R"((defdomain d (
    (:operator (!step ?n ?m) ((level ?n)) ((level ?n)) ((level ?m)))
    (:method (climb) ((level 5)) ())
    (:method (climb) ((level ?n) (assign ?m (+ ?n 1))) ((!step ?n ?m) (climb)))))
    (defproblem p d ((level 0)) ((climb))))");
  fixture.make_plan();
  ASSERT_EQ(fixture.plan().steps.size(), 5U);

  const Repair& repair = fixture.diverge(1, Strings{"-(level 1)", "(level 4)"}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!step 4 5)"));
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, ASmallRepairThatNeverEndsDoesNotHideALargerOne) {
  RepairFixture fixture(R"((defdomain d (
    (:operator (!a) ((q)) () ((p)))
    (:operator (!b) ((p)) () ())
    (:operator (!c) () () ())
    (:method (t) first ((q)) ((!a) (u)))
    (:method (t) other () ((!c)))
    (:method (u) good ((p)) ((!b)))
    (:method (u) loop () ((u)))))
    (defproblem x d ((q)) ((t))))");
  fixture.make_plan();

  const Repair& repair = fixture.diverge(1, Strings{"-(p)", "-(q)"}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kRepaired);
  EXPECT_THAT(fixture.rest(), ElementsAre("(!c)"));
  EXPECT_EQ(fixture.fault(), "");
}

TEST(Repair, LinksOfNewStepsNameExecutedStepsAndTheOutside) {
  Uav fixture;

  const Repair& repair =
      fixture.diverge(2, Strings{"-(at karma p1)", "(at karma ridge)"}).repair(2);

  std::vector<StepIndex> sources;
  for (const TreeNode& node : repair.plan.tree) {
    if (node.step != 2) continue;
    for (const CausalLink& link : node.support) sources.push_back(link.step);
  }
  EXPECT_THAT(sources, ElementsAre(0U, kOutside));
}

TEST(Repair, HoldsItsLimit) {
  Uav fixture;
  RepairOptions options;
  options.limits.expansions = 2;

  const Repair& repair = fixture.diverge(1, Strings{"(closed p1 p2)"}).repair(1, options);

  EXPECT_EQ(repair.verdict, RepairVerdict::kLimit);
  EXPECT_EQ(repair.why, "expansions");
}

TEST(Repair, RefusesMoreExecutedStepsThanThereAre) {
  Uav fixture;

  const Repair& repair = fixture.repair(8);

  EXPECT_EQ(repair.verdict, RepairVerdict::kError);
  EXPECT_THAT(repair.why, HasSubstr("8 of 7"));
}

TEST(Repair, RefusesExecutedStepsThatTheDivergencesMakeImpossible) {
  Uav fixture;

  const Repair& repair = fixture.diverge(0, Strings{"-(ground karma)"}).repair(2);

  EXPECT_EQ(repair.verdict, RepairVerdict::kError);
  EXPECT_THAT(repair.why, HasSubstr("(!takeoff karma)"));
}

TEST(Repair, RefusesAPlanWithoutTree) {
  Uav fixture;
  fixture.forget_tree();

  const Repair& repair = fixture.repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kError);
  EXPECT_THAT(repair.why, HasSubstr("no decomposition tree"));
}

TEST(Repair, RefusesChangesThatAreNoFacts) {
  Uav fixture;

  const Repair& repair = fixture.diverge(0, std::vector<Change>{{true, kTrue}}).repair(1);

  EXPECT_EQ(repair.verdict, RepairVerdict::kError);
  EXPECT_THAT(repair.why, HasSubstr("no ground fact"));
}

}  // namespace
}  // namespace skein::htn
