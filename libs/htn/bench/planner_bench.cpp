// SPDX-License-Identifier: Apache-2.0
// What a step of a plan costs as problems grow: blocks, deliveries, and a recursion without
// choices.
#include <benchmark/benchmark.h>

#include <numeric>
#include <string>
#include <vector>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/random.hpp"
#include "skein/htn/planner.hpp"

namespace {

using namespace skein;       // NOLINT(google-build-using-namespace): a program of one file
using namespace skein::htn;  // NOLINT(google-build-using-namespace)

// All blocks are put on the table, then the towers are built from below.
constexpr const char* kBlocks = R"(
(defdomain towers
  ((:operator (!to-table ?x ?y) ((on ?x ?y)) ((on ?x ?y) (loaded ?x)) ((on ?x table)))
   (:operator (!stack ?x ?y) ((on ?x table)) ((on ?x table) (growing ?y)) ((on ?x ?y) (growing ?x)))
   (:operator (!!add ?fact) () () (?fact) 0)
   (:operator (!!delete ?fact) () (?fact) () 0)
   (:method (clear-all)
     one-more (:first (loaded ?x) (on ?x ?y)) ((!to-table ?x ?y) (note ?y) (clear-all))
     all-down () ())
   (:method (note ?y)
     stands-on-table ((on ?y table)) ()
     loaded () ((!!add (loaded ?y))))
   (:method (build)
     higher (:first (growing ?y) (wanted ?x ?y)) ((!stack ?x ?y) (build))
     high-enough (:first (growing ?y)) ((!!delete (growing ?y)) (build))
     built () ())))
)";

constexpr const char* kDeliveries = R"(
(defdomain deliveries
  ((:operator (!drive ?t ?a ?b) ((at ?t ?a)) ((at ?t ?a)) ((at ?t ?b)))
   (:operator (!load ?p ?t ?a) ((at ?p ?a) (at ?t ?a)) ((at ?p ?a)) ((in ?p ?t)))
   (:operator (!unload ?p ?t ?a) ((in ?p ?t) (at ?t ?a)) ((in ?p ?t)) ((at ?p ?a)))
   (:method (go ?t ?a) there ((at ?t ?a)) () elsewhere ((at ?t ?b)) ((!drive ?t ?b ?a)))
   (:method (deliver ?p ?b)
     by-truck ((at ?p ?a) (truck ?t))
     ((:immediate go ?t ?a) (:immediate !load ?p ?t ?a) (:immediate go ?t ?b)
      (:immediate !unload ?p ?t ?b)))))
)";

constexpr const char* kCount = R"(
(defdomain count
  ((:operator (!tick ?n ?m) ((left ?n)) ((left ?n)) ((left ?m)))
   (:method (run) done ((left 0)) () more ((left ?n) (assign ?m (- ?n 1))) ((!tick ?n ?m) (run)))))
)";

std::vector<std::vector<std::int64_t>> towers(std::int64_t blocks, Random& random) {
  std::vector<std::int64_t> rest(static_cast<std::size_t>(blocks));
  std::iota(rest.begin(), rest.end(), 1);
  for (std::size_t at = rest.size(); at > 1; --at) std::swap(rest[at - 1], rest[random.below(at)]);
  std::vector<std::vector<std::int64_t>> out;
  for (const std::int64_t block : rest) {
    if (out.empty() || random.chance(0.05)) out.emplace_back();
    out.back().push_back(block);
  }
  return out;
}

std::string block(std::int64_t number) { return "b" + std::to_string(number); }

std::string blocks_problem(std::int64_t size) {
  Random random(7);
  std::string facts;
  for (const auto& tower : towers(size, random)) {
    facts += "(on " + block(tower.front()) + " table)";
    for (std::size_t at = 1; at < tower.size(); ++at) {
      facts += "(on " + block(tower[at]) + " " + block(tower[at - 1]) + ")";
    }
    if (tower.size() > 1) facts += "(loaded " + block(tower.back()) + ")";
  }
  for (const auto& tower : towers(size, random)) {
    facts += "(growing " + block(tower.front()) + ")\n";
    for (std::size_t at = 1; at < tower.size(); ++at) {
      facts += "(wanted " + block(tower[at]) + " " + block(tower[at - 1]) + ")";
    }
  }
  return "(defproblem p towers (" + facts + ") ((clear-all) (build)))";
}

std::string deliveries_problem(std::int64_t size) {
  Random random(7);
  std::string facts = "(truck t1)(truck t2)(truck t3)(at t1 c0)(at t2 c1)(at t3 c2)";
  std::string tasks;
  for (std::int64_t parcel = 0; parcel < size; ++parcel) {
    const std::string name = "p" + std::to_string(parcel);
    facts += "(at " + name + " c" + std::to_string(random.below(20)) + ")\n";
    tasks += "(deliver " + name + " c" + std::to_string(random.below(20)) + ")\n";
  }
  return "(defproblem p deliveries (" + facts + ") (:unordered " + tasks + "))";
}

std::string count_problem(std::int64_t size) {
  return "(defproblem p count ((left " + std::to_string(size) + ")) ((run)))";
}

void plan_first(benchmark::State& state, const char* domain_text,
                std::string (*problem_text)(std::int64_t)) {
  TermStore store;
  Definitions definitions;
  Diagnostics errors;
  Diagnostics warnings;
  read_definitions({"bench", domain_text + problem_text(state.range(0))}, store, {}, definitions,
                   errors, warnings);
  SKEIN_ENSURES(errors.empty());
  const Functions none;
  const auto domain =
      Domain::compile(definitions.domains.front(), definitions.functions, none, store, errors);
  const Problem problem = make_problem(definitions.problems.front(), store);
  std::size_t steps = 0;
  for ([[maybe_unused]] auto round : state) {
    const Outcome outcome = plan(*domain, problem, {});
    SKEIN_ENSURES(outcome.verdict == Verdict::kPlan);
    steps = outcome.plans.front().steps.size();
  }
  state.SetComplexityN(static_cast<std::int64_t>(steps));
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["per_step"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(plan_first, blocks, kBlocks, blocks_problem)
    ->RangeMultiplier(2)
    ->Range(250, 16'000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_first, deliveries, kDeliveries, deliveries_problem)
    ->RangeMultiplier(2)
    ->Range(250, 8'000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_first, count, kCount, count_problem)
    ->RangeMultiplier(10)
    ->Range(1'000, 1'000'000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
