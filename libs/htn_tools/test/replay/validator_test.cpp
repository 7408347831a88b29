// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/validator.hpp"

#include <gtest/gtest.h>

namespace skein::htn {
namespace {

constexpr const char* kDomain = R"(
(defdomain trucks (
  (:operator (!drive ?t ?from ?to) ((at ?t ?from) (road ?from ?to)) ((at ?t ?from)) ((at ?t ?to)) 2)
  (:operator (!load ?p ?t) ((at ?t ?x) (at ?p ?x)) ((at ?p ?x)) ((in ?p ?t)))
  (:operator (!guard ?t ?x) ((at ?t ?x)) () ((:protection (at ?t ?x))) 0)
  (:operator (!unguard ?t ?x) () ((:protection (at ?t ?x))) () 0)
  (:operator (!!note ?what) () () ?what 0)
  (:operator (!unload-all ?t) ((at ?t ?x)) ((forall (?p) (in ?p ?t) ((in ?p ?t))))
             ((forall (?p) (in ?p ?t) ((at ?p ?x)))))
  (:operator (!paint ?t) ((colour ?c)) () ((painted ?t ?c)))
  (:operator (!check ?t ?c) ((painted ?t ?c)) () ())
  (:operator (!broken ?t) () () ((somewhere ?t ?x)))
  (:method (deliver ?p ?to)
    near ((at ?p ?to)) ()
    far ((at ?p ?x) (at ?t ?x) (truck ?t))
        ((!load ?p ?t) (!drive ?t ?x ?to) (!unload-all ?t)))
  (:- (road ?x ?y) ((way ?y ?x)))
  (:- (truck ?t) ((kind ?t truck)))))
(defproblem p trucks
  ((kind t1 truck) (at t1 a) (at p1 a) (at p2 a) (way a b) (way b a) (colour red) (colour blue))
  ((deliver p1 b)))
)";

class ValidatorOnTrucks : public ::testing::Test {
 protected:
  ValidatorOnTrucks() {
    Diagnostics errors;
    Diagnostics warnings;
    read_definitions(
        {"trucks.lisp", kDomain}, store_,
        [](const std::string&, const std::string&) { return failure("none"); }, definitions_,
        errors, warnings);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
  }
  GivenPlan plan(const std::string& text) {
    Diagnostics errors;
    auto plans = read_plans("plan", text, store_, errors);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
    EXPECT_EQ(plans.size(), 1U);
    return plans.empty() ? GivenPlan{} : plans[0];
  }
  Validation validate(const GivenPlan& given) {
    Diagnostics errors;
    const Validator validator(definitions_.domains[0], definitions_.functions, Functions{}, store_,
                              errors);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
    return validator.validate(definitions_.problems[0], given);
  }
  Validation validate(const std::string& text) { return validate(plan(text)); }
  std::string with_tree(const std::string& method, const std::string& steps) {
    return R"({"problem":"p","plans":[{"cost":4,"steps":[["!load","p1","t1"],)"
           R"(["!drive","t1","a","b"],["!unload-all","t1"]],"tree":[)"
           R"({"kind":"ordered","children":[1]},)"
           R"({"kind":"task","task":["deliver","p1","b"],"method":")" +
           method +
           R"(","children":[2]},{"kind":"ordered","children":[3,4,5]},)"
           R"({"kind":"step","task":["!load","p1","t1"],"step":0},)" +
           steps + R"(]}]})";
  }

  TermStore store_;
  Definitions definitions_;
};

TEST_F(ValidatorOnTrucks, AcceptsStepsThatApplyOneAfterAnother) {
  const Validation result = validate("(!load p1 t1) 1.0\n(!drive t1 a b) 2\n(!unload-all t1) 1\n");

  EXPECT_FALSE(result.fault.has_value()) << to_text(result);
  EXPECT_EQ(to_text(result), "valid: 3 steps, cost 4.0");
}

TEST_F(ValidatorOnTrucks, NamesTheConjunctThatIsUnmetAndItsLine) {
  const Validation result = validate("(!drive t1 a b)\n(!load p1 t1)\n");

  ASSERT_TRUE(result.fault.has_value());
  EXPECT_EQ(result.fault->kind, FaultKind::kPrecondition);
  EXPECT_EQ(to_text(result), "step 2 (line 2): precondition unmet: (at ?p ?x)");
}

TEST_F(ValidatorOnTrucks, SubstitutesWhatIsKnownInTheUnmetConjunct) {
  const Validation result = validate("(!drive t1 b a)");

  EXPECT_EQ(to_text(result), "step 1 (line 1): precondition unmet: (at t1 b)");
}

TEST_F(ValidatorOnTrucks, RefusesUnknownOperatorsAndWrongArity) {
  EXPECT_EQ(validate("(!fly t1)").fault.value().kind, FaultKind::kUnknownOperator);
  EXPECT_EQ(to_text(validate("(!drive t1 a)")), "step 1 (line 1): !drive takes 3 arguments, not 2");
}

TEST_F(ValidatorOnTrucks, RefusesAViolatedProtection) {
  const Validation result = validate("(!guard t1 a) (!drive t1 a b)");

  EXPECT_EQ(to_text(result), "step 2 (line 1): protection violated: (at t1 a)");
}

TEST_F(ValidatorOnTrucks, CountsProtections) {
  EXPECT_TRUE(
      validate("(!guard t1 a) (!guard t1 a) (!unguard t1 a) (!drive t1 a b)").fault.has_value());
  EXPECT_FALSE(
      validate("(!guard t1 a) (!guard t1 a) (!unguard t1 a) (!unguard t1 a) (!drive t1 a b)")
          .fault.has_value());
}

TEST_F(ValidatorOnTrucks, RefusesAnAdditionWithAVariable) {
  EXPECT_EQ(validate("(!broken t1)").fault.value().kind, FaultKind::kEffect);
}

TEST_F(ValidatorOnTrucks, ComparesGivenCosts) {
  EXPECT_EQ(to_text(validate("(!drive t1 a b) 3")), "step 1 (line 1): costs 2, not 3");
  EXPECT_EQ(
      validate(R"({"plans":[{"cost":7,"steps":[["!drive","t1","a","b"]]}]})").fault.value().kind,
      FaultKind::kCost);
}

TEST_F(ValidatorOnTrucks, TriesTheOtherProofsOfAnEarlierStep) {
  EXPECT_FALSE(validate("(!paint t1) (!check t1 red)").fault.has_value());
  EXPECT_FALSE(validate("(!paint t1) (!check t1 blue)").fault.has_value());
  EXPECT_TRUE(validate("(!paint t1) (!check t1 green)").fault.has_value());
}

TEST_F(ValidatorOnTrucks, TakesAListInAVariableAsAdditions) {
  const Validation result = validate("(!!note ((way c a) (way a c))) (!drive t1 a c)");

  EXPECT_FALSE(result.fault.has_value()) << to_text(result);
}

TEST_F(ValidatorOnTrucks, SaysThatInternalStepsAreMissing) {
  const Validation result =
      validate(R"({"plans":[{"internal":false,"steps":[["!drive","t1","a","b"]]}]})");

  EXPECT_EQ(result.fault.value().kind, FaultKind::kInternalLeftOut);
}

TEST_F(ValidatorOnTrucks, AcceptsADecompositionThatYieldsTheSteps) {
  const Validation result =
      validate(with_tree("far", R"({"kind":"step","task":["!drive","t1","a","b"],"step":1},)"
                                R"({"kind":"step","task":["!unload-all","t1"],"step":2})"));

  EXPECT_EQ(to_text(result), "valid: 3 steps, cost 4.0, tree checked");
}

TEST_F(ValidatorOnTrucks, RefusesATreeWithTheWrongMethodOrderOrSteps) {
  const std::string drive = R"({"kind":"step","task":["!drive","t1","a","b"],"step":1},)";
  const std::string unload = R"({"kind":"step","task":["!unload-all","t1"],"step":2})";

  EXPECT_EQ(validate(with_tree("near", drive + unload)).fault.value().kind, FaultKind::kTree);
  EXPECT_EQ(validate(with_tree("far", R"({"kind":"step","task":["!unload-all","t1"],"step":2},)"
                                      R"({"kind":"step","task":["!drive","t1","a","b"],"step":1})"))
                .fault.value()
                .kind,
            FaultKind::kTree);
  EXPECT_EQ(validate(with_tree("far", drive + R"({"kind":"step","task":["!unload-all","t1"]})"))
                .fault.value()
                .kind,
            FaultKind::kTree);
}

TEST_F(ValidatorOnTrucks, SurvivesTreesThatAreNone) {
  for (const char* tree :
       {R"([{"kind":"ordered","children":[0]}])", R"([{"kind":"ordered","children":[7]}])",
        R"([{"kind":"ordered"},{"kind":"ordered"}])"}) {
    const Validation result = validate(
        std::string(R"({"plans":[{"steps":[["!drive","t1","a","b"]],"tree":)") + tree + "}]}");

    EXPECT_EQ(result.fault.value().kind, FaultKind::kTree) << tree;
  }
}

TEST_F(ValidatorOnTrucks, ReplaysALongPlanWithoutDeepRecursion) {
  GivenPlan given;
  const GivenPlan there = plan("(!drive t1 a b)");
  const GivenPlan back = plan("(!drive t1 b a)");
  for (int at = 0; at < 20'000; ++at) {
    given.steps.push_back(there.steps[0]);
    given.steps.push_back(back.steps[0]);
  }

  EXPECT_FALSE(validate(given).fault.has_value());
}

}  // namespace
}  // namespace skein::htn
