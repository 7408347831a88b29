// SPDX-License-Identifier: Apache-2.0
// Laws of plan repair on random small domains, with the validator as judge.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"
#include "testing/random_domain.hpp"
#include "testing/repair_fixture.hpp"

namespace skein::htn {
namespace {

using testing::RepairFixture;

constexpr std::uint64_t kSeeds = 100'000;

Limits small_search() {
  Limits limits;
  limits.expansions = 3'000;
  limits.inferences = 200'000;
  limits.depth = 60;
  return limits;
}

RepairOptions small_repair() {
  RepairOptions options;
  options.limits = small_search();
  return options;
}

/// Facts the plan rests on are lost, others come about.
std::vector<Change> changes(RepairFixture& fixture, Random& random) {
  std::vector<Term> known = fixture.problem().facts;
  for (const TreeNode& node : fixture.plan().tree) {
    for (const CausalLink& link : node.support) known.push_back(link.fact);
  }
  std::vector<Change> out;
  for (std::uint64_t many = 1 + random.below(2); many > 0; --many) {
    const Term fact = known[random.below(known.size())];
    const bool negated = fixture.store().car(fact) == fixture.store().symbol("not");
    // The facts k alone keep the axiom `path` from running in circles.
    if (fixture.store().car(fact) == fixture.store().symbol("k")) continue;
    const Term atom = negated ? fixture.store().car(fixture.store().cdr(fact)) : fact;
    out.push_back({negated || random.chance(0.2), atom});
  }
  return out;
}

RC_GTEST_PROP(Repair, KeepsThePrefixAndValidates, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, kSeeds);
  const std::string text = oracle::random_domain(seed);
  // A tree shows what such a variable was bound to in the end, not that it was free when the task
  // was reduced: the validator cannot tell.
  RC_PRE(text.find("?free") == std::string::npos);
  RepairFixture fixture(text);
  RC_PRE(!fixture.make_plan(small_search()).tree.empty());
  RC_PRE(fixture.plan_fault() == "");
  Random random(seed, "divergence");
  const auto executed = static_cast<StepIndex>(random.below(fixture.plan().steps.size() + 1));
  fixture.diverge(executed, changes(fixture, random));

  const Repair& repair = fixture.repair(executed, small_repair());

  RC_TAG(static_cast<int>(repair.verdict));
  if (repair.plan.tree.empty()) return;
  RC_LOG() << "seed " << seed << " executed " << executed << " " << fixture.describe();
  RC_ASSERT(fixture.fault(false) == "");
  // Planner and validator do not always list the values of setof and bagof in the same order.
  const bool lists =
      text.find("setof") != std::string::npos || text.find("bagof") != std::string::npos;
  if (!lists) RC_ASSERT(fixture.fault() == "");
  const std::size_t ahead = fixture.plan().steps.size() - executed;
  RC_ASSERT(repair.kept.size() + repair.dropped.size() == ahead);
  RC_ASSERT(repair.kept.size() + repair.added.size() == repair.plan.steps.size() - executed);
}

RC_GTEST_PROP(Repair, APlanStandsAfterAChangeThatNothingAsksFor, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, kSeeds);
  RepairFixture fixture(oracle::random_domain(seed));
  RC_PRE(!fixture.make_plan(small_search()).tree.empty());
  // The steps alone do not always say what they did: variables they share may have been unbound,
  // and which satisfier an operator takes first may depend on where the search had been before.
  const auto all = static_cast<StepIndex>(fixture.plan().steps.size());
  RC_PRE(fixture.repair(all, small_repair()).verdict != RepairVerdict::kError);
  const auto executed =
      static_cast<StepIndex>(*rc::gen::inRange<std::size_t>(0, fixture.plan().steps.size() + 1));
  fixture.diverge(executed, std::vector<std::string>{"(irrelevant)"});

  const Repair& repair = fixture.repair(executed, small_repair());

  RC_LOG() << "seed " << seed << " executed " << executed << " " << fixture.describe();
  if (repair.verdict == RepairVerdict::kLimit) return;
  RC_ASSERT(repair.verdict == RepairVerdict::kStands);
  RC_ASSERT(fixture.actions(repair.plan).size() == fixture.plan().steps.size());
}

}  // namespace
}  // namespace skein::htn
