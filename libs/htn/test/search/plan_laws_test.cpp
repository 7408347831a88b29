// SPDX-License-Identifier: Apache-2.0
// Laws of all plans of drawn domains: what they say of themselves, where limits cut, what is
// followed, preferred and relived.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "skein/htn/aftermath.hpp"
#include "testing/plan_checker.hpp"
#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::Case;
using test::NaiveDomain;
using test::PlanChecker;
using Plans = std::vector<std::string>;

/// A domain and a state that nobody chose, in which t0 is to be done.
struct Drawn {
  NaiveDomain domain = NaiveDomain::drawn();
  unsigned facts = *rc::gen::inRange(0U, 1U << NaiveDomain::kFacts);
  Case made{domain.items(), NaiveDomain::facts_text(facts), "((t0))"};

  Drawn() {
    made.options.which = Which::kAll;
    made.options.limits.expansions = kMost;
  }
  /// All plans; drawn again when there are too many, or none.
  Outcome all() {
    Outcome outcome = made.run();
    RC_PRE(outcome.verdict == Verdict::kPlan);
    RC_LOG() << domain.items() << NaiveDomain::facts_text(facts);
    return outcome;
  }
  Plans texts(const Outcome& outcome) const {
    Plans out;
    for (const Plan& plan : outcome.plans) out.push_back(made.steps(plan));
    return out;
  }

  static constexpr std::uint64_t kMost = 20'000;
};

// ---- what plans say of themselves ------------------------------------------------------------

RC_GTEST_PROP(PlanLaws, StatesLinksAndTreesAreThoseOfTheSteps, ()) {
  Drawn drawn;
  drawn.made.options.trees = drawn.made.options.states = true;
  const Outcome outcome = drawn.all();
  PlanChecker checker(drawn.domain, drawn.facts, drawn.made.store);

  for (const Plan& plan : outcome.plans) {
    const std::string fault = checker.fault(plan);
    RC_LOG() << drawn.made.steps(plan) << "\n" << fault;
    RC_ASSERT(fault.empty());
  }
}

RC_GTEST_PROP(PlanLaws, TreesAndStatesChangeNoPlan, ()) {
  Drawn drawn;
  const Outcome plain = drawn.all();

  drawn.made.options.trees = drawn.made.options.states = true;
  drawn.made.options.explain_failure = true;
  const Outcome told = drawn.made.run();

  RC_ASSERT(drawn.texts(told) == drawn.texts(plain));
  RC_ASSERT(told.statistics.expansions == plain.statistics.expansions);
  RC_ASSERT(told.statistics.inferences == plain.statistics.inferences);
}

// ---- limits ----------------------------------------------------------------------------------

RC_GTEST_PROP(PlanLaws, ALimitOfExpansionsCutsOnlyWhatLiesBehindIt, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  const Plans all = drawn.texts(whole);
  const std::uint64_t needed = whole.statistics.expansions;
  const auto most = *rc::gen::inRange<std::uint64_t>(1, needed + 2);

  drawn.made.options.limits.expansions = most;
  const Outcome cut = drawn.made.run();

  const Plans found = drawn.texts(cut);
  RC_ASSERT(cut.verdict == (most < needed ? Verdict::kLimit : Verdict::kPlan));
  RC_ASSERT(cut.why == (most < needed ? "expansions" : ""));
  RC_ASSERT(cut.statistics.expansions == std::min(needed, most + 1));
  RC_ASSERT(found.size() <= all.size() && std::equal(found.begin(), found.end(), all.begin()));
}

RC_GTEST_PROP(PlanLaws, ALimitOfInferencesCutsOnlyWhatLiesBehindIt, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  const Plans all = drawn.texts(whole);
  const std::uint64_t needed = whole.statistics.inferences;
  const auto most = *rc::gen::inRange<std::uint64_t>(0, needed + 2);

  drawn.made.options.limits.inferences = most;
  const Outcome cut = drawn.made.run();

  const Plans found = drawn.texts(cut);
  RC_ASSERT(cut.verdict == (most < needed ? Verdict::kLimit : Verdict::kPlan));
  RC_ASSERT(cut.why == (most < needed ? "inferences" : ""));
  RC_ASSERT(found.size() <= all.size() && std::equal(found.begin(), found.end(), all.begin()));
}

RC_GTEST_PROP(PlanLaws, ALimitOfDepthLeavesOutPlansAndChangesNone, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  const std::uint64_t deepest = whole.statistics.deepest;
  Plans rest = drawn.texts(whole);
  const auto most = *rc::gen::inRange<std::uint64_t>(0, deepest + 2);

  drawn.made.options.limits.depth = most;
  const Outcome cut = drawn.made.run();

  RC_ASSERT(cut.statistics.deepest == std::min(deepest, most));
  if (most >= deepest) RC_ASSERT(drawn.texts(cut) == rest);
  if (cut.plans.empty()) RC_ASSERT(cut.verdict == Verdict::kLimit && cut.why == "depth");
  auto at = rest.begin();
  for (const std::string& plan : drawn.texts(cut)) {
    at = std::find(at, rest.end(), plan);
    RC_ASSERT(at++ != rest.end());
  }
}

// ---- depth -----------------------------------------------------------------------------------

/// Reductions and steps along the way to a plan; where a task or a network has no parts, a step was
/// taken that does nothing.
std::uint64_t depth_of(const Plan& plan) {
  std::uint64_t depth = 0;
  for (const TreeNode& node : plan.tree) {
    if (node.kind == TreeNodeKind::kTask || node.kind == TreeNodeKind::kStep) ++depth;
    if (node.kind != TreeNodeKind::kStep && node.children.empty()) ++depth;
  }
  return depth;
}

RC_GTEST_PROP(PlanLaws, ModesOfDepthChooseAmongAllPlansByTheirTrees, ()) {
  Drawn drawn;
  drawn.made.options.trees = true;
  const Outcome whole = drawn.all();
  std::vector<Plan> by_depth = whole.plans;
  std::stable_sort(by_depth.begin(), by_depth.end(), [](const Plan& left, const Plan& right) {
    return depth_of(left) < depth_of(right);
  });
  Plans sorted, shallow;
  for (const Plan& plan : by_depth) {
    sorted.push_back(drawn.made.steps(plan));
    if (depth_of(plan) == depth_of(by_depth.front())) shallow.push_back(sorted.back());
  }
  const auto found = [&](Which which) {
    drawn.made.options.which = which;
    return drawn.texts(drawn.made.run());
  };

  RC_ASSERT(depth_of(by_depth.back()) <= whole.statistics.deepest);
  RC_ASSERT(found(Which::kAllShallowest) == shallow);
  RC_ASSERT(found(Which::kShallowest) == Plans{shallow.front()});
  RC_ASSERT(found(Which::kIdFirst) == Plans{shallow.front()});
  RC_ASSERT(found(Which::kIdAll) == sorted);
}

// ---- what is told while it runs --------------------------------------------------------------

RC_GTEST_PROP(PlanLaws, TheStepsThatAreTracedLeadToEachPlan, ()) {
  Drawn drawn;
  std::vector<std::pair<std::uint64_t, std::string>> taken;  // with the depth where it was taken
  Plans traced;
  drawn.made.host.trace = [&](const TraceEvent& event) {
    const bool step = event.kind == TraceKind::kStep;
    if (!step && event.kind != TraceKind::kReduction) return;
    while (!taken.empty() && taken.back().first >= event.depth) taken.pop_back();
    if (step) taken.emplace_back(event.depth, drawn.made.store.to_text(event.task));
  };
  drawn.made.host.plan_found = [&](const Plan&) {
    std::string steps;
    for (const auto& [depth, step] : taken)
      if (step != "(!!inop)") steps += (steps.empty() ? "" : " ") + step;
    traced.push_back(steps);
  };

  const Outcome outcome = drawn.all();

  RC_ASSERT(traced == drawn.texts(outcome));
}

/// What an attempt says it needs: a fact as a bit, and whether it is to hold; nothing where the
/// task has no condition that could be named.
struct Need {
  unsigned fact = 0;
  bool wanted = true;
};
std::optional<Need> need_of(const std::string& condition) {
  const std::size_t at = condition.find("(f");
  if (at == std::string::npos) return std::nullopt;
  return Need{1U << (condition[at + 2] - '0'), !condition.starts_with("(not")};
}

RC_GTEST_PROP(PlanLaws, AFailureIsADeadEndThatItsStepsLeadTo, ()) {
  Drawn drawn;
  constexpr unsigned kNever = 1U << (NaiveDomain::kFacts - 1);
  drawn.facts &= ~kNever;
  for (auto& taken : drawn.domain.operators) {
    taken.adds &= ~kNever;
    if (*rc::gen::inRange(0, 3) > 0) taken.needs |= kNever;
  }
  for (auto& way : drawn.domain.ways)
    if (way.parts.empty()) way.parts.push_back(-1 - *rc::gen::inRange(0, NaiveDomain::kOperators));
  Case made(drawn.domain.items(), NaiveDomain::facts_text(drawn.facts), "((t0))");
  made.options.explain_failure = true;
  made.options.limits.expansions = Drawn::kMost;
  const Outcome outcome = made.run();
  RC_PRE(outcome.verdict == Verdict::kNoPlan);
  RC_LOG() << drawn.domain.items() << NaiveDomain::facts_text(drawn.facts);
  unsigned facts = drawn.facts;

  RC_ASSERT(outcome.failure.has_value());
  for (const Step& step : outcome.failure->steps) {
    const auto number = static_cast<std::size_t>(made.store.to_text(step.action)[3] - '0');
    const auto& taken = drawn.domain.operators.at(number);
    RC_ASSERT((facts & taken.needs) == taken.needs);
    facts = (facts & ~taken.removes) | taken.adds;
  }
  RC_ASSERT(!outcome.failure->attempts.empty());
  for (const Attempt& attempt : outcome.failure->attempts) {
    RC_ASSERT(attempt.task == outcome.failure->open_tasks.back());
    const std::optional<Need> need = need_of(attempt.condition);
    RC_ASSERT(need.has_value());
    RC_ASSERT(((facts & need->fact) != 0) != need->wanted);
  }
}

// ---- following, preferring -------------------------------------------------------------------

/// Only the plan of exactly these steps.
Following following(const std::vector<Step>& steps) {
  return {steps.size(),
          [steps](std::size_t at, Term action) { return steps[at].action == action; }};
}

RC_GTEST_PROP(PlanLaws, EveryPlanIsFoundByFollowingIt, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  const Plan wanted = *rc::gen::elementOf(whole.plans);

  drawn.made.options.following = following(wanted.steps);

  RC_ASSERT(drawn.made.all().front() == drawn.made.steps(wanted));
  drawn.made.options.which = Which::kFirst;
  RC_ASSERT(drawn.made.first() == drawn.made.steps(wanted));
}

RC_GTEST_PROP(PlanLaws, WhatIsNoPlanIsNotFoundByFollowingIt, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  Plan other = *rc::gen::elementOf(whole.plans);
  if (*rc::gen::arbitrary<bool>() && !other.steps.empty()) {
    other.steps.pop_back();
  } else {
    const int number = *rc::gen::inRange(0, NaiveDomain::kOperators);
    const Term action = drawn.made.term("(!o" + std::to_string(number) + ")");
    other.steps.push_back({action, integer(1), false});
  }
  const Plans all = drawn.texts(whole);
  RC_PRE(std::find(all.begin(), all.end(), drawn.made.steps(other)) == all.end());

  drawn.made.options.following = following(other.steps);

  RC_ASSERT(drawn.made.all() == Plans{"no plan"});
}

/// What the tree of a plan did with its tasks.
std::vector<Preference> preferences_of(const Plan& plan) {
  std::vector<Preference> out;
  for (const TreeNode& node : plan.tree) {
    if (node.kind != TreeNodeKind::kTask) continue;
    Preference made{node.task, node.method, {}, static_cast<std::uint32_t>(out.size())};
    for (const TreeIndex network : node.children)
      for (const TreeIndex part : plan.tree[network].children)
        made.subtasks.push_back(plan.tree[part].task);
    out.push_back(std::move(made));
  }
  return out;
}

RC_GTEST_PROP(PlanLaws, PreferencesChangeTheOrderOfPlansOnly, ()) {
  Drawn drawn;
  drawn.made.options.trees = true;
  const Outcome whole = drawn.all();
  const Plan liked = *rc::gen::elementOf(whole.plans);
  Plans expected = drawn.texts(whole);

  drawn.made.options.preferences = preferences_of(liked);
  Plans found = drawn.texts(drawn.made.run());

  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  RC_ASSERT(found == expected);
}

// ---- the past --------------------------------------------------------------------------------

RC_GTEST_PROP(PlanLaws, ThePastLeavesTheStateThatItsStepsMake, ()) {
  Drawn drawn;
  drawn.made.options.trees = drawn.made.options.states = true;
  const Outcome whole = drawn.all();
  const Plan plan = *rc::gen::elementOf(whole.plans);
  PlanChecker checker(drawn.domain, drawn.facts, drawn.made.store);
  RC_PRE(checker.fault(plan).empty());
  const auto steps = *rc::gen::inRange<std::size_t>(0, plan.steps.size() + 1);
  Problem problem = drawn.made.problem();
  for (std::size_t at = 0; at < steps; ++at)
    problem.past.push_back({Event::Kind::kStep, plan.steps[at].action});

  const Aftermath state(drawn.made.domain(), problem, Limits{});

  RC_ASSERT(state.events() == steps);
  for (int fact = 0; fact < NaiveDomain::kFacts; ++fact) {
    const Term term = drawn.made.term("(f" + std::to_string(fact) + ")");
    RC_ASSERT(state.holds(term) == ((checker.after(steps) >> fact & 1U) != 0));
  }
}

RC_GTEST_PROP(PlanLaws, APlanBehindAPastIsOneFromTheStateItLeaves, ()) {
  Drawn drawn;
  const Outcome whole = drawn.all();
  const Plan plan = *rc::gen::elementOf(whole.plans);
  Problem past = drawn.made.problem();
  for (const Step& step : plan.steps) past.past.push_back({Event::Kind::kStep, step.action});
  Problem fresh = drawn.made.problem();
  fresh.facts = Aftermath(drawn.made.domain(), past, Limits{}).facts();

  const Outcome after = htn::plan(drawn.made.domain(), past, drawn.made.options);
  const Outcome again = htn::plan(drawn.made.domain(), fresh, drawn.made.options);

  Plans expected;
  for (const std::string& more : drawn.texts(again)) {
    const std::string begun = drawn.made.steps(plan);
    expected.push_back(begun + (begun.empty() || more.empty() ? "" : " ") + more);
  }
  RC_ASSERT(drawn.texts(after) == expected);
}

}  // namespace
}  // namespace skein::htn
