// SPDX-License-Identifier: Apache-2.0
// The state after what a problem says has happened.
#include "skein/htn/aftermath.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::Case;
using ::testing::HasSubstr;

constexpr const char* kTravel =
    "(:operator (!go ?a ?b) ((at ?a) (road ?a ?b)) ((at ?a)) ((at ?b)))"
    "(:operator (!wait ?n) ((call >= ?n 0)) () ((waited ?n)))"
    "(:- (road ?a ?b) ((way ?b ?a)))";
constexpr const char* kIsland = "(at x) (road x y) (way z y)";

/// A travel over the island of which `past` has happened.
class AftermathOfATravel : public ::testing::Test {
 public:
  Case made{kTravel, kIsland};
  Problem problem = made.problem();
  Limits limits;

  AftermathOfATravel& stepped(const std::string& action) {
    return happened(Event::Kind::kStep, action);
  }
  AftermathOfATravel& gained(const std::string& fact) {
    return happened(Event::Kind::kAdded, fact);
  }
  AftermathOfATravel& lost(const std::string& fact) {
    return happened(Event::Kind::kDeleted, fact);
  }
  AftermathOfATravel& happened(Event::Kind kind, const std::string& term) {
    problem.past.push_back({kind, made.term(term)});
    return *this;
  }
  Aftermath after() { return Aftermath(made.domain(), problem, limits); }
  bool holds(const Aftermath& state, const std::string& fact) {
    return state.holds(made.term(fact));
  }
};

TEST_F(AftermathOfATravel, WithoutAPastTheFactsAreThoseOfTheProblem) {
  const Aftermath state = after();

  EXPECT_EQ(state.events(), 0U);
  EXPECT_FALSE(state.cut());
  EXPECT_FALSE(state.failed());
  EXPECT_THAT(state.facts(), ::testing::UnorderedElementsAreArray(problem.facts));
}

TEST_F(AftermathOfATravel, StepsAreAppliedAndChangesMadeInTheirOrder) {
  stepped("(!go x y)").lost("(at y)").gained("(at z)").gained("(rain)");

  const Aftermath state = after();

  EXPECT_EQ(state.events(), 4U);
  EXPECT_FALSE(holds(state, "(at x)"));
  EXPECT_FALSE(holds(state, "(at y)"));
  EXPECT_TRUE(holds(state, "(at z)"));
  EXPECT_TRUE(holds(state, "(rain)"));
}

TEST_F(AftermathOfATravel, StepsMayNeedWhatFollowsByAxioms) {
  stepped("(!go x y)").stepped("(!go y z)");

  const Aftermath state = after();

  EXPECT_EQ(state.events(), 2U);
  EXPECT_TRUE(holds(state, "(at z)"));
  EXPECT_FALSE(holds(state, "(road y z)")) << "only facts are asked for";
}

TEST_F(AftermathOfATravel, ItEndsBeforeTheFirstStepThatDoesNotApply) {
  stepped("(!go x y)").stepped("(!go x z)").gained("(rain)");

  const Aftermath state = after();

  EXPECT_EQ(state.events(), 1U);
  EXPECT_FALSE(state.failed());
  EXPECT_TRUE(holds(state, "(at y)"));
  EXPECT_FALSE(holds(state, "(rain)"));
}

TEST_F(AftermathOfATravel, WhatCannotBeEvaluatedIsSaidWithItsPlace) {
  stepped("(!wait word)");

  const Aftermath state = after();

  EXPECT_EQ(state.events(), 0U);
  EXPECT_TRUE(state.failed());
  EXPECT_FALSE(state.cut());
  EXPECT_THAT(state.why(), HasSubstr("word"));
}

TEST_F(AftermathOfATravel, LimitsHoldHereToo) {
  limits.inferences = 1;
  stepped("(!go x y)").stepped("(!go y z)");

  const Aftermath state = after();

  EXPECT_TRUE(state.cut());
  EXPECT_EQ(state.why(), "inferences");
}

TEST_F(AftermathOfATravel, TheProblemMayBeGoneBeforeIt) {
  auto gone = std::make_unique<Problem>(problem);
  gone->past.push_back({Event::Kind::kAdded, made.term("(rain)")});
  const Aftermath state(made.domain(), *gone, limits);

  gone.reset();

  EXPECT_TRUE(holds(state, "(rain)"));
}

}  // namespace
}  // namespace skein::htn
