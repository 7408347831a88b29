// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/htn/domain.hpp"
#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::HasSubstr;
using testing::ReaderFixture;

TEST(ReadDefinitions, FindsDomainsAndProblemsAtAnyDepth) {
  ReaderFixture reader;

  reader.read(
      "(in-package :shop-user)\n"
      "(defun make-d () (let ((*define-silently* t)) (defdomain (d :redefine-ok t) ())))\n"
      "(eval-when (:execute) (progn (DefDomain e ()) '(defproblem p d () ())))\n"
      "#.(make-problem 'q 'e '((a)) '())\n"
      "(def-problem-set s (p q)) (find-plans 'p :verbose :plans)");

  ASSERT_EQ(reader.error_text(), "");
  ASSERT_EQ(reader.definitions.domains.size(), 2U);
  EXPECT_EQ(reader.definitions.domains[0].name, "d");
  EXPECT_EQ(reader.definitions.domains[1].name, "e");
  ASSERT_EQ(reader.definitions.problems.size(), 2U);
  EXPECT_EQ(reader.definitions.problems[0].name, "p");
  EXPECT_EQ(reader.definitions.problems[1].domain, "e");
  ASSERT_EQ(reader.definitions.functions.size(), 1U);
  EXPECT_EQ(reader.definitions.functions[0].name, "make-d");
  EXPECT_EQ(reader.definitions.functions[0].body.size(), 1U);
}

TEST(ReadOperator, TellsTheThreeFormsApart) {
  ReaderFixture reader;

  reader.read_items(
      "(:operator (!a ?x) ((d ?x)) ((e ?x)))"
      "(:operator (!b ?x) ((d ?x)) ((e ?x)) 3)"
      "(:operator (!c ?x) ((c ?x)) ((d ?x)) ((e ?x)))"
      "(:operator (!d ?x) ((c ?x)) ((d ?x)) ((e ?x)) (* 2 ?x))");

  ASSERT_EQ(reader.error_text(), "");
  const auto& all = reader.domain().operators;
  ASSERT_EQ(all.size(), 4U);
  for (const OperatorDefinition& one : all) {
    EXPECT_EQ(reader.text(one.deletions), "((d ?x))");
    EXPECT_EQ(reader.text(one.additions), "((e ?x))");
  }
  EXPECT_FALSE(all[0].precondition);
  EXPECT_FALSE(all[0].cost);
  EXPECT_FALSE(all[1].precondition);
  EXPECT_EQ(reader.text(all[1].cost), "3");
  EXPECT_EQ(reader.text(all[2].precondition), "((c ?x))");
  EXPECT_FALSE(all[2].cost);
  EXPECT_EQ(reader.text(all[3].cost), "(* 2 ?x)");
}

TEST(ReadOperator, TakesKeywordsInAnyOrder) {
  ReaderFixture reader;

  reader.read_items("(:op (!a ?x) :cost 2 :add ((e ?x)) :precond (c ?x) :delete ((d ?x)))");

  ASSERT_EQ(reader.error_text(), "");
  const OperatorDefinition& made = reader.domain().operators.at(0);
  EXPECT_EQ(reader.text(made.precondition), "(c ?x)");
  EXPECT_EQ(reader.text(made.deletions), "((d ?x))");
  EXPECT_EQ(reader.text(made.additions), "((e ?x))");
  EXPECT_EQ(reader.text(made.cost), "2");
}

TEST(ReadOperator, TakesVariablesProtectionsAndForallInItsLists) {
  ReaderFixture reader;

  reader.read_items(
      "(:operator (!a ?g ?x) () ?g ((:protection (p ?x)) ?g (forall (?y) (q ?y) ((r ?y) ?g))))"
      "(:operator (!b ?i) () ((forall nil (c ?i) ((c ?i)))) nil)");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.domain().operators.size(), 2U);
}

TEST(ReadMethod, TakesNamesLabelsAndSeveralBranches) {
  ReaderFixture reader;

  reader.read_items(
      "(:method (go ?x) ((a ?x)) ((go ?x)) nil ())"
      "(:method by-car (go ?x) near ((a ?x)) () far nil '((go ?x)))"
      "(:method (go ?x) ((a ?x)) `(:unordered (go ?x)))");

  ASSERT_EQ(reader.error_text(), "");
  const auto& all = reader.domain().methods;
  ASSERT_EQ(all.size(), 3U);
  ASSERT_EQ(all[0].branches.size(), 2U);
  EXPECT_EQ(all[0].name, "go");
  EXPECT_EQ(all[0].branches[0].label, "go-1");
  EXPECT_EQ(all[0].branches[1].label, "go-2");
  EXPECT_EQ(reader.text(all[0].branches[1].precondition), "nil");
  EXPECT_EQ(all[1].name, "by-car");
  EXPECT_EQ(all[1].branches[0].label, "near");
  EXPECT_EQ(all[1].branches[1].label, "far");
  EXPECT_EQ(reader.text(all[1].branches[1].tasks), "((go ?x))");
  EXPECT_EQ(reader.text(all[2].branches[0].tasks), "(:unordered (go ?x))");
}

TEST(ReadMethod, TakesABranchWithoutTasksWithAWarning) {
  ReaderFixture reader;

  reader.read_items("(:method (go) ((a)) ((go)) ((b)))");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_THAT(reader.warning_text(), HasSubstr("a branch without tasks"));
  EXPECT_FALSE(reader.domain().methods.at(0).branches.at(1).tasks);
}

TEST(ReadMethod, TakesAllFormsOfTaskLists) {
  ReaderFixture reader;

  reader.read_items(
      "(:operator (!a) () ()) (:method (b ?x) (p ?x) ()) (:method (m) () (!a))"
      "(:method (m) () (:task b 1)) (:method (m) () (:task :immediate !a))"
      "(:method (m) () ((:immediate b 2) (:ordered (!a) (:unordered) (:unordered ((!a) (b 3))))))"
      "(:method (m) () ((b (call + 1 2)) nil ()))");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.warning_text(), "");
  EXPECT_EQ(reader.domain().methods.size(), 6U);
}

TEST(ReadAxiom, TakesTailsWithAndWithoutLabels) {
  ReaderFixture reader;

  reader.read_items(
      "(:- (same ?x ?x) nil) (:- (fact))"
      "(:- (p ?x) ((a ?x)) ((b ?x)))"
      "(:- (p ?x) one ((a ?x)) two (b ?x))"
      "(:- (p ?x) nil ((a ?x)))");

  ASSERT_EQ(reader.error_text(), "");
  const auto& all = reader.domain().axioms;
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(reader.text(all[0].tails.at(0).precondition), "nil");
  EXPECT_TRUE(all[1].tails.empty());
  EXPECT_EQ(all[2].tails.size(), 2U);
  EXPECT_EQ(all[3].tails.at(1).label, "two");
  EXPECT_EQ(all[4].tails.size(), 1U) << "SHOP3 takes this nil for a label";
}

TEST(ReadCondition, TakesEveryWordOfTheLogic) {
  ReaderFixture reader;

  reader.read_items(
      "(:- (all ?x ?g) ((a ?x) ?g nil (and) (or (a ?x) (not (b ?x))) (imply (a ?x) (b ?x))"
      " (forall (?y) (a ?y) (b ?y)) (forall (?y - t ?z) (b ?y ?z)) (exists (?y) (a ?y))"
      " (assign ?v (+ ?x 1)) (assign* ?v (list 1)) (eval (> '?v 1)) (call = ?v 1)"
      " (setof ?y (a ?y) ?s) (bagof (?y . ?v) ((a ?y)) ?s) (enforce (a ?s) \"~a\" ?s)"
      " (:external (a ?x) (b ?x)) (:unbound ?x)))"
      "(:method (m) (:first (a ?x) (b ?x)) ())"
      "(:method (m) (:sort-by ?x (a ?x)) ())"
      "(:method (m) (:sort-by (* ?x ?x) #'> (and (a ?x))) ())");

  EXPECT_EQ(reader.error_text(), "");
}

TEST(ReadPddl, TakesActionsTypesAndDerivedPredicates) {
  ReaderFixture reader;

  reader.read(
      "(defdomain (d :type pddl-domain) ((:requirements :typing)"
      " (:types car - vehicle vehicle place) (:static road) (:predicates (at ?c - car ?p - place))"
      " (:functions (fuel ?c - car) - number) (:constants home - place)"
      " (:action drive :parameters (?c - car ?p - (either place object))"
      "  :precondition (and (at ?c ?p) (forall (?q - place) (ok ?q)))"
      "  :effect (and (not (at ?c ?p)) (when (a) (b)) (forall (?q - place) (seen ?q))"
      "   (decrease (fuel ?c) 1)) :cost 3)"
      " (:derived (near ?p - place) (exists (?q - place) (road ?p ?q)))"
      " (:pddl-method (m ?c) go (and) (:ordered (!drive ?c home)))))");

  ASSERT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.warning_text(), "");
  const DomainDefinition& domain = reader.domain();
  EXPECT_TRUE(domain.pddl);
  ASSERT_EQ(domain.types.size(), 3U);
  EXPECT_EQ(domain.types[0].super, reader.store.symbol("vehicle"));
  EXPECT_EQ(domain.types[1].super, kNil);
  ASSERT_EQ(domain.operators.size(), 1U);
  EXPECT_TRUE(domain.operators[0].action);
  EXPECT_EQ(reader.text(domain.operators[0].head), "drive");
  EXPECT_EQ(reader.text(domain.operators[0].cost), "3");
  EXPECT_TRUE(domain.axioms.at(0).derived);
  EXPECT_TRUE(domain.methods.at(0).pddl);
  EXPECT_EQ(domain.static_predicates.size(), 1U);
}

TEST(ReadProblem, TakesBothFormsWithAndWithoutDomain) {
  ReaderFixture reader;

  reader.read(
      "(defproblem a d ((p 1) (q (r . s))) (:unordered (t1) (t2)))"
      "(defproblem b () (t1)) (defproblem (c :domain d) nil nil)"
      "(make-problem 'e 'd '((p)) '((t1))) (make-problem 'f '() '(:task t1) :documentation \"x\")");

  ASSERT_EQ(reader.error_text(), "");
  const auto& all = reader.definitions.problems;
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].domain, "d");
  EXPECT_EQ(reader.text(all[0].facts), "((p 1) (q (r . s)))");
  EXPECT_EQ(all[1].domain, "");
  EXPECT_EQ(reader.text(all[1].tasks), "(t1)");
  EXPECT_EQ(all[2].domain, "d");
  EXPECT_EQ(reader.text(all[3].tasks), "((t1))");
  EXPECT_EQ(all[4].domain, "");
}

TEST(ReadProblem, LeavesOutWhatLispCodeComputes) {
  ReaderFixture reader;

  reader.read("(defun f (n) (make-problem n 'd '() '())) (make-problem 'p 'd `((a ,(f))) '())");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_TRUE(reader.definitions.problems.empty());
  EXPECT_EQ(reader.warnings.size(), 2U);
}

// Inclusion

TEST(ReadInclude, TakesTheItemsOfTheNamedDomainInPlace) {
  ReaderFixture reader;
  reader.with_file("tools.lisp", "(defdomain other ()) (defdomain tools ((:operator (!b) () ())))")
      .with_file("more/x.lisp", "(in-package :x) (defdomain (X :a b) ((:include tools)))");

  reader.read_items("(:operator (!a) () ()) (:include x \"more/x.lisp\") (:operator (!c) () ())");

  ASSERT_EQ(reader.error_text(), "");
  ASSERT_EQ(reader.domain().operators.size(), 3U);
  EXPECT_EQ(reader.text(reader.domain().operators[1].head), "(!b)");
  EXPECT_EQ(reader.definitions.domains.size(), 1U);
  EXPECT_EQ(reader.definitions.documents.size(), 3U);
}

TEST(ReadInclude, APddlDomainIsIncludedByTheTextThatWouldMakeItsPath) {
  ReaderFixture reader;
  reader.with_file("base.pddl",
                   "(define (domain base) (:types site) (:action look :parameters (?s - site)"
                   " :precondition (open ?s) :effect (seen ?s)))");

  reader.read_items("(:include base #.(merge-pathnames \"base.pddl\" (or here there)))");

  EXPECT_EQ(reader.error_text(), "");
  ASSERT_EQ(reader.domain().operators.size(), 1U);
  EXPECT_TRUE(reader.domain().operators.front().action);
  EXPECT_TRUE(reader.domain().pddl);
}

TEST(ReaderDefinitions, AQuantifierMayHaveOneVariableWithoutParentheses) {
  ReaderFixture reader;

  reader.read_items("(:- (all-made ?o) ((forall ?p (part ?o ?p) (made ?p))))");

  EXPECT_EQ(reader.error_text(), "");
}

TEST(ReadInclude, ReportsCyclesAndWhatIsAbsent) {
  ReaderFixture reader;
  reader.with_file("a.lisp", "(defdomain a ((:include b)))")
      .with_file("b.lisp", "(defdomain b ((:include a)))");

  reader.read_items("(:include a) (:include c) (:include ab \"a.lisp\") (:include)");

  EXPECT_THAT(reader.error_text(), HasSubstr("b.lisp:1:15: 'a.lisp' includes itself"));
  EXPECT_THAT(reader.error_text(), HasSubstr("cannot include 'c.lisp': no such file"));
  EXPECT_THAT(reader.error_text(), HasSubstr("no domain 'ab' in 'a.lisp'"));
  EXPECT_THAT(reader.error_text(), HasSubstr("malformed inclusion"));
}

TEST(ReadInclude, EndsWhenFilesIncludeEachOtherUnderManyNames) {
  ReaderFixture reader;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "n" + std::to_string(i + 1);
    reader.with_file(
        "n" + std::to_string(i) + ".lisp",
        "(defdomain n" + std::to_string(i) + " ((:include " + next + ") (:include " + next + ")))");
  }

  reader.read_items("(:include n0)");

  EXPECT_THAT(reader.error_text(), HasSubstr("more than 1000 inclusions"));
}

// Errors and warnings beyond the golden files

TEST(ReadDefinitions, LeavesOutWrongItemsAndKeepsTheOthers) {
  ReaderFixture reader;

  reader.read_items("(:operator (a) () ()) (:operator (!b) () ()) (:method) (:method (m) () ())");

  EXPECT_EQ(reader.errors.size(), 2U);
  EXPECT_EQ(reader.domain().operators.size(), 1U);
  EXPECT_EQ(reader.domain().methods.size(), 1U);
}

TEST(ReadDefinitions, RefusesDefinitionsNestedTooDeepForWhatWorksOnThem) {
  ReaderFixture reader;
  const auto nested = [](int depth) {
    std::string text = "(defproblem p d (";
    for (int i = 0; i < depth; ++i) text += "(a ";
    return text + std::string(static_cast<std::size_t>(depth), ')') + ") ())";
  };

  reader.read(nested(900) + nested(900'000) + "(defproblem q d () ())");

  EXPECT_EQ(reader.error_text(), "test.lisp:1:" + std::to_string(nested(900).size() + 1) +
                                     ": a definition nested more than 1000 deep\n");
  EXPECT_EQ(reader.definitions.problems.size(), 2U);
}

TEST(ReadDefinitions, IsQuietAboutSingleUsesWhereTheFileSaysSo) {
  ReaderFixture reader;
  const std::string domain = "(defdomain d ((:operator (!a ?x) () ())))";

  reader.read("(let ((shop2::*ignore-singleton-variables* t)) " + domain + ")");
  EXPECT_EQ(reader.warning_text(), "");
  reader.read("(let ((*ignore-singleton-variables* nil)) " + domain + ")");
  EXPECT_THAT(reader.warning_text(), HasSubstr("variable ?x used only once in operator '!a'"));
}

TEST(ReadDefinitions, CountsVariablesAsShop3Does) {
  ReaderFixture reader;

  reader.read_items(
      "(:method (m ?head ?unused ?_ ?_any) ((p ?head ?both)) ((!o ?both)) ((p ?once)) ())"
      "(:operator (!o ?x) ((p '?x)) () ())");

  EXPECT_THAT(reader.warning_text(), HasSubstr("variable ?once used only once in branch 2 of"));
  EXPECT_THAT(reader.warning_text(), HasSubstr("variable ?unused used only once in method 'm'"));
  EXPECT_EQ(reader.warnings.size(), 2U) << reader.warning_text();
}

TEST(ReadDefinitions, ComparesProblemsWithDomainsInWhateverOrderTheyCome) {
  const std::string domain = "(defdomain d ((:operator (!a ?x) ((p ?x)) () ())))";
  const std::string problem = "(defproblem q d ((r 1)) ((!a) (!b)))";
  ReaderFixture first;
  ReaderFixture last;

  first.read(domain, "d").read(problem, "p");
  last.read(problem, "p").read(domain, "d");

  for (const ReaderFixture* reader : {&first, &last}) {
    EXPECT_THAT(reader->warning_text(), HasSubstr("task '!a' with 0 arguments matches no head"));
    EXPECT_THAT(reader->warning_text(), HasSubstr("task '!b' has neither method nor operator"));
    EXPECT_THAT(reader->warning_text(), HasSubstr("nothing provides (p …)"));
    EXPECT_EQ(reader->warnings.size(), 3U);
  }
}

TEST(ReadDefinitions, ComparesNumbersOfArgumentsWithDottedHeads) {
  ReaderFixture reader;

  reader.read_items(
      "(:method (any ?_x . ?_rest) () ()) (:method (m ?l) () ((any 1) (any 1 2 3) (any . ?l)))"
      "(:method (n) () ((any)))");

  EXPECT_EQ(reader.warning_text(),
            "test.lisp:1:119: task 'any' with 0 arguments matches no head; expected 1 or more\n");
}

TEST(ReadDefinitions, TakesWhatTasksPassToAssertingOperatorsForProvided) {
  ReaderFixture reader;

  reader.read_items(
      "(:operator (!!assert ?g) () ?g) (:method (m) ((not (done)) (not (missing)))"
      " ((!!assert ((done)))))");
  reader.read("(defproblem p d () (m))", "p");

  EXPECT_THAT(reader.warning_text(), HasSubstr("nothing provides (missing …)"));
  EXPECT_EQ(reader.warnings.size(), 1U);
}

TEST(ReadDefinitions, ReportsTwoHundredErrorsAtMost) {
  ReaderFixture reader;
  std::string facts;
  for (int i = 0; i < 500; ++i) facts += "(p ?x) ";

  reader.read("(defproblem p d (" + facts + ") ())");

  EXPECT_EQ(reader.errors.size(), 201U);
  EXPECT_THAT(reader.error_text(), HasSubstr("300 more"));
}

// What SHOP3 takes although it was not meant so.

TEST(ReadLenient, TakesTheTailOfAListForOneMoreCondition) {
  ReaderFixture reader;
  reader.read_items("(:method (a ?x ?y) ((different ?x ?y) hoist ?h ?x) ((b ?h)))");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_THAT(reader.warning_text(), ::testing::HasSubstr("a condition without its parentheses"));
  const Expression condition = reader.domain().methods.at(0).branches.at(0).precondition;
  const auto parts = children(*condition.document, condition.node);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(testing::printed(*condition.document, parts[1], reader.store), "(hoist ?h ?x)");
}

TEST(ReadLenient, LeavesStrayWordsOut) {
  ReaderFixture reader;
  reader.read(
      "(defdomain d (^ (:operator (!a) () (()) (())))) (defproblem p d ((NIL) (b) ^ ()) ())");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_THAT(reader.warning_text(), ::testing::HasSubstr("a stray '^' is left out"));
  EXPECT_EQ(make_problem(reader.definitions.problems.at(0), reader.store).facts.size(), 1U);
}

TEST(ReadLenient, FindsIncludedFilesWhereverTheirSystemLies) {
  ReaderFixture reader;
  reader.with_file("basic.lisp", "(defdomain basic ((:operator (!a) () () ())))")
      .read_items(
          "(:include basic #.(asdf:system-relative-pathname \"shop3\" "
          "\"examples/folder/basic.lisp\"))");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.domain().operators.size(), 1U);
}

TEST(ReadLenient, FoldsTheCaseOfLettersBeyondAscii) {
  TermStore store;
  for (const auto& [capital, small] :
       std::vector<std::pair<std::string, std::string>>{{"ÉCOLE", "école"},
                                                        {"Łódź", "łódź"},
                                                        {"ΑΘΉΝΑ", "αθήνα"},
                                                        {"МОСКВА", "москва"},
                                                        {"Ž", "ž"},
                                                        {"Ÿ", "ÿ"},
                                                        {"×", "×"},
                                                        {"İ", "İ"},
                                                        {"日本", "日本"}}) {
    EXPECT_EQ(store.symbol(capital), store.symbol(small)) << capital;
    EXPECT_EQ(store.name(store.symbol(capital)), small);
  }
}

}  // namespace
}  // namespace skein::htn
