// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/planner.hpp"

#include <algorithm>
#include <new>

#include "search/search.hpp"

namespace skein::htn {

namespace {

bool deepens(Which which) { return which == Which::kIdFirst || which == Which::kIdAll; }

/// Runs one search, or one for each depth, and puts the outcome together.
class Planning {
 public:
  Planning(const Domain& domain, const Problem& problem, const Options& options, const Host& host)
      : domain_(domain),
        problem_(problem),
        options_(options),
        host_(host),
        budget_(options.limits, host, [this] { return search_ ? search_->memory_bytes() : 0; }) {}

  Outcome run() {
    Outcome outcome;
    try {
      deepens(options_.which) ? run_deepening() : run_once(options_);
    } catch (const std::bad_alloc&) {
      outcome.out_of_memory = true;
      keep_what_was_found();
    }
    outcome.plans = std::move(plans_);
    outcome.statistics = {budget_.expansions(), budget_.inferences(), deepest_,
                          std::max<std::uint64_t>(budget_.greatest_memory(), memory_)};
    outcome.why = budget_.why();
    outcome.verdict = verdict(outcome);
    outcome.repeats_left_out = repeats_;
    if (outcome.verdict == Verdict::kNoPlan && too_costly_ && options_.cost_limit) {
      outcome.why = "none costs " + to_text(real(*options_.cost_limit)) + " or less";
    }
    if (options_.explain_failure && outcome.plans.empty()) explain_outcome(outcome);
    return outcome;
  }

 private:
  void run_once(const Options& options) {
    start(options);
    search_->run({}, budget_);
    finish();
    // Costs below zero were met after pruning had begun: the bound proves nothing then.
    if (options.which == Which::kBest && search_->course().negative_cost && !budget_.stopped()) {
      Options exhaustive = options;
      exhaustive.which = Which::kAll;
      std::vector<Plan> bounded = std::move(plans_);
      start(exhaustive);
      search_->run({}, budget_);
      finish();
      put_before(std::move(bounded));
      keep_cheapest();
    }
  }

  void run_deepening() {
    std::optional<std::uint64_t> known;
    Options round = options_;
    for (std::uint64_t cutoff = 1; !budget_.stopped(); ++cutoff) {
      const std::uint64_t before = budget_.expansions();
      if (round.limits.plans) round.limits.plans = *options_.limits.plans - plans_.size();
      start(round);
      search_->run({cutoff, known}, budget_);
      std::vector<Plan> earlier = std::move(plans_);
      finish();
      deepest_failure_.expansion -= std::min(before, deepest_failure_.expansion);
      put_before(std::move(earlier));
      const bool enough = options_.limits.plans && plans_.size() >= *options_.limits.plans;
      const bool first = options_.which == Which::kIdFirst && !plans_.empty();
      const bool deepest = options_.limits.depth && cutoff > *options_.limits.depth;
      if (enough || first || deepest || !search_->course().cut_by_depth) return;
      known = cutoff;
    }
  }

  void put_before(std::vector<Plan> earlier) {
    plans_.insert(plans_.begin(), std::make_move_iterator(earlier.begin()),
                  std::make_move_iterator(earlier.end()));
  }

  void start(const Options& options) {
    search_.reset();
    search_.emplace(domain_, problem_, options, host_);
  }

  void finish() {
    plans_ = std::move(search_->plans);
    deepest_ = std::max(deepest_, search_->course().deepest);
    cut_by_depth_ = search_->course().cut_by_depth;
    memory_ = std::max<std::uint64_t>(memory_, search_->memory_bytes());
    deepest_failure_ = search_->course().deepest_failure;
    too_costly_ = too_costly_ || search_->course().too_costly;
    repeats_ += search_->repeats();
    if (options_.explain_failure && plans_.empty()) standing_ = search_->standing();
  }

  // The search gives its memory back before anything else is done.
  void keep_what_was_found() {
    budget_.stop("memory");
    std::vector<Plan> last = search_ ? std::move(search_->plans) : std::vector<Plan>{};
    deepest_ = search_ ? std::max(deepest_, search_->course().deepest) : deepest_;
    search_.reset();
    plans_.insert(plans_.end(), std::make_move_iterator(last.begin()),
                  std::make_move_iterator(last.end()));
  }

  void keep_cheapest() {
    const auto cheapest = std::min_element(
        plans_.begin(), plans_.end(),
        [](const Plan& left, const Plan& right) { return less_value(left.cost, right.cost); });
    if (cheapest != plans_.end()) plans_ = {std::move(*cheapest)};
  }

  Verdict verdict(Outcome& outcome) const {
    if (budget_.error()) return Verdict::kError;
    if (budget_.stopped()) return Verdict::kLimit;
    if (!outcome.plans.empty()) return Verdict::kPlan;
    if (!cut_by_depth_ || !options_.limits.depth) return Verdict::kNoPlan;
    outcome.why = "depth";
    return Verdict::kLimit;
  }

  // A search that the host has ended, or that has no memory left, is not begun again.
  void explain_outcome(Outcome& outcome) {
    const bool cut = outcome.verdict == Verdict::kLimit;
    if (outcome.verdict != Verdict::kNoPlan && !cut) return;
    if (cut) outcome.standing = std::move(standing_);
    const bool again = !cut || (outcome.why != "cancelled" && outcome.why != "memory");
    if (again && deepest_failure_.expansion > 0) outcome.failure = explain(cut);
  }

  // The same search again up to the point where it had come furthest.
  std::optional<FailurePoint> explain(bool cut) {
    Options again = options_;
    if (deepens(again.which)) again.which = Which::kFirst;
    again.limits = {};
    again.limits.depth = options_.limits.depth;
    again.limits.seconds = options_.limits.seconds;
    again.limits.memory_bytes = options_.limits.memory_bytes;
    Host silent;
    silent.cpu_seconds = host_.cpu_seconds;
    if (cut) silent.cancelled = host_.cancelled;  // what is over stays over
    Budget budget(again.limits, silent, [] { return std::size_t{0}; });
    Search search(domain_, problem_, again, silent);
    search.explain_at(deepest_failure_);
    search.run({}, budget);
    return search.failure();
  }

  const Domain& domain_;
  const Problem& problem_;
  const Options& options_;
  const Host& host_;
  std::optional<Search> search_;
  Budget budget_;
  std::vector<Plan> plans_;
  std::uint64_t deepest_ = 0;
  std::uint64_t memory_ = 0;
  bool cut_by_depth_ = false;
  DeepestPoint deepest_failure_;
  bool too_costly_ = false;
  std::uint64_t repeats_ = 0;
  std::optional<FailurePoint> standing_;
};

}  // namespace

Outcome plan(const Domain& domain, const Problem& problem, const Options& options,
             const Host& host) {
  return Planning(domain, problem, options, host).run();
}

}  // namespace skein::htn
