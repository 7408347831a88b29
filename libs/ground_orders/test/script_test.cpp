// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a script in itself.
#include "skein/ground_orders/script.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>

namespace skein::ground_station {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Trigger when(decltype(Trigger::what) what) { return Trigger{std::move(what)}; }

Step a_step(const std::string& name, Trigger trigger) {
  Step step;
  step.name = name;
  step.when = std::move(trigger);
  return step;
}

TEST(Script, EveryProblemIsReportedAtOnce) {
  Script script;
  script.steps = {a_step("one", when(OnStep{"non"})), a_step("one", when(AnyOf{})),
                  a_step("", when(AllOf{}))};
  script.steps[2].after = Duration::seconds(-1);
  script.steps.push_back(a_step("three", when(OnExpired{"tree"})));
  script.steps.push_back(a_step("four", when(OnSilence{"marvin", Duration()})));
  script.operators = {{"end", when(AllOf{{when(OnStep{"two"})}}), Duration::seconds(-1), {}}};
  script.command_lifetime = Duration();

  EXPECT_THAT(
      problems_of(script),
      ElementsAre("two steps are named 'one'", "a step has no name",
                  "step 'one' waits for unknown step 'non'", "step 'one' waits for one of nothing",
                  "step '' has a negative delay", "step 'three' waits for unknown step 'tree'",
                  "step 'four' waits for 'marvin' to be silent for no time",
                  "operator action 'end' waits for unknown step 'two'",
                  "operator action 'end' has a negative delay",
                  "the lifetime of commands must be positive"));
}

TEST(Script, AnEmptyOneIsFine) { EXPECT_THAT(problems_of(Script()), IsEmpty()); }

TEST(Script, AnOperatorMayActWithoutBeingWrittenDown) {
  Script script;
  script.steps = {a_step("one", when(OnOperator{"whatever he likes"}))};

  EXPECT_THAT(problems_of(script), IsEmpty());
}

TEST(Script, WhoAskedForWhatAStepDoesIsTheStep) { EXPECT_EQ(asked_by_step("gone"), "step gone"); }

// ---- drawn at random, against a count of our own ----

/// Names of steps that a trigger waits for, some of which are there; how deep it may nest.
Trigger any_trigger(const std::vector<std::string>& names, int depth) {
  const std::string name = *rc::gen::elementOf(names);
  switch (*rc::gen::inRange(0, depth > 0 ? 5 : 3)) {
    case 0:
      return when(AtTime{MissionTime::seconds(1)});
    case 1:
      return when(OnStep{name});
    case 2:
      return when(OnExpired{name});
    default:
      break;
  }
  std::vector<Trigger> of;
  const int count = *rc::gen::inRange(0, 3);
  for (int i = 0; i < count; ++i) of.push_back(any_trigger(names, depth - 1));
  return *rc::gen::arbitrary<bool>() ? when(AllOf{of}) : when(AnyOf{of});
}

/// How often a trigger waits for a step that is not there, or for one of nothing.
std::size_t faults_of(const Trigger& trigger, const std::set<std::string>& known) {
  const auto sum = [&](const std::vector<Trigger>& of) {
    std::size_t count = 0;
    for (const Trigger& one : of) count += faults_of(one, known);
    return count;
  };
  if (const auto* on = std::get_if<OnStep>(&trigger.what)) return known.contains(on->step) ? 0 : 1;
  if (const auto* on = std::get_if<OnExpired>(&trigger.what))
    return known.contains(on->step) ? 0 : 1;
  if (const auto* all = std::get_if<AllOf>(&trigger.what)) return sum(all->of);
  if (const auto* any = std::get_if<AnyOf>(&trigger.what))
    return sum(any->of) + (any->of.empty() ? 1 : 0);
  return 0;
}

RC_GTEST_PROP(Script, HasAsManyProblemsAsWereBuiltIn, ()) {
  const std::vector<std::string> names{"a", "b", "c", "d"};
  Script script;
  std::set<std::string> known;
  std::size_t expected = 0;
  const int count = *rc::gen::inRange(0, 5);
  for (int i = 0; i < count; ++i) {
    script.steps.push_back(a_step(*rc::gen::elementOf(names), any_trigger(names, 3)));
    script.steps.back().after = Duration::seconds(*rc::gen::inRange(-1, 2));
    expected += known.insert(script.steps.back().name).second ? 0 : 1;
    expected += script.steps.back().after < Duration() ? 1 : 0;
  }
  for (const Step& step : script.steps) expected += faults_of(step.when, known);

  RC_ASSERT(problems_of(script).size() == expected);
}

}  // namespace
}  // namespace skein::ground_station
