// SPDX-License-Identifier: Apache-2.0
// Decomposition trees that yield the steps, and those that are wrong in one way each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/validator_fixture.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing_validator::ValidatorFixture;

// A plan file: steps, and nodes one after the other.
class PlanText {
 public:
  explicit PlanText(const std::string& steps) : steps_(steps) {}
  PlanText& ordered(const std::string& children) { return net("ordered", children); }
  PlanText& unordered(const std::string& children) { return net("unordered", children); }
  PlanText& task(const std::string& task, const std::string& method, const std::string& children) {
    return put(R"({"kind":"task","task":)" + task + R"(,"method":")" + method +
               R"(","children":[)" + children + "]}");
  }
  PlanText& step(const std::string& task, int step) {
    return put(R"({"kind":"step","task":)" + task + R"(,"step":)" + std::to_string(step) + "}");
  }
  PlanText& nothing() { return put(R"({"kind":"step","task":["!!inop"]})"); }
  std::string text() const {
    return R"({"plans":[{"steps":[)" + steps_ + R"(],"tree":[)" + nodes_ + "]}]}";
  }

 private:
  PlanText& net(const std::string& kind, const std::string& children) {
    return put(R"({"kind":")" + kind + R"(","children":[)" + children + "]}");
  }
  PlanText& put(const std::string& node) {
    nodes_ += (nodes_.empty() ? "" : ",") + node;
    return *this;
  }
  std::string steps_;
  std::string nodes_;
};

constexpr const char* kTravel =
    "(:operator (!walk ?a ?b) ((at ?a) (path ?a ?b)) ((at ?a)) ((at ?b)))"
    "(:operator (!rest) () () ((rested)))"
    "(:operator (!pay ?n) ((money ?m) (call >= ?m ?n)) ((money ?m)) ())"
    "(:method (go ?b)"
    "  there ((at ?b)) ()"
    "  near ((at ?a) (path ?a ?b)) ((!walk ?a ?b))"
    "  far ((at ?a) (path ?a ?c)) ((!walk ?a ?c) (go ?b)))"
    "(:method (refresh) again ((rested)) ((!rest)))"
    "(:method (buy ?n) twice () ((!pay (call + ?n ?n))))"
    "(:method (both ?x ?y) any () (:unordered (go ?x) (!rest) (:ordered (!pay ?y))))";
constexpr const char* kPlaces = "(at a) (path a b) (path b c) (money 10)";

class TreeOf : public ValidatorFixture {
 public:
  explicit TreeOf(const std::string& tasks) : ValidatorFixture(kTravel, kPlaces, tasks) {}
  std::string check(const PlanText& plan) { return text(plan.text()); }
};

const std::string kWalkAb = R"(["!walk","a","b"])";
const std::string kWalkBc = R"(["!walk","b","c"])";
const std::string kGoB = R"(["go","b"])";
const std::string kGoC = R"(["go","c"])";
const std::string kRest = R"(["!rest"])";

TEST(ValidatorTree, OfRecursiveMethodsIsAccepted) {
  TreeOf travel("((go c))");

  EXPECT_EQ(travel.check(PlanText(kWalkAb + "," + kWalkBc)
                             .ordered("1")
                             .task(kGoC, "far", "2")
                             .ordered("3,4")
                             .step(kWalkAb, 0)
                             .task(kGoC, "near", "5")
                             .ordered("6")
                             .step(kWalkBc, 1)),
            "valid: 2 steps, cost 2.0, tree checked");
}

TEST(ValidatorTree, MayLeaveOutNetworksOfOneChild) {
  TreeOf travel("((go b))");

  EXPECT_TRUE(travel.valid(PlanText(kWalkAb).task(kGoB, "near", "1").step(kWalkAb, 0).text()));
  EXPECT_TRUE(travel.valid(PlanText(kWalkAb)
                               .ordered("1")
                               .unordered("2")
                               .task(kGoB, "near", "3")
                               .ordered("4")
                               .step(kWalkAb, 0)
                               .text()));
}

TEST(ValidatorTree, OfATaskWithNothingToDoHasNothingBelow) {
  TreeOf travel("((go a))");

  EXPECT_TRUE(travel.valid(PlanText("").ordered("1").task(R"(["go","a"])", "there", "").text()));
  EXPECT_TRUE(travel.valid(
      PlanText("").ordered("1").task(R"(["go","a"])", "there", "2").ordered("3").nothing().text()));
  EXPECT_FALSE(travel.valid(
      PlanText(kRest).ordered("1").task(R"(["go","a"])", "there", "2").step(kRest, 0).text()));
}

TEST(ValidatorTree, TasksHoldTheValuesOfTheirCalls) {
  TreeOf travel("((buy 3))");
  const auto paying = [](const std::string& amount) {
    const std::string pay = R"(["!pay",)" + amount + "]";
    return PlanText(pay).ordered("1").task(R"(["buy",3])", "twice", "2").step(pay, 0);
  };

  EXPECT_EQ(travel.check(paying("6")), "valid: 1 steps, cost 1.0, tree checked");
  EXPECT_EQ(travel.check(paying("5")),
            "tree node 1: task (buy 3): method twice did not apply with these subtasks");
}

// Wrong structure

TEST(ValidatorTree, IsATreeFromItsRoot) {
  TreeOf travel("((go b))");
  const auto fault = [&](const PlanText& plan) {
    const Validation result = travel.validate(plan.text());
    EXPECT_EQ(result.fault.value().kind, FaultKind::kTree);
    return to_text(result);
  };

  EXPECT_EQ(fault(PlanText(kWalkAb).ordered("1").task(kGoB, "near", "0")),
            "tree node 1: its children are not a tree");
  EXPECT_EQ(fault(PlanText(kWalkAb).ordered("1,1").task(kGoB, "near", "")),
            "tree node 0: its children are not a tree");
  EXPECT_EQ(fault(PlanText(kWalkAb).ordered("1").task(kGoB, "near", "2")),
            "tree node 1: its children are not a tree");
  EXPECT_EQ(fault(PlanText(kWalkAb).ordered("1").task(kGoB, "near", "").step(kWalkAb, 0)),
            "tree node 0: some nodes have no parent");
  EXPECT_EQ(fault(PlanText(kWalkAb).ordered("-1")), "tree node 0: its children are not a tree");
}

TEST(ValidatorTree, HoldsEachStepOnce) {
  TreeOf travel("((go b))");

  EXPECT_EQ(
      travel.check(
          PlanText(kWalkAb + "," + kRest).ordered("1").task(kGoB, "near", "2").step(kWalkAb, 0)),
      "tree node 0: step 2 is not in the tree");
  EXPECT_EQ(travel.check(PlanText(kWalkAb).ordered("1,2").step(kWalkAb, 0).step(kWalkAb, 0)),
            "tree node 1: its step is not in the plan, or in the tree twice");
  EXPECT_EQ(travel.check(PlanText(kWalkAb).ordered("1").step(kWalkAb, 1)),
            "tree node 1: its step is not in the plan, or in the tree twice");
}

TEST(ValidatorTree, NamesTheStepsItHolds) {
  TreeOf travel("(:ordered (go b) (!rest))");

  EXPECT_EQ(travel.check(PlanText(kWalkAb + "," + kRest)
                             .ordered("1,2")
                             .task(kGoB, "near", "3")
                             .step(kRest, 1)
                             .step(R"(["!walk","a","c"])", 0)),
            "tree node 3: its task is not the step it names");
}

// Wrong root

TEST(ValidatorTree, HasTheTasksOfTheProblemAtItsRoot) {
  const std::string other = "tree node 0: the root is not the problem's task network";
  const PlanText plan = PlanText(kWalkAb + "," + kRest)
                            .ordered("1,2")
                            .task(kGoB, "near", "3")
                            .step(kRest, 1)
                            .step(kWalkAb, 0);

  EXPECT_EQ(TreeOf("((go b) (!rest))").check(plan), "valid: 2 steps, cost 2.0, tree checked");
  EXPECT_EQ(TreeOf("(:ordered (:unordered (go b)) (!rest))").check(plan),
            "valid: 2 steps, cost 2.0, tree checked");
  EXPECT_EQ(TreeOf("((go b))").check(plan), other);
  EXPECT_EQ(TreeOf("((!rest) (go b))").check(plan), other);
  EXPECT_EQ(TreeOf("((go c) (!rest))").check(plan), other);
  EXPECT_EQ(TreeOf("(:unordered (go b) (!rest))").check(plan), other);
  EXPECT_EQ(TreeOf("((go b) (!rest) (!rest))").check(plan), other);
}

TEST(ValidatorTree, OfNoTasksIsEmpty) {
  EXPECT_TRUE(TreeOf("()").valid(PlanText("").ordered("").text()));
  EXPECT_FALSE(TreeOf("()").valid(PlanText(kRest).ordered("1").step(kRest, 0).text()));
  EXPECT_FALSE(TreeOf("((!rest))").valid(PlanText("").ordered("").text()));
}

// Wrong order

TEST(ValidatorTree, KeepsTheOrderOfOrderedNetworksOnly) {
  const auto root = [](bool ordered) {
    PlanText plan(kRest + "," + kWalkAb);
    return (ordered ? plan.ordered("1,2") : plan.unordered("1,2"))
        .task(kGoB, "near", "3")
        .step(kRest, 0)
        .step(kWalkAb, 1);
  };

  EXPECT_EQ(TreeOf("(:ordered (go b) (!rest))").check(root(true)),
            "tree node 0: its steps are not in the order its network demands");
  EXPECT_EQ(TreeOf("(:unordered (go b) (!rest))").check(root(false)),
            "valid: 2 steps, cost 2.0, tree checked");
}

TEST(ValidatorTree, StepsOfOrderedTasksDoNotInterleave) {
  TreeOf travel("(:ordered (go c) (!rest))");

  EXPECT_EQ(travel.check(PlanText(kWalkAb + "," + kRest + "," + kWalkBc)
                             .ordered("1,2")
                             .task(kGoC, "far", "3")
                             .step(kRest, 1)
                             .ordered("4,5")
                             .step(kWalkAb, 0)
                             .task(kGoC, "near", "6")
                             .step(kWalkBc, 2)),
            "tree node 0: its steps are not in the order its network demands");
}

TEST(ValidatorTree, StepsOfUnorderedTasksMayInterleave) {
  TreeOf travel("(:unordered (go c) (!rest))");

  EXPECT_EQ(travel.check(PlanText(kWalkAb + "," + kRest + "," + kWalkBc)
                             .unordered("1,2")
                             .task(kGoC, "far", "3")
                             .step(kRest, 1)
                             .ordered("4,5")
                             .step(kWalkAb, 0)
                             .task(kGoC, "near", "6")
                             .step(kWalkBc, 2)),
            "valid: 3 steps, cost 3.0, tree checked");
}

// Wrong reductions

TEST(ValidatorTree, NamesABranchOfTheTask) {
  TreeOf travel("((go b))");
  const auto by = [](const std::string& method) {
    return PlanText(kWalkAb).ordered("1").task(kGoB, method, "2").step(kWalkAb, 0);
  };

  EXPECT_EQ(travel.check(by("near")), "valid: 1 steps, cost 1.0, tree checked");
  for (const char* method : {"far", "there", "by-car", ""}) {
    EXPECT_EQ(travel.check(by(method)), "tree node 1: task (go b): method " + std::string(method) +
                                            " did not apply with these subtasks");
  }
}

TEST(ValidatorTree, TakesALaterBranchOnlyWhenNoEarlierOneHolds) {
  TreeOf travel("((go b))");

  // far is possible by its own condition, but near holds as well and comes first.
  EXPECT_EQ(travel.check(PlanText(kWalkAb)
                             .ordered("1")
                             .task(kGoB, "far", "2")
                             .ordered("3,4")
                             .step(kWalkAb, 0)
                             .task(kGoB, "there", "")),
            "tree node 1: task (go b): method far did not apply with these subtasks");
}

TEST(ValidatorTree, HasAllSubtasksOfTheBranch) {
  TreeOf travel("((go c))");

  const Validation result = travel.validate(
      PlanText(kWalkAb).ordered("1").task(kGoC, "far", "2").ordered("3").step(kWalkAb, 0).text());

  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->kind, FaultKind::kTree);
  EXPECT_EQ(result.fault->step, 1U);
  EXPECT_TRUE(result.tree_checked);
}

TEST(ValidatorTree, ReducesTasksInTheStateOfTheirTime) {
  TreeOf after("(:ordered (!rest) (refresh))");
  TreeOf before("(:ordered (refresh) (!rest))");
  const std::string refresh = R"(["refresh"])";

  EXPECT_EQ(after.check(PlanText(kRest + "," + kRest)
                            .ordered("1,2")
                            .step(kRest, 0)
                            .task(refresh, "again", "3")
                            .step(kRest, 1)),
            "valid: 2 steps, cost 2.0, tree checked");
  EXPECT_EQ(before.check(PlanText(kRest + "," + kRest)
                             .ordered("1,3")
                             .task(refresh, "again", "2")
                             .step(kRest, 0)
                             .step(kRest, 1)),
            "tree node 1: task (refresh): method again did not apply with these subtasks");
}

TEST(ValidatorTree, OfAnUnorderedTaskMayBeReducedAnyTimeBeforeItsFirstStep) {
  TreeOf either("(:unordered (refresh) (!rest))");
  const std::string refresh = R"(["refresh"])";
  const auto with = [&](int of_task, int alone) {
    return PlanText(kRest + "," + kRest)
        .unordered("1,3")
        .task(refresh, "again", "2")
        .step(kRest, of_task)
        .step(kRest, alone);
  };

  EXPECT_EQ(either.check(with(1, 0)), "valid: 2 steps, cost 2.0, tree checked");
  EXPECT_EQ(either.check(with(0, 1)),
            "tree node 1: task (refresh): method again did not apply with these subtasks");
}

TEST(ValidatorTree, NestedNetworksKeepTheirKind) {
  TreeOf travel("((both b 2))");
  const auto tree = [](const std::string& kind) {
    PlanText plan(kWalkAb + "," + kRest + R"(,["!pay",2])");
    plan.ordered("1").task(R"(["both","b",2])", "any", "2");
    (kind == "unordered" ? plan.unordered("3,4,5") : plan.ordered("3,4,5"));
    return plan.task(kGoB, "near", "6").step(kRest, 1).step(R"(["!pay",2])", 2).step(kWalkAb, 0);
  };

  EXPECT_EQ(travel.check(tree("unordered")), "valid: 3 steps, cost 3.0, tree checked");
  EXPECT_EQ(travel.check(tree("ordered")),
            "tree node 1: task (both b 2): method any did not apply with these subtasks");
}

TEST(ValidatorTree, IsCheckedForEachChoiceOfTheSteps) {
  ValidatorFixture draw(
      "(:operator (!draw) ((card ?x)) ((card ?x)) ((hand ?x)))"
      "(:method (win) good ((hand ace)) ((!draw)))",
      "(card ace) (card two) (card three)", "((!draw) (win))");
  const std::string step = R"(["!draw"])";
  const PlanText plan = PlanText(step + "," + step)
                            .ordered("1,2")
                            .step(step, 0)
                            .task(R"(["win"])", "good", "3")
                            .step(step, 1);

  EXPECT_EQ(draw.text(plan.text()), "valid: 2 steps, cost 2.0, tree checked");
}

TEST(ValidatorTree, VariablesLeftUnboundAreTheSameAllOverTheTree) {
  ValidatorFixture free(
      "(:operator (!mark ?x ?y) () () ()) (:method (m ?x) one () ((!mark ?x ?any)))", "(p)",
      "((m k))");
  const auto marked = [](const std::string& y) {
    const std::string mark = R"(["!mark","k",")" + y + R"("])";
    return PlanText(mark).ordered("1").task(R"(["m","k"])", "one", "2").step(mark, 0).text();
  };

  EXPECT_EQ(free.text(marked("?any")), "valid: 1 steps, cost 1.0, tree checked");
  EXPECT_EQ(free.text(marked("k")), "valid: 1 steps, cost 1.0, tree checked");
}

}  // namespace
}  // namespace skein::htn
