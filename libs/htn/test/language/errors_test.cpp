// SPDX-License-Identifier: Apache-2.0
// Each error and warning of the reader says where, what and what was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ReaderFixture;

using Cases = std::vector<std::pair<std::string, std::string>>;

// The items of a domain begin in column 1 of line 2.
std::string errors_of(const std::string& items) {
  ReaderFixture reader;
  reader.read("(defdomain d (\n" + items + "))");
  return reader.error_text();
}

std::string warnings_of(const std::string& items, const std::string& problem = "") {
  ReaderFixture reader;
  reader.read("(defdomain d (\n" + items + "))" + problem);
  EXPECT_EQ(reader.error_text(), "") << items;
  return reader.warning_text();
}

void expect_errors(const Cases& cases) {
  for (const auto& [items, error] : cases) {
    EXPECT_EQ(errors_of(items), "test.lisp:" + error + "\n") << items;
  }
}

// Operators

TEST(ReaderErrors, OfOperatorsNameThePart) {
  const std::string shape =
      "; expected (:operator (!name arguments…) precondition delete add [cost])";

  expect_errors({
      {"(:operator)", "2:1: an operator of 0 parts" + shape},
      {"(:operator (!a) () ())"
       "\n(:operator (!b) () () () 1 2)",
       "3:1: an operator of 6 parts" + shape},
      {"(:operator (!a) () () . 3)", "2:1: an operator of 4 parts" + shape},
      {"(:operator () () ())", "2:12: () is no head of an operator; expected (name arguments…)"},
      {"(:operator (5 ?x) () ((a ?x)))",
       "2:12: (5 ?x) is no head of an operator; expected (name arguments…)"},
      {"(:operator (!a)\n \"x\" ())",
       "3:2: \"x\" is no list of atoms; expected ((predicate arguments…) …)"},
      {"(:operator (!a) () ()\n ((ok) 7))", "3:8: 7 is no atom; expected (predicate arguments…)"},
      {"(:operator (!a) () ((nil x)))",
       "2:21: (nil x) is no atom; expected (predicate arguments…)"},
  });
}

TEST(ReaderErrors, OfShortOperatorsNameTheKeyword) {
  expect_errors({
      {"(:op)",
       "2:1: an operator without a head; expected (:op (!name arguments…) :precond … "
       ":delete … :add … :cost …)"},
      {"(:op (!a) :add () :add ())", "2:19: :add is given twice"},
      {"(:op (!a) :cost)", "2:11: nothing behind :cost; expected its value"},
      {"(:op (!a) 5 ())", "2:11: 5 where a keyword goes; expected :precond or another"},
      {"(:op (!a) :prcond ())",
       "2:11: :prcond where a keyword goes; expected :precond or another; did you mean "
       "':precond'?"},
      {"(:op (a))", "2:7: operator 'a'; expected a name that begins with '!'; did you mean '!a'?"},
      {"(:op (!a)) (:operator (!a) () ())",
       "2:24: a second operator '!a'; expected one operator of a name"},
  });
}

TEST(ReaderErrors, OfEffectsNameTheAtom) {
  expect_errors({
      {"(:operator (!a) () ((forall (?x) (p ?x))))",
       "2:21: a forall of 2 parts; expected (forall (variables…) condition (atoms…))"},
      {"(:operator (!a) () ((forall 5 (p ?x) ((q ?x)))))",
       "2:29: 5 is no list; expected a list of variables"},
      {"(:operator (!a) () ((forall (?x) (p ?x) ((q ?x) 5))))",
       "2:49: 5 is no atom; expected (predicate arguments…)"},
      {"(:operator (!a) () ((forall (?x) (not) ((q ?x)))))",
       "2:34: not with 0 arguments; expected (not condition)"},
      {"(:operator (!a) () ((:protection)))",
       "2:21: a protection of no atom; expected (:protection (predicate arguments…))"},
      {"(:operator (!a) () ((:protection p)))",
       "2:21: a protection of no atom; expected (:protection (predicate arguments…))"},
      {"(:operator (!a) () ((:protection (p) (q))))",
       "2:21: a protection of no atom; expected (:protection (predicate arguments…))"},
  });
}

// Methods and axioms

TEST(ReaderErrors, OfMethodsNameThePart) {
  const std::string shape = "; expected (:method (name arguments…) [label] precondition tasks …)";

  expect_errors({
      {"(:method)", "2:1: a method without a head" + shape},
      {"(:method label)", "2:1: a method without a head" + shape},
      {"(:method (m) () () . x)", "2:1: a method without a head" + shape},
      {"(:method (?m) () ())",
       "2:11: a variable for the name of a method; expected (name arguments…)"},
      {"(:method label (m))", "2:1: a method without a branch; expected precondition and tasks"},
      {"(:method (m) one () () two)",
       "2:24: nothing behind the label two; expected precondition and tasks"},
      {"(:method (m) ()\n (go . 5) late)",
       "3:11: nothing behind the label late; expected precondition and tasks"},
      {"(:method (m) \"x\" ())",
       "2:14: \"x\" is no condition; expected (predicate arguments…) or a list of conditions"},
      {"(:method (m) () 5)", "2:17: 5 is no task; expected (name arguments…) or a list of tasks"},
      {"(:method (m) ()\n (:ordered (a)\n  (:unordered \"b\")))",
       "4:15: \"b\" is no task; expected (name arguments…) or a list of tasks"},
  });
}

TEST(ReaderErrors, OfAxiomsNameThePart) {
  expect_errors({
      {"(:-)",
       "2:1: an axiom without a head; expected (:- (predicate arguments…) [label] "
       "condition …)"},
      {"(:- (p) . q)",
       "2:1: an axiom without a head; expected (:- (predicate arguments…) [label] "
       "condition …)"},
      {"(:- (?p) ((a)))", "2:6: a variable for the name of an axiom; expected (name arguments…)"},
      {"(:- 7)", "2:5: 7 is no head of an axiom; expected (name arguments…)"},
      {"(:- (p) one ((a)) two)", "2:19: nothing behind the label two; expected a condition"},
  });
}

// Conditions

TEST(ReaderErrors, OfConditionsNameTheWord) {
  const auto condition = [](const std::string& text) { return "(:- (p)\n " + text + ")"; };

  expect_errors({
      {condition("(imply (a) (b) (c))"),
       "3:2: imply with 3 arguments; expected (imply condition condition)"},
      {condition("(not)"), "3:2: not with 0 arguments; expected (not condition)"},
      {condition("(or (a) . ?x)"), "3:2: or with a dot; expected (and condition…)"},
      {condition("(exists (?x - ) (a ?x))"),
       "3:14: no type behind '-'; expected a type or (either type…)"},
      {condition("(forall (- t) (a) (b))"), "3:11: nothing before '-' to have a type"},
      {condition("(forall (?x - 5) (a ?x) (b))"),
       "3:16: 5 is no type; expected a type or (either type…)"},
      {condition("(forall (?x - (either)) (a ?x) (b))"),
       "3:16: (either) is no type; expected a type or (either type…)"},
      {condition("(forall (?x - (either t 7)) (a ?x) (b))"),
       "3:26: 7 is no type; expected the name of a type"},
      {condition("(assign ?x)"),
       "3:2: assign with 1 argument; expected (assign ?variable "
       "expression)"},
      {condition("(setof ?x (a ?x) (s))"),
       "3:19: (s) where the collected list goes; expected a variable"},
      {condition("(nil a)"), "3:3: a condition that begins with nil; expected a predicate"},
      {condition("`(a)"), "3:2: a quoted condition; expected the condition itself"},
      {condition("((a) (:first (b)))"),
       "3:7: :first inside a condition; expected it at the head of a precondition only"},
  });
}

// Items, domains and problems

TEST(ReaderErrors, OfItemsNameTheNearestItem) {
  const std::string expected = "; expected :operator, :method, :- or another item";

  expect_errors({
      {"(:operatr (!a) () ())",
       "2:1: unknown item :operatr" + expected + "; did you mean ':operator'?"},
      {"(:xyzzy)", "2:1: unknown item :xyzzy" + expected},
      {"(method (m) () ())", "2:1: unknown item method" + expected + "; did you mean ':method'?"},
      {"7", "2:1: 7 is no item of a domain; expected (:operator …), (:method …) …"},
      {"()", "2:1: () is no item of a domain; expected (:operator …), (:method …) …"},
      {"((:method (m) () ()))",
       "2:1: ((:method (m) () ())) is no item of a domain; expected (:operator …), (:method …) …"},
  });
}

TEST(ReaderErrors, OfPddlItemsNameThePart) {
  const std::string types = "(:types room)\n";

  expect_errors({
      {"(:action)",
       "2:1: an action without a name; expected (:action name :parameters (…) "
       ":precondition … :effect …)"},
      {"(:action (a))",
       "2:1: an action without a name; expected (:action name :parameters (…) "
       ":precondition … :effect …)"},
      {"(:action a :parameters (x))", "2:25: x in a list of variables; expected a variable"},
      {"(:action a :parameters 5)", "2:24: 5 is no list; expected a list of variables"},
      {"(:action a :effect (when (p)))",
       "2:20: (when (p)) has not two parts; expected (when condition effect)"},
      {"(:action a :effect (forall (?x)))",
       "2:20: (forall (?x)) has not two parts; expected (forall (variables…) effect)"},
      {"(:action a :effect (and (p)\n (not p)))",
       "3:2: (not p) is no effect; expected (not (predicate arguments…))"},
      {"(:action a :effect (decrease (f)))",
       "2:20: decrease with 1 argument; expected (decrease fluent amount)"},
      {"(:action a :effect 5)", "2:20: 5 is no atom; expected (predicate arguments…)"},
      {"(:action a :effect (p) :effect (q))", "2:24: :effect is given twice"},
      {"(:action a) (:action !a)",
       "2:22: a second operator '!a'; expected one operator or action of a name"},
      {types + "(:action a :parameters (?x - rooom))",
       "3:30: unknown type 'rooom'; expected a type of :types; did you mean 'room'?"},
      {types + "(:constants hall - rom)",
       "3:20: unknown type 'rom'; expected a type of :types; did you mean 'room'?"},
      {"(:predicates p)", "2:14: p is no declaration; expected (name ?variable - type …)"},
      {"(:derived (p))",
       "2:1: a derived predicate of 1 part; expected (:derived (predicate "
       "?variable - type …) condition)"},
      {"(:derived (?p) (q))",
       "2:12: a variable for the name of a derived predicate; expected (name arguments…)"},
  });
}

TEST(ReaderErrors, KnowTheTypesThatNeedNoDeclaration) {
  EXPECT_EQ(errors_of("(:types room) (:action a :parameters (?x - object ?n - number ?r - room))"),
            "");
  EXPECT_EQ(errors_of("(:types room - place) (:action a :parameters (?x - place))"), "");
  EXPECT_EQ(errors_of("(:action a :parameters (?x - anything))"), "");
}

TEST(ReaderErrors, OfProblemsNameThePart) {
  const auto error_of = [](const std::string& problem) {
    ReaderFixture reader;
    reader.read(problem);
    return reader.error_text();
  };

  EXPECT_EQ(error_of("(defproblem p d\n ((a) (b ?x)) ())"),
            "test.lisp:2:10: variable ?x in a fact; expected a constant\n");
  EXPECT_EQ(error_of("(defproblem p d\n ((a (b (c . ?x)))) ())"),
            "test.lisp:2:14: variable ?x in a fact; expected a constant\n");
  EXPECT_EQ(error_of("(defproblem p ?d () ())"),
            "test.lisp:1:15: ?d where the name of the domain goes; expected (defproblem name "
            "[domain] (facts…) (tasks…))\n");
  EXPECT_EQ(error_of("(defproblem (5) d () ())"),
            "test.lisp:1:13: (5) is no name for a problem; expected a name or (name options…)\n");
  EXPECT_EQ(error_of("(defproblem p d () (a\n . b) ) (defproblem)"),
            "test.lisp:2:9: a problem of 0 parts; expected (defproblem name [domain] (facts…) "
            "(tasks…))\n");
}

TEST(ReaderErrors, CountColumnsInCharactersAndLinesAsEditorsDo) {
  EXPECT_EQ(errors_of("; é è\r\n(:method (m) () é)"),
            "test.lisp:3:17: é is no task; expected (name arguments…) or a list of tasks\n");
  EXPECT_EQ(errors_of("(:method (é) () 5)"),
            "test.lisp:2:17: 5 is no task; expected (name arguments…) or a list of tasks\n");
}

// Inclusion

TEST(ReaderIncludes, ReportErrorsWithThePlaceInTheIncludedFile) {
  ReaderFixture reader;
  reader.with_file("lib.lisp", "\n(defdomain lib (\n  (:operator (a) () ())))");

  reader.read_items("(:include lib)");

  EXPECT_EQ(reader.error_text(),
            "lib.lisp:3:15: operator 'a'; expected a name that begins with '!'; did you mean "
            "'!a'?\n");
}

TEST(ReaderIncludes, OfOneselfDirectlyOrRoundACornerEnd) {
  ReaderFixture direct;
  ReaderFixture round;
  round.with_file("a.lisp", "(defdomain a ((:include b)))")
      .with_file("b.lisp", "(defdomain b ((:include c)))")
      .with_file("c.lisp", "(defdomain c ((:include a)))");

  direct.with_file("test.lisp", "(defdomain d ())").read_items("(:include d \"test.lisp\")");
  round.read_items("(:include a)");

  EXPECT_EQ(direct.error_text(), "test.lisp:1:15: 'test.lisp' includes itself\n");
  EXPECT_EQ(round.error_text(), "c.lisp:1:15: 'a.lisp' includes itself\n");
}

TEST(ReaderIncludes, OfOneFileFromTwoPlacesAreNoCycle) {
  ReaderFixture reader;
  reader.with_file("a.lisp", "(defdomain a ((:include base)))")
      .with_file("b.lisp", "(defdomain b ((:include base)))")
      .with_file("base.lisp", "(defdomain base ((:- (p))))");

  reader.read_items("(:include a) (:include b)");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.domain().axioms.size(), 2U);
}

TEST(ReaderIncludes, OfTheSameOperatorTwiceAreAnError) {
  ReaderFixture reader;
  reader.with_file("a.lisp", "(defdomain a ((:operator (!x) () ())))");

  reader.read_items("(:operator (!x) () ()) (:include a)");

  EXPECT_EQ(reader.error_text(),
            "a.lisp:1:27: a second operator '!x'; expected one operator of a name\n");
}

TEST(ReaderIncludes, AreLookedForBesideTheFileThatNamesThem) {
  ReaderFixture reader;
  reader.with_file("lib/a.lisp", "(defdomain a ((:include b)))")
      .with_file("b.lisp", "(defdomain b ((:- (p))))");

  reader.read_items("(:include a \"lib/a.lisp\")");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.definitions.documents.back()->file, "lib/b.lisp");
}

// Warnings

TEST(ReaderWarnings, OfSingleUsesNameTheirClause) {
  const std::string once = "; expected a second use, or a name that begins with ?_\n";

  EXPECT_EQ(warnings_of("(:operator (!a ?x ?y) ((p ?x)) () ())"),
            "test.lisp:2:19: variable ?y used only once in operator '!a'" + once);
  EXPECT_EQ(warnings_of("(:operator (!a ?x ?y) () ())"),
            "test.lisp:2:16: variables ?x, ?y used only once in operator '!a'" + once);
  EXPECT_EQ(warnings_of("(:method (m) ((p ?x)) ())"),
            "test.lisp:2:18: variable ?x used only once in method 'm'" + once);
  EXPECT_EQ(warnings_of("(:method (m) ((p ?x)) () ((p ?_y)) ())"),
            "test.lisp:2:18: variable ?x used only once in branch 1 of method 'm'" + once);
  EXPECT_EQ(warnings_of("(:- (p ?x) ((q)) ((r ?y)))"),
            "test.lisp:2:8: variable ?x used only once in axiom 'p'" + once +
                "test.lisp:2:22: variable ?y used only once in tail 2 of axiom 'p'" + once);
}

TEST(ReaderWarnings, OfListsAndBranchesNameWhatIsTaken) {
  EXPECT_EQ(warnings_of("(:operator (!a) (p) ())"),
            "test.lisp:2:17: one atom where a list of atoms belongs; expected ((atom) …)\n");
  EXPECT_EQ(warnings_of("(:method (m) ((p)))"),
            "test.lisp:2:14: a branch without tasks; it is taken as nothing to do; expected tasks "
            "behind the precondition\n");
  EXPECT_EQ(warnings_of("(:method (!m) () ())"),
            "test.lisp:2:11: a method for '!m' is never used; expected a name without '!'\n");
  EXPECT_EQ(warnings_of("(:- (p) (eval 1 2))"),
            "test.lisp:2:17: eval takes one expression; the rest is ignored\n");
}

TEST(ReaderWarnings, OfTasksNameWhatWouldMatch) {
  EXPECT_EQ(warnings_of("(:method (m) () ((n 1) (n 1 2) (n 3)))(:method (n ?_a ?_b) () ())"
                        "(:method (n) () ())"),
            "test.lisp:2:18: task 'n' with 1 argument matches no head; expected 0 or 2\n");
  EXPECT_EQ(warnings_of("(:method (visit) () ((vist)))"),
            "test.lisp:2:22: task 'vist' has neither method nor operator; expected a task of "
            "domain 'd'; did you mean 'visit'?\n");
  EXPECT_EQ(warnings_of("(:method (m) () ((!!inop) (?_any)))"), "");
}

TEST(ReaderWarnings, OfActionsCountTheirParametersWithoutTypes) {
  const std::string action = "(:action go :parameters (?a ?b - place))";

  EXPECT_EQ(warnings_of(action + "(:method (m) () ((!go x y)))"), "");
  EXPECT_THAT(warnings_of(action + "(:method (m) () ((!go x y z)))"),
              HasSubstr("task '!go' with 3 arguments matches no head; expected 2"));
}

TEST(ReaderWarnings, OfStaticPredicatesNameTheChange) {
  const std::string no_change = "; expected no change of a predicate of :static\n";

  EXPECT_EQ(warnings_of("(:static road) (:operator (!dig ?a) () ((road ?a)))"),
            "test.lisp:2:41: an operator changes 'road'" + no_change);
  EXPECT_EQ(warnings_of("(:static road) (:action dig :parameters (?a) :effect (not (road ?a)))"
                        "(:operator (!x) () ())"),
            "");
  EXPECT_EQ(warnings_of("(:static road) (:action dig :parameters (?a) :effect (road ?a))"),
            "test.lisp:2:54: an operator changes 'road'" + no_change);
}

TEST(ReaderWarnings, OfPredicatesThatNothingProvidesNeedAProblem) {
  const std::string items = "(:method (m) ((ready)) ())";

  EXPECT_EQ(warnings_of(items), "");
  EXPECT_EQ(warnings_of(items, "(defproblem p d ((redy)) (m))"),
            "test.lisp:2:15: nothing provides (ready …); expected a fact, an axiom or an operator "
            "that adds it; did you mean 'redy'?\n");
  EXPECT_EQ(warnings_of(items, "(defproblem p d ((ready)) (m))"), "");
  EXPECT_EQ(warnings_of(items + "(:- (ready))", "(defproblem p d () (m))"), "");
  EXPECT_EQ(warnings_of(items + "(:operator (!a) () ((ready)))", "(defproblem p d () (m))"), "");
}

TEST(ReaderWarnings, OfProblemsNameTheNearestDomain) {
  EXPECT_EQ(warnings_of("", "\n(defproblem p dd () ())"),
            "test.lisp:3:18: problem 'p' of unknown domain 'dd'; expected a domain that is read "
            "with it; did you mean 'd'?\n");
}

TEST(ReaderWarnings, OfTheWholeWaitUntilThereAreNoErrors) {
  ReaderFixture reader;

  reader.read_items("(:method (m) () ((nowhere))) (:operator (a) () ())");

  EXPECT_EQ(reader.errors.size(), 1U);
  EXPECT_THAT(reader.warning_text(), Not(HasSubstr("nowhere")));
}

}  // namespace
}  // namespace skein::htn
