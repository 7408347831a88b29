// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/check_automaton.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <memory>

#include "possibilities.hpp"
#include "skein/interaction/engine.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "testing/random_automaton.hpp"

namespace skein::interaction {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string problems_in(const std::string& text) {
  const auto automaton = read_automaton(text, "a.yaml");
  EXPECT_TRUE(automaton) << (automaton ? "" : to_text(automaton.error()));
  Diagnostics problems;
  if (automaton) check_automaton(*automaton, "a.yaml", problems);
  return to_text(problems);
}

TEST(CheckAutomaton, FindsNothingInASoundOne) {
  EXPECT_EQ(problems_in(R"(
block: b
exit: [[{message: interruption}]]
content:
  - {task: t, type: goto}
  - {block: c, type: loop, pre: [[{componel: t, state: ended}]], exit: [[{componel: u, state: ended}]],
     content: [{task: u, type: goto}, {block: d, pre: [[{message: go}]], content: [{task: v, type: goto}]}]}
  - {block: e, pre: [[{componel: c, state: over}]], content: [{task: w, type: goto}]})"),
            "");
}

TEST(CheckAutomaton, BlocksThatWaitForEachOtherAreNeverActivated) {
  EXPECT_THAT(problems_in(R"(
block: b
content:
  - {task: t, type: goto}
  - {block: c, pre: [[{componel: d, state: ended}]], content: [{task: u, type: goto}]}
  - {block: d, pre: [[{componel: c, state: ended}]], content: [{task: v, type: goto}]})"),
              AllOf(HasSubstr("a.yaml:5: content[1].pre: the block 'c' can never be activated"),
                    HasSubstr("the block 'd' can never be activated")));
}

TEST(CheckAutomaton, ALoopNeverIsEndedAndTheRemedyIsOver) {
  EXPECT_THAT(problems_in(R"(
block: b
content:
  - {block: c, type: loop, exit: [[{message: stop}]], content: [{task: u, type: goto}]}
  - {block: d, pre: [[{componel: c, state: ended}]], content: [{task: v, type: goto}]})"),
              AllOf(HasSubstr("content[1].pre[0][0]: this can never hold: 'c' is a loop"),
                    HasSubstr("expected state: over")));
}

TEST(CheckAutomaton, ConditionsOnOneselfOnWhatIsAroundAndInsideNeverHold) {
  const std::string problems = problems_in(R"(
block: b
content:
  - {block: c, pre: [[{componel: c, state: running}]], content: [{task: t, type: goto}]}
  - {block: d, pre: [[{componel: b, state: ended}]], content: [{task: u, type: goto}]}
  - {block: e, pre: [[{componel: v, state: running}]], content: [{task: v, type: goto}]})");

  EXPECT_THAT(problems, AllOf(HasSubstr("it is about the block itself"),
                              HasSubstr("'b' is around it and running then"),
                              HasSubstr("'v' is inside the block and has no state before")));
}

TEST(CheckAutomaton, ClausesThatExcludeEachOtherNeverHoldTogether) {
  EXPECT_THAT(problems_in(R"(
block: b
content:
  - {task: t, type: goto}
  - {block: c, pre: [[{componel: t, state: ended}], [{componel: t, state: aborted}]], content: [{task: u, type: goto}]})"),
              HasSubstr("content[1].pre: its clauses can never be true together"));
  EXPECT_THAT(problems_in("{block: b, exit: [[{time: 9, is: passed}], [{time: 5, is: "
                          "not-yet-passed}]], content: [{task: t, type: goto}]}"),
              HasSubstr("exit: its clauses can never be true together"));
  EXPECT_EQ(problems_in("{block: b, exit: [[{time: 5, is: passed}], [{time: 9, is: "
                        "not-yet-passed}]], content: [{task: t, type: goto}]}"),
            "");
}

TEST(CheckAutomaton, AClauseWithoutLiteralsIsTold) {
  EXPECT_THAT(problems_in("{block: b, exit: [[]], content: [{task: t, type: goto}]}"),
              HasSubstr("exit: a clause without literals can never be true"));
}

constexpr const char* kLoop = R"(
block: b
MAIN
content:
  - {block: c, type: loop, content: [{task: t, type: goto}]}
  - {block: d, OTHER content: [{task: u, type: goto}]})";

std::string loop_with(const std::string& main, const std::string& other) {
  std::string text = kLoop;
  text.replace(text.find("MAIN"), 4, main);
  return text.replace(text.find("OTHER"), 5, other);
}

TEST(CheckAutomaton, ALoopWithoutAWayOutIsTold) {
  const std::string problem = "content[0].exit: the loop 'c' has no way out";

  EXPECT_THAT(problems_in(loop_with("", "")), HasSubstr(problem));
  EXPECT_THAT(problems_in(loop_with("exit: [[{message: interruption}]]", "")), HasSubstr(problem))
      << "an interruption is no way out";
  EXPECT_EQ(problems_in(loop_with("exit: [[{time: 900, since: start, is: passed}]]", "")), "");
  EXPECT_EQ(problems_in(loop_with("", "end: immediate,")), "");
}

TEST(CheckAutomaton, ABlockThatWaitsForTheEndOfALoopDoesNotEndIt) {
  const char* waits = "end: immediate, pre: [[{componel: c, state: over}]],";
  const char* may_wait = "end: immediate, pre: [[{componel: c, state: over}, {message: m}]],";

  EXPECT_THAT(problems_in(loop_with("", waits)), HasSubstr("the loop 'c' has no way out"));
  EXPECT_EQ(problems_in(loop_with("", may_wait)), "");
  EXPECT_EQ(problems_in(loop_with("", "end: immediate, pre: [[{componel: t, state: ended}]],")),
            "");
}

TEST(CheckAutomaton, AnExitThatWaitsForWhatComesAfterTheLoopIsNoWayOut) {
  const auto with_exit = [](const std::string& exit, const std::string& waits_for) {
    return "block: b\ncontent:\n  - {block: c, type: loop, exit: [[" + exit +
           "]], content: [{task: t, type: goto}]}\n"
           "  - {block: d, pre: [[{componel: c, state: over}" +
           waits_for +
           "]], content: [{task: u, type: goto}, {block: f, content: [{task: v, type: goto}]}]}\n"
           "  - {block: e, pre: [[{componel: u, state: ended}]], content: [{task: w, type: goto}]}";
  };
  const std::string problem = "content[0].exit: the loop 'c' has no way out";

  EXPECT_THAT(problems_in(with_exit("{componel: d, state: ended}", "")), HasSubstr(problem));
  EXPECT_THAT(problems_in(with_exit("{componel: v, state: running}", "")), HasSubstr(problem));
  EXPECT_THAT(problems_in(with_exit("{componel: e, state: running}", "")), HasSubstr(problem))
      << "in a roundabout way";
  EXPECT_THAT(problems_in(with_exit("{time: 5, since: \"u:running\", is: passed}", "")),
              HasSubstr(problem));
  EXPECT_EQ(problems_in(with_exit("{componel: d, state: ended}", ", {message: m}")), "");
}

TEST(CheckAutomaton, ALoopInALoopThatBeginsAnewIsLeftByThat) {
  EXPECT_EQ(
      problems_in(
          "block: b\ncontent:\n"
          "  - block: c\n    type: loop\n    exit: [[{componel: d, state: ended}]]\n"
          "    content:\n"
          "      - {block: f, type: loop, content: [{task: t, type: goto}]}\n"
          "      - {block: g, end: immediate, content: [{task: u, type: goto}]}\n"
          "  - {block: d, pre: [[{componel: f, state: over}]], content: [{task: v, type: goto}]}"),
      "");
}

TEST(CheckAutomaton, AnExitThatOnlyContinuesIsNoWayOut) {
  EXPECT_THAT(
      problems_in("{block: b, type: loop, exit: [[{message: m, effect: continue}]], content: "
                  "[{task: t, type: goto}]}"),
      HasSubstr("the loop 'b' has no way out"));
}

// Whatever an engine does is among what is held possible.
RC_GTEST_PROP(Possibilities, HoldEverythingThatHappens, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto automaton = std::make_shared<const Automaton>(testing::RandomAutomaton(seed).make());
  const Possibilities possible(*automaton);
  Engine engine(automaton);

  for (const auto& [at, input] : testing::random_trace(*automaton, seed, 80)) {
    const auto effects = engine.handle(input, at).value_or(Effects{});
    for (const Effect& effect : effects) {
      const auto* change = std::get_if<StateChanged>(&effect.what);
      if (change == nullptr) continue;
      const ComponelIndex index = *automaton->find(change->componel);
      for (const AskedState asked :
           {AskedState::kScheduled, AskedState::kRunning, AskedState::kAborting,
            AskedState::kAborted, AskedState::kEnded, AskedState::kOver}) {
        RC_ASSERT((!is_in(change->state, asked) || possible.reaches(index, asked)));
      }
    }
  }
}

}  // namespace
}  // namespace skein::interaction
