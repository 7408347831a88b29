// SPDX-License-Identifier: Apache-2.0
// `skein plan --repair`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using testing::HasSubstr;
using testing_command::Done;
using testing_command::File;
using testing_command::plan;

// A drone carries a crate over roads, or waits for a road to open.
const std::string kDomain = R"((defdomain d (
  (:operator (!go ?from ?to) ((at ?from) (road ?from ?to)) ((at ?from)) ((at ?to)) 1.5)
  (:operator (!drop ?x) ((at ?x)) () ((dropped ?x)))
  (:method (bring ?x) ((at ?y)) ((go ?y ?x) (!drop ?x)))
  (:method (go ?y ?x) straight ((road ?y ?x)) ((!go ?y ?x)))
  (:method (go ?y ?x) over ((road ?y ?z) (road ?z ?x)) ((!go ?y ?z) (!go ?z ?x)))))
(defproblem p d ((at a) (road a b) (road b c) (road b e) (road e c)) ((bring b) (bring c))))";
// 0 go a b, 1 drop b, 2 go b c, 3 drop c

class RepairCommand : public testing::Test {
 protected:
  RepairCommand() {
    options_.files = {domain_.path()};
    options_.json = true;
    options_.tree = true;
    plans_ = plan(options_).out;
    options_.json = false;
    options_.tree = false;
  }

  Done repair(const std::string& plans, htn::StepIndex executed,
              const std::vector<std::string>& diverge) {
    const File file("plans", plans);
    options_.repair = file.path();
    options_.executed = executed;
    options_.diverge = diverge;
    return plan(options_);
  }

  File domain_{"domain", kDomain};
  PlanOptions options_;
  std::string plans_;
};

TEST_F(RepairCommand, SaysThatThePlanStands) {
  const Done done = repair(plans_, 1, {"(:add (road a e))"});

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("p: the plan stands"));
  EXPECT_THAT(done.out, HasSubstr("·   1 (!go a b)"));
}

TEST_F(RepairCommand, ShowsWhatIsKeptDroppedAndNew) {
  const Done done = repair(plans_, 1, {"(:delete (road b c))"});

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("repaired: 2 steps kept, 1 dropped, 2 new, cost "));
  EXPECT_THAT(done.out, HasSubstr("lost: (road b c), needed by (go b c)"));
  EXPECT_THAT(done.out, HasSubstr("done otherwise: (go b c)"));
  EXPECT_THAT(done.out, HasSubstr("+   3 (!go b e)"));
  EXPECT_THAT(done.out, HasSubstr("-     (!go b c)"));
}

TEST_F(RepairCommand, WhatItWritesAsJsonCanBeRepairedAgain) {
  options_.json = true;
  const std::string once = repair(plans_, 1, {"(:delete (road b c))"}).out;

  const Done done =
      repair(once, 3,
             {"(:after 1 (:delete (road b c)))", "(:delete (road e c)) (:add (road b c))",
              "(:delete (at e)) (:add (at b))"});

  EXPECT_EQ(done.code, 0) << done.out << done.err;
  const auto json = nlohmann::json::parse(done.out);
  EXPECT_EQ(json["result"], "repaired");
  const auto& steps = json["plans"][0]["steps"];
  EXPECT_EQ(steps[3], nlohmann::json({"!go", "b", "c"}));
  EXPECT_EQ(json["kept"], nlohmann::json({4}));
}

TEST_F(RepairCommand, WithoutAPlanTheCodeIsOne) {
  const Done done = repair(plans_, 1, {"(:delete (road b c) (road b e))"});

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("there is no plan from here"));
}

TEST_F(RepairCommand, ALimitIsCodeFour) {
  options_.search.limits.expansions = 1;

  const Done done = repair(plans_, 1, {"(:delete (road b c))"});

  EXPECT_EQ(done.code, 4);
  EXPECT_THAT(done.out, HasSubstr("cut: expansions"));
}

TEST_F(RepairCommand, RefusesWhatIsNoDivergence) {
  const Done done = repair(plans_, 1, {"(:forget (road b c))"});

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err,
              HasSubstr("--diverge:1:1: error: this is no divergence; expected (:add fact…)"));
}

TEST_F(RepairCommand, RefusesAPlanWithoutTree) {
  const Done done = repair("(!go a b) (!drop b)", 1, {"(:add (road a e))"});

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.out, HasSubstr("no decomposition tree"));
}

TEST_F(RepairCommand, RefusesFactsThatTheDomainDoesNotKnow) {
  const Done name = repair(plans_, 1, {"(:delete (raod b c))"});
  const Done arity = repair(plans_, 1, {"(:add (road b))"});

  EXPECT_EQ(name.code, 2);
  EXPECT_THAT(name.err, HasSubstr("(raod b c): the domain knows no predicate 'raod'; did you mean "
                                  "'road'?"));
  EXPECT_EQ(arity.code, 2);
  EXPECT_THAT(arity.err, HasSubstr("(road b) has 1 arguments; expected 2"));
}

TEST_F(RepairCommand, WarnsOfObjectsThatAreNamedNowhereElse) {
  const Done done = repair(plans_, 1, {"(:add (road b zz))"});

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.err, HasSubstr("warning: (road b zz): 'zz' is named nowhere else"));
}

}  // namespace
}  // namespace skein::plan_tool
