// SPDX-License-Identifier: Apache-2.0
// Input that nobody meant: it ends soon, with a clear answer, in every form of output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing_command::Done;
using testing_command::File;
using testing_command::options_for;
using testing_command::plan;

PlanOptions standard_input() {
  PlanOptions options;
  options.files = {"-"};
  return options;
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string out;
  for (std::size_t at = 0; at < times; ++at) out += text;
  return out;
}

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return longest;
}

// The law of all bad input: whatever stands in a file, on one line or on many, what is said about
// it is short.
class AnyBadText : public testing::TestWithParam<std::string> {};

TEST_P(AnyBadText, IsAnsweredShortly) {
  constexpr std::size_t kTimes = 100'000;
  constexpr std::size_t kLongestLine = 1'500;  // bytes: three clipped parts and what is around them
  for (const std::string& text :
       {repeated(GetParam(), kTimes), "(defdomain d (" + repeated(GetParam(), kTimes) + "))",
        "(defproblem p d (" + repeated(GetParam(), kTimes) + ") ())"}) {
    const Done done = plan(standard_input(), {}, text);

    EXPECT_EQ(done.code, 2);
    EXPECT_LT(done.err.size(), 400'000U);
    EXPECT_LT(longest_line(done.err), kLongestLine) << done.err.substr(0, 3'000);
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, AnyBadText,
                         testing::Values("(", ")", "'", "#.", "#+", "a", "(a ", "(:method ", "(a)",
                                         "\"", "|", "1/0 ", "#x", "(b ?x) ", "é", "\xFF", "((?x "));

TEST(BadInput, NestedTooDeepIsOneErrorWithinBoundedMemory) {
  const Done done = plan(standard_input(), {}, std::string(20'000'000, '('));

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("-:1:1000001: error: nested more than 1000000 deep"));
  EXPECT_LT(done.err.size(), 1'000U);
}

TEST(BadInput, IsAnErrorInJsonToo) {
  PlanOptions options = options_for("wrong.lisp");
  options.json = true;

  const Done done = plan(options);

  const auto line = nlohmann::json::parse(done.out);
  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(line["result"], "error");
  EXPECT_THAT(line["why"].get<std::string>(), HasSubstr("variable ?y in a fact"));
  ASSERT_EQ(line["errors"].size(), 2U);
  EXPECT_EQ(line["errors"][0]["line"], 6);
  EXPECT_EQ(line["errors"][0]["expected"], "a constant");
}

TEST(BadInput, NamesTheProblemsThereAre) {
  const Done done = plan(options_for("counter.lisp", "nosuch"));

  EXPECT_THAT(done.err, HasSubstr("no problem is called 'nosuch'; expected ten"));
  EXPECT_THAT(done.err, HasSubstr("thousand"));
}

TEST(BadInput, OfAnotherLanguageIsNamed) {
  const std::string hddl =
      "(define (domain transport) (:requirements :hierarchy)\n"
      " (:task deliver :parameters (?p)) (:method m :parameters () :task (deliver ?p)))\n"
      "(define (problem p) (:domain transport) (:htn :subtasks (and)) (:init))";
  const Done done = plan(standard_input(), {}, hddl);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("-:1:1: error: this is HDDL, which is not read; expected SHOP2's "
                                  "(defdomain …) and (defproblem …)"));
  EXPECT_THAT(done.err, HasSubstr("-:3:1: error: this is HDDL"));
  EXPECT_THAT(done.err, Not(HasSubstr("no problem in these files")));
  const Done pddl =
      plan(standard_input(), {}, "(define (problem p) (:domain d) (:init) (:goal (and)))");
  EXPECT_THAT(pddl.err, HasSubstr("this is PDDL, which is not read"));
}

TEST(BadInput, OfNearlyTheRightNameIsToldTheRightOne) {
  const Done done = plan(standard_input(), {}, "(defdomian d ())\n(defproblem p d () ())");

  EXPECT_THAT(done.err, HasSubstr("-:1:1: warning: 'defdomian' defines nothing"));
  EXPECT_THAT(done.err, HasSubstr("did you mean 'defdomain'?"));
}

TEST(BadInput, DefinedTwiceIsWarnedOf) {
  const std::string domain = "(defdomain d ((:operator (!a) () () ())))\n";
  const std::string problem = "(defproblem p d () ((!a)))\n";

  const Done done = plan(standard_input(), {}, domain + domain + problem + problem);

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.err, HasSubstr("-:2:1: warning: a second domain 'd'"));
  EXPECT_THAT(done.err, HasSubstr("-:4:1: warning: a second problem 'p'"));
}

TEST(BadInput, OfAnArityThatNeverIsThereIsWarnedOf) {
  const Done done = plan(standard_input(), {},
                         "(defdomain d ((:operator (!a ?x) ((at ?x) (on ?x)) ((at ?x)) ())))"
                         "(defproblem p d ((at k place) (on k)) ((!a k)))");

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.err, HasSubstr("(at …) with 1 argument is never provided; expected 2"));
  EXPECT_THAT(done.err, Not(HasSubstr("(on …)")));
}

TEST(BadInput, AFactOfAnArityThatIsNeverAskedForIsWarnedOf) {
  const std::string domain =
      "(defdomain d ((:operator (!a ?x) ((at ?x) (or (on ?x) (on ?x ?x))) ((at ?x)) ())))";

  const Done odd =
      plan(standard_input(), {},
           domain + "(defproblem p d ((at k) (at k here now) (on k) (on k k)) ((!a k)))");
  EXPECT_EQ(odd.code, 0);
  EXPECT_THAT(odd.err, HasSubstr("(at …) with 3 arguments is never asked for; expected 1"));
  EXPECT_THAT(odd.err, Not(HasSubstr("(on …)")));

  const Done even =
      plan(standard_input(), {}, domain + "(defproblem p d ((at k) (on k)) ((!a k)))");
  EXPECT_THAT(even.err, Not(HasSubstr("is never asked for")));
}

TEST(BadInput, OfAStringForACostIsWarnedOf) {
  const Done done = plan(standard_input(), {},
                         "(defdomain d ((:operator (!a) () () () \"5\")))"
                         "(defproblem p d () ((!a)))");

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(done.err, HasSubstr("a string for a cost"));
}

// --- memory
// ----------------------------------------------------------------------------------------

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

double memory_in_use_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmSize:" && status >> kilobytes) return kilobytes * 1024e-6;
  }
  return 0;
}

// What a process does that may have only so much more memory; for a process of its own.
[[noreturn]] void plan_with_little_memory(const PlanOptions& options, const std::string& text,
                                          double more_mb) {
  rlimit limit{};
  limit.rlim_cur = limit.rlim_max = static_cast<rlim_t>((memory_in_use_mb() + more_mb) * 1e6);
  setrlimit(RLIMIT_AS, &limit);
  const Done done = plan(options, {}, text);
  std::fputs((done.out + done.err).c_str(), stderr);
  std::_Exit(done.code);
}

TEST(BadInputDeathTest, ThatTakesAllMemoryWhilePlanningEndsWithThatLimit) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer needs the memory itself";
  const std::string growing =
      "(defdomain d ((:operator (!grow) () () () 0) (:method (grow ?x) () ((!grow) (grow (s "
      "?x))))))"
      "(defproblem p d () ((grow z))) (defproblem q d () ((grow z)))";

  EXPECT_EXIT(plan_with_little_memory(standard_input(), growing, 60), testing::ExitedWithCode(4),
              "p \\(d\\): cut: memory");
}

TEST(BadInputDeathTest, ThatTakesAllMemoryWhileReadingEndsWithThatLimit) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer needs the memory itself";
  EXPECT_EXIT(plan_with_little_memory(standard_input(), repeated("(a b) ", 8'000'000), 200),
              testing::ExitedWithCode(4), "out of memory");
}

// --- plans to check
// ---------------------------------------------------------------------------------

Done validate(const std::string& plans, const std::string& tasks = "((two))") {
  const File domain("domain",
                    "(defdomain d ((:operator (!a ?x) () () ((done ?x))) "
                    "(:method (two) () ((!a 1) (!a 2))) (:method (loop) () ((loop)))))"
                    "(defproblem p d () " +
                        tasks + ")");
  const File file("plans", plans);
  PlanOptions options;
  options.files = {domain.path()};
  options.validate = file.path();
  return plan(options);
}

TEST(BadPlan, ThatIsAnEmptyFileIsNoPlan) {
  for (const char* nothing : {"", "\n", "; only a comment\n"}) {
    const Done done = validate(nothing);
    EXPECT_EQ(done.code, 2);
    EXPECT_THAT(done.err, HasSubstr("there is no plan in it"));
  }
}

TEST(BadPlan, WithoutATreeMustAccomplishTheTasksAllTheSame) {
  EXPECT_THAT(validate("(!a 1)\n(!a 2)\n").out,
              HasSubstr("p: valid: 2 steps, cost 2.0, tree checked"));
  for (const char* other : {"(!a 1)", "(!a 2) (!a 1)", "(!a 1) (!a 2) (!a 2)", "(!a 7)",
                            "{\"problem\":\"p\",\"plans\":[{\"steps\":[]}]}"}) {
    const Done done = validate(other);
    EXPECT_EQ(done.code, 1) << other;
    EXPECT_THAT(done.out, HasSubstr("no decomposition of the problem's tasks yields them"));
  }
  EXPECT_EQ(validate("{\"problem\":\"p\",\"plans\":[{\"steps\":[]}]}", "()").code, 0);
}

TEST(BadPlan, IsUndecidedWhereTheTasksRecurForEver) {
  const Done done = validate("(!a 1)", "((loop))");

  EXPECT_EQ(done.code, 4);
  EXPECT_THAT(done.out, HasSubstr("whether they accomplish the tasks is not known: expansions"));
}

TEST(BadPlan, NestedWithoutEndIsRefused) {
  const Done done = validate("{\"problem\":\"p\",\"plans\":" + std::string(1'000'000, '[') + "}");

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("nested more than 2000 deep"));
}

}  // namespace
}  // namespace skein::plan_tool
