// SPDX-License-Identifier: Apache-2.0
// Files, problems, limits, exit codes and streams of `skein plan`.
#include "skein/plan_tool/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing_command::domain_file;
using testing_command::Done;
using testing_command::File;
using testing_command::options_for;
using testing_command::plan;

constexpr const char* kDomain =
    "(defdomain hold ((:operator (!take ?x) ((free ?x)) ((free ?x)) ((held ?x)))))\n";
constexpr const char* kProblem = "(defproblem one hold ((free box)) ((!take box)))\n";

// --- files and problems --------------------------------------------------------------------------

TEST(Plan, PlansEveryProblemOfTheFiles) {
  const Done done = plan(options_for("counter.lisp"));

  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, StartsWith("ten (counter): plan, 10 steps, cost 10.0\n"));
  EXPECT_THAT(done.out, HasSubstr("\nthousand (counter): plan, 1000 steps, cost 1000.0\n"));
}

TEST(Plan, PlansOnlyTheProblemsNamedWhateverTheCase) {
  const Done done = plan(options_for("counter.lisp", "TEN"));

  EXPECT_THAT(done.out, HasSubstr("ten (counter)"));
  EXPECT_THAT(done.out, Not(HasSubstr("thousand")));
}

TEST(Plan, TakesDomainAndProblemsFromDifferentFilesInAnyOrder) {
  const File domain("domain.lisp", kDomain);
  const File problem("problem.lisp", kProblem);
  PlanOptions options;
  options.files = {problem.path(), domain.path()};

  const Done done = plan(options);

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.out, HasSubstr("  1  (!take box)  1.0\n"));
}

TEST(Plan, ReadsStandardInput) {
  PlanOptions options;
  options.files = {"-"};

  const Done done = plan(options, {}, std::string(kDomain) + kProblem);

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.out, HasSubstr("one (hold): plan, 1 step, cost 1.0\n"));
}

TEST(Plan, UsesTheOnlyDomainThereIsForAProblemOfAnother) {
  PlanOptions options;
  options.files = {"-"};

  const Done done =
      plan(options, {}, std::string(kDomain) + "(defproblem p other ((free box)) ((!take box)))");

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.out, HasSubstr("p (hold): plan"));
}

TEST(Plan, ReadsWhatAFileIncludesFromBesideIt) {
  const File axioms("axioms.lisp", "(defdomain axioms ((:- (free ?x) ((not (held ?x))))))");
  const std::string name = std::filesystem::path(axioms.path()).filename().string();
  const File domain("domain.lisp", "(defdomain hold ((:include axioms \"" + name +
                                       "\") (:operator (!take ?x) ((free ?x)) () ((held ?x)))))"
                                       "(defproblem p hold () ((!take box)))");
  PlanOptions options;
  options.files = {domain.path()};

  const Done done = plan(options);

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("(!take box)"));
}

TEST(Plan, TakesTheDomainThatComesLastOfTwoWithOneName) {
  PlanOptions options;
  options.files = {"-"};
  const std::string again = "(defdomain hold ((:operator (!take ?x) () () () 7)))";

  const Done done = plan(options, {}, kDomain + again + kProblem);

  EXPECT_THAT(done.out, HasSubstr("cost 7\n"));
}

// --- wrong input ---------------------------------------------------------------------------------

TEST(PlanErrors, AreToldAllAtOnceWithTheTextUnderlined) {
  const Done done = plan(options_for("wrong.lisp"));

  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(done.out, "");
  EXPECT_THAT(done.err, HasSubstr("wrong.lisp:6:39: error: variable ?y in a fact"));
  EXPECT_THAT(done.err, HasSubstr("(defproblem p wrong ((here box) (here ?y)) ((get box)))\n"
                                  "                                        ^~\n"));
  EXPECT_THAT(done.err, HasSubstr("wrong.lisp:4:62: error: unknown function 'cheapest'"));
}

TEST(PlanErrors, AreColouredOnATerminalOnly) {
  Surroundings terminal;
  terminal.colour_err = true;

  EXPECT_THAT(plan(options_for("wrong.lisp"), terminal).err, HasSubstr("\033[31merror: \033[0m"));
  EXPECT_THAT(plan(options_for("wrong.lisp")).err, Not(HasSubstr("\033")));
}

TEST(PlanErrors, NameAFileThatCannotBeRead) {
  PlanOptions options;
  options.files = {"/no/such.lisp", testing::TempDir()};

  const Done done = plan(options);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("/no/such.lisp: error: there is no such file\n"));
  EXPECT_THAT(done.err, HasSubstr("is a folder, not a file\n"));
}

TEST(PlanErrors, SuggestTheNearestProblem) {
  const Done done = plan(options_for("counter.lisp", "tan"));

  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(done.err,
            "error: no problem is called 'tan'; expected ten or thousand; did you mean 'ten'?\n");
}

TEST(PlanErrors, SayWhenThereIsNoProblemOrNoDomain) {
  PlanOptions options;
  options.files = {"-"};

  EXPECT_THAT(plan(options, {}, kDomain).err, HasSubstr("no problem in these files"));
  EXPECT_THAT(plan(options, {}, kProblem).err, HasSubstr("problem 'one' has no domain"));
  EXPECT_EQ(plan(options, {}, kProblem).code, 2);
}

TEST(PlanErrors, AskForADomainWhereSeveralMayBeMeant) {
  PlanOptions options;
  options.files = {"-"};
  const std::string two = std::string(kDomain) + "(defdomain other ((:operator (!a) () () ())))";

  const Done done = plan(options, {}, two + "(defproblem p held () ((!a)))");

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("unknown domain 'held'; did you mean 'hold'?"));
}

TEST(PlanErrors, KeepWarningsFromQuietOnes) {
  PlanOptions options;
  options.files = {"-"};
  const std::string text =
      "(defdomain d ((:operator (!a) ((p ?x)) () ()))) "
      "(defproblem q d ((p 1)) ((!a)))";

  const Done loud = plan(options, {}, text);
  options.quiet = true;
  const Done quiet = plan(options, {}, text);

  EXPECT_EQ(loud.code, 0);
  EXPECT_THAT(loud.err, HasSubstr("-:1:35: warning: variable ?x used only once"));
  EXPECT_EQ(quiet.err, "");
}

TEST(PlanErrors, OfEvaluationEndWithTheCodeOfWrongInput) {
  PlanOptions options;
  options.files = {"-"};

  const Done done = plan(options, {},
                         "(defdomain d ((:operator (!a ?x) () () () (/ 1 ?x)))) "
                         "(defproblem p d () ((!a 0)))");

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.out, HasSubstr("p (d): error: "));
}

// --- results -------------------------------------------------------------------------------------

TEST(PlanResult, IsNegativeWhenSomeProblemHasNoPlan) {
  const Done done = plan(options_for("relief.lisp"));

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("island (relief): there is no plan\n"));
  EXPECT_THAT(done.out, HasSubstr("one-crate (relief): plan, 10 steps, cost 20.0\n"));
}

TEST(PlanResult, OfALimitHasItsOwnCodeAndThePlansSoFar) {
  PlanOptions options = options_for("relief.lisp", "one-crate");
  options.search.which = htn::Which::kAll;
  options.search.limits.expansions = 24;

  const Done done = plan(options);

  EXPECT_EQ(done.code, 4);
  EXPECT_THAT(done.out, HasSubstr("one-crate (relief): cut: "));
  EXPECT_THAT(done.out, HasSubstr("so far: plan, 10 steps, cost 20.0\n"));
}

TEST(PlanResult, OfATimeLimitUsesTheProcessorTimeGiven) {
  PlanOptions options = options_for("counter.lisp", "thousand");
  options.search.limits.seconds = 2;
  double now = 0;
  Surroundings surroundings;
  surroundings.cpu_seconds = [&now] { return now += 1.5; };

  const Done done = plan(options, surroundings);

  EXPECT_EQ(done.code, 4) << done.out;
}

TEST(PlanResult, OfAnInterruptionIsTheBestSoFarAndNoMoreIsPlanned) {
  PlanOptions options = options_for("counter.lisp");
  int asked = 0;
  Surroundings surroundings;
  surroundings.interrupted = [&asked] { return ++asked > 0; };

  const Done done = plan(options, surroundings);

  EXPECT_EQ(done.code, 130);
  EXPECT_THAT(done.out, HasSubstr("ten (counter)"));
  EXPECT_THAT(done.out, Not(HasSubstr("thousand")));
}

TEST(PlanResult, OfTheCheapestPlanDiffersFromTheFirst) {
  PlanOptions options = options_for("relief.lisp", "one-crate");
  options.no_internal = true;

  const Done first = plan(options);
  options.search.which = htn::Which::kBest;
  const Done best = plan(options);

  EXPECT_THAT(first.out, HasSubstr("4 steps and 6 internal, cost 20.0\n"));
  EXPECT_THAT(best.out, HasSubstr("3 steps and 5 internal, cost 12.5\n"));
}

// --- progress ------------------------------------------------------------------------------------

TEST(PlanProgress, IsWrittenOverEachSecondAndTakenAway) {
  PlanOptions options;
  options.files = {"-"};
  options.search.limits.expansions = 200'000;
  double now = 0;
  Surroundings surroundings;
  surroundings.cpu_seconds = [&now] { return now += 0.5; };
  surroundings.progress = true;
  const std::string endless =
      "(defdomain d ((:operator (!a) () () ()) (:method (go) ((on)) ((!a) (go))))) "
      "(defproblem p d ((on)) ((go)))";

  const Done done = plan(options, surroundings, endless);

  EXPECT_THAT(done.err, HasSubstr("\r\033[Kp: "));
  EXPECT_THAT(done.err, HasSubstr("no plan yet"));
  EXPECT_TRUE(done.err.ends_with("\r\033[K")) << done.err;
  options.quiet = true;
  EXPECT_EQ(plan(options, surroundings, endless).err, "");
}

TEST(PlanResult, IsTheSameEachTime) {
  EXPECT_EQ(plan(options_for("uav.lisp")).out, plan(options_for("uav.lisp")).out);
}

}  // namespace
}  // namespace skein::plan_tool
