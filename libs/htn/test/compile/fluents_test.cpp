// SPDX-License-Identifier: Apache-2.0
// PDDL's numbers: functions in conditions and effects; and derived predicates with types.
#include <gtest/gtest.h>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::Case;

const char* const kRover =
    "(:functions (energy ?r) (recharges))"
    "(:action drive :parameters (?r ?a ?b)"
    " :precondition (and (in ?r ?a) (road ?a ?b) (>= (energy ?r) 8))"
    " :effect (and (decrease (energy ?r) 8) (not (in ?r ?a)) (in ?r ?b)))"
    "(:action charge :parameters (?r) :precondition (< (energy ?r) 80)"
    " :effect (and (increase (energy ?r) (+ 20 (recharges))) (increase (recharges) 1)"
    "              (increase (total-cost) 1)))"
    "(:action reset :parameters (?r) :effect (assign (energy ?r) (* 2 (recharges))))"
    "(:action show :parameters (?r ?e) :precondition (= (energy ?r) ?e))";

const char* const kStart = "(in r a) (road a b) (road b c) (= (energy r) 10) (= (recharges) 3)";

TEST(Fluents, AreComparedInPreconditions) {
  Case once(kRover, kStart, "((!drive r a b))");
  Case twice(kRover, kStart, "((!drive r a b) (!drive r b c))");

  EXPECT_EQ(once.first(), "(!drive r a b)");
  EXPECT_EQ(twice.first(), "no plan");
}

TEST(Fluents, ChangeByTheValuesThatHeldBefore) {
  Case charged(kRover, kStart, "((!charge r) (!show r 33))");
  Case again(kRover, kStart, "((!charge r) (!charge r) (!show r 57))");
  Case set(kRover, kStart, "((!charge r) (!reset r) (!show r 8))");

  EXPECT_EQ(charged.first(), "(!charge r) (!show r 33)");
  EXPECT_EQ(again.first(), "(!charge r) (!charge r) (!show r 57)");
  EXPECT_EQ(set.first(), "(!charge r) (!reset r) (!show r 8)");
}

TEST(Fluents, WithoutAValueSatisfyNothingAndStayWithoutOne) {
  Case unknown(kRover, "(in r a) (road a b) (= (recharges) 0)", "((!drive r a b))");
  Case cost(kRover, kStart, "((!charge r) (!charge r))");

  EXPECT_EQ(unknown.first(), "no plan");
  EXPECT_EQ(cost.first(), "(!charge r) (!charge r)");
}

TEST(DerivedPredicates, HoldForArgumentsOfTheirTypes) {
  const char* const items =
      "(:types box) (:derived (empty ?b - box) (light ?b))"
      "(:action go :parameters (?b - box) :precondition (empty ?b) :effect (done ?b))";
  Case box(items, "(box r) (light r)", "((!go r))");
  Case no_box(items, "(light r)", "((!go r))");

  EXPECT_EQ(box.first(), "(!go r)");
  EXPECT_EQ(no_box.first(), "no plan");
}

}  // namespace
}  // namespace skein::htn
