// SPDX-License-Identifier: Apache-2.0
// Forms beside domains and problems: global variables, other languages, slips of the pen; and the
// predicates that a domain and a problem name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/htn/predicates.hpp"
#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using testing::ReaderFixture;
using ::testing::UnorderedElementsAre;

// ---- global variables ------------------------------------------------------------------------

/// The variables of a text as "name = value"; "name" for one without value.
std::vector<std::string> globals_of(const std::string& text) {
  ReaderFixture reader;
  reader.read(text);
  EXPECT_EQ(reader.error_text(), "") << text;
  std::vector<std::string> out;
  for (const FunctionDefinition& one : reader.definitions.functions) {
    EXPECT_TRUE(one.variable) << one.name;
    out.push_back(one.name + (one.body.empty() ? "" : " = " + reader.text(one.body.front())));
  }
  return out;
}

TEST(ReadGlobals, TakesEachOfTheThreeDefinitions) {
  EXPECT_THAT(globals_of("(defvar *a* 1) (defparameter *b* '(x y)) (defconstant c (+ 1 2))"),
              ElementsAre("*a* = 1", "*b* = '(x y)", "c = (+ 1 2)"));
}

TEST(ReadGlobals, ADefinitionIsOfOneVariableWhateverFollowsItsValue) {
  EXPECT_THAT(globals_of("(defvar *a* 1 \"what it is\") (defparameter *b* 2 *c* 3)"),
              ElementsAre("*a* = 1", "*b* = 2"));
}

TEST(ReadGlobals, AVariableMayBeDefinedWithoutAValue) {
  EXPECT_THAT(globals_of("(defvar *a*)"), ElementsAre("*a*"));
}

TEST(ReadGlobals, AnAssignmentAtTheTopIsOfManyVariables) {
  EXPECT_THAT(globals_of("(setf *a* 1 *b* 2) (setq *c* 3)"),
              ElementsAre("*a* = 1", "*b* = 2", "*c* = 3"));
  EXPECT_THAT(globals_of("(setf *a* 1 *b*)"), ElementsAre("*a* = 1", "*b*"));
}

TEST(ReadGlobals, AnAssignmentOfAPlaceDefinesNothingBeyondIt) {
  EXPECT_THAT(globals_of("(setf *a* 1 (car *a*) 2 *b* 3)"), ElementsAre("*a* = 1"));
  EXPECT_THAT(globals_of("(setf (get 'x 'y) 5)"), IsEmpty());
}

TEST(ReadGlobals, AnAssignmentInsideAFormDefinesNothing) {
  EXPECT_THAT(globals_of("(let () (setf *a* 1) (defvar *b* 2))"), ElementsAre("*b* = 2"));
}

TEST(ReadGlobals, OtherFormsAndMalformedOnesDefineNothing) {
  EXPECT_THAT(globals_of("(defvars *a* 1) (defvar 5 1) (defvar \"a\" 1) (defvar) (print *a*) 5 ()"),
              IsEmpty());
}

// ---- other languages -------------------------------------------------------------------------

std::vector<std::string> foreign_of(const std::string& text) {
  ReaderFixture reader;
  reader.read(text);
  EXPECT_EQ(reader.error_text() + reader.warning_text(), "") << text;
  std::vector<std::string> out;
  for (const ForeignDefinition& one : reader.definitions.foreign) out.push_back(one.language);
  return out;
}

TEST(ReadForeign, DomainsAndProblemsOfPddlAreKnown) {
  EXPECT_THAT(foreign_of("(define (domain d) (:predicates (p)) (:action a))"), ElementsAre("PDDL"));
  EXPECT_THAT(foreign_of("(define (problem p) (:domain d) (:init) (:goal (p)))"),
              ElementsAre("PDDL"));
}

TEST(ReadForeign, WhatHasTasksOrMethodsIsHierarchical) {
  for (const char* const part : {"(:task go :parameters ())", "(:method m :task (go))",
                                 "(:htn :subtasks (and))", "(:tasks (go))"}) {
    EXPECT_THAT(foreign_of(std::string("(define (domain d) ") + part + " (:action a))"),
                ElementsAre("HDDL"))
        << part;
    EXPECT_THAT(foreign_of(std::string("(define (problem d) (:init) ") + part + ")"),
                ElementsAre("HDDL"))
        << part;
  }
}

TEST(ReadForeign, EachDefinitionIsTakenForItself) {
  EXPECT_THAT(foreign_of("(define (domain a) (:method m)) (define (problem b) (:init))"),
              ElementsAre("HDDL", "PDDL"));
}

TEST(ReadForeign, OtherFormsOfThatNameAreNone) {
  EXPECT_THAT(foreign_of("(define) (define x 5) (define (f x) x) (define ((domain)) x) (definer "
                         "(domain d))"),
              IsEmpty());
}

// ---- slips of the pen ------------------------------------------------------------------------

std::string warning_of(const std::string& text) {
  ReaderFixture reader;
  reader.read(text);
  EXPECT_EQ(reader.error_text(), "");
  return reader.warning_text();
}

TEST(ReadMisspelt, OneLetterAwayFromADefinitionIsNearlyOne) {
  const auto meant = [](const std::string& word, const std::string& name) {
    return "test.lisp:1:1: '" + word + "' defines nothing; expected a definition; did you mean '" +
           name + "'?\n";
  };

  for (const char* const word : {"defdomai", "defdomainn", "defdomein", "edfdomain", "defdomian"})
    EXPECT_EQ(warning_of("(" + std::string(word) + " d ())"), meant(word, "defdomain")) << word;
  EXPECT_EQ(warning_of("(defproblm p d () ())"), meant("defproblm", "defproblem"));
  EXPECT_EQ(warning_of("(make-probelm 'p 'd '() '())"), meant("make-probelm", "make-problem"));
}

TEST(ReadMisspelt, TwoLettersAwayIsAnotherWord) {
  for (const char* const word : {"domain", "defdoman-", "fedsomain", "defdmoian", "defdomainer"})
    EXPECT_EQ(warning_of("(" + std::string(word) + " d ())"), "") << word;
}

TEST(ReadSecond, OfTwoDefinitionsWithOneNameTheLaterIsWarnedOf) {
  EXPECT_EQ(warning_of("(defdomain d ())\n(defdomain e ())\n(defdomain d ())"),
            "test.lisp:3:1: a second domain 'd'; expected another name\n");
  EXPECT_EQ(warning_of("(defdomain d ()) (defproblem p d () ())\n(defproblem p d () ())"),
            "test.lisp:2:1: a second problem 'p'; expected another name\n");
  EXPECT_EQ(warning_of("(defdomain d ()) (defproblem d d () ())"), "") << "one of each";
}

TEST(ReadWithoutWarnings, ErrorsAreFoundAllTheSame) {
  TermStore store;
  Definitions definitions;
  Diagnostics errors;

  read_definitions({"t.lisp", "(defdomain d ((:operator (!a ?x) () ()) (:operator (b) () ())))"},
                   store, {}, definitions, errors);

  EXPECT_EQ(
      to_text(errors),
      "t.lisp:1:53: operator 'b'; expected a name that begins with '!'; did you mean '!b'?\n");
  EXPECT_EQ(definitions.domains.at(0).operators.size(), 1U);
}

TEST(ReadWithoutFiles, AnInclusionSaysThatNoneAreRead) {
  TermStore store;
  Definitions definitions;
  Diagnostics errors;

  read_definitions({"t.lisp", "(defdomain d ((:include other)))"}, store, {}, definitions, errors);

  EXPECT_THAT(to_text(errors), ::testing::HasSubstr("files are not included here"));
}

// ---- predicates ------------------------------------------------------------------------------

Predicates named(const std::string& items, const std::string& facts = "") {
  ReaderFixture reader;
  reader.read("(defdomain d (" + items + ")) (defproblem p d (" + facts + ") ())");
  EXPECT_EQ(reader.error_text(), "");
  return predicates_of(reader.definitions, reader.definitions.domains.at(0),
                       reader.definitions.problems.at(0), reader.store);
}

TEST(PredicatesOf, ADomainAreThoseOfAllItsParts) {
  const Predicates all = named(
      "(:operator (!a ?x) ((pre ?x) (not (absent ?x ?x)))"
      " ((gone ?x) (forall (?y) ((bound ?x ?y)) ((each ?y)))) ((made ?x 1 2)) (* 2 3))"
      "(:method (m ?x) (:first (way ?x)) () (:sort-by ?x (or (one ?x) ((two) (two ?x)))) ())"
      "(:- (head ?x) ((body ?x)) ((exists (?z) ((dom ?z)) ((cod ?z)))))");

  EXPECT_THAT(all.arities,
              UnorderedElementsAre(Pair("pre", ElementsAre(1U)), Pair("absent", ElementsAre(2U)),
                                   Pair("gone", ElementsAre(1U)), Pair("bound", ElementsAre(2U)),
                                   Pair("each", ElementsAre(1U)), Pair("made", ElementsAre(3U)),
                                   Pair("way", ElementsAre(1U)), Pair("one", ElementsAre(1U)),
                                   Pair("two", ElementsAre(0U, 1U)), Pair("head", ElementsAre(1U)),
                                   Pair("body", ElementsAre(1U)), Pair("dom", ElementsAre(1U)),
                                   Pair("cod", ElementsAre(1U))));
  EXPECT_FALSE(all.any);
}

TEST(PredicatesOf, AProblemAreThoseOfItsFacts) {
  EXPECT_THAT(named("", "(at a b) (at a) (fuel)").arities,
              UnorderedElementsAre(Pair("at", ElementsAre(1U, 2U)), Pair("fuel", ElementsAre(0U))));
}

TEST(PredicatesOf, ADomainMayBeOthersWhereAVariableHoldsThem) {
  EXPECT_TRUE(named("(:operator (!a ?g) () () ?g)").any);
  EXPECT_TRUE(named("(:operator (!a ?g) () ?g ())").any);
  EXPECT_TRUE(named("(:operator (!a ?g) () () (?g (p)))").any);
  EXPECT_TRUE(named("(:operator (!a ?p) () () ((?p x)))").any);
  EXPECT_TRUE(named("(:action a :effect (p))").any) << "types and numbers are predicates, too";
  EXPECT_FALSE(named("(:operator (!a ?x) ((p ?x)) () ((q ?x)))").any);
}

}  // namespace
}  // namespace skein::htn
