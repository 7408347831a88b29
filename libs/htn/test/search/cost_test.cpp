// SPDX-License-Identifier: Apache-2.0
// Which plans are kept where cost counts, against the rules of SHOP3's search loop played on a
// list.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;
using Plans = std::vector<std::string>;

/// A way to go: some equal steps, each at the same cost. Its plan is the deeper the more steps it
/// has.
struct Way {
  int steps = 1;
  int cost = 1;
  int total() const { return steps * cost; }
};

/// A task that may be done in several ways, tried in their order.
class Ways {
 public:
  explicit Ways(std::vector<Way> all) : all_(std::move(all)) {}

  static Ways drawn() {
    std::vector<Way> all(*rc::gen::inRange<std::size_t>(1, 7));
    for (Way& way : all) way = {*rc::gen::inRange(1, 5), *rc::gen::inRange(0, 5)};
    return Ways(std::move(all));
  }

  const std::vector<Way>& all() const { return all_; }
  std::string items() const {
    std::string text;
    for (std::size_t i = 0; i < all_.size(); ++i)
      text +=
          does("(go)", "(" + name(i) + ")") + adds(operation(i), "", std::to_string(all_[i].cost));
    return text;
  }
  /// The steps of the way as a plan shows them.
  std::string name(std::size_t i) const {
    std::string text;
    for (int step = 0; step < all_[i].steps; ++step) text += (step == 0 ? "" : " ") + operation(i);
    return text;
  }
  Plans names(const std::vector<std::size_t>& which) const {
    Plans out;
    for (const std::size_t i : which) out.push_back(name(i));
    return out;
  }

 private:
  static std::string operation(std::size_t i) { return "(!w" + std::to_string(i) + ")"; }
  std::vector<Way> all_;
};

Plans found(const Ways& ways, const Options& options) {
  Case made(ways.items(), "", "((go))");
  made.options = options;
  Plans out;
  for (const Plan& plan : made.run().plans) out.push_back(made.steps(plan));
  return out;
}

Options wanting(Which which) {
  Options options;
  options.which = which;
  return options;
}
Options cheapest(Which which) {
  Options options = wanting(which);
  options.optimize_cost = true;
  return options;
}
Options up_to(double cost, Which which) {
  Options options = wanting(which);
  options.cost_limit = cost;
  return options;
}

/// SHOP3's loop over the plans as they are met: a plan is stored when its cost is acceptable. Where
/// cost counts it replaces what was stored, in every mode (SHOP3 means to keep those of the same
/// cost, but its filter walks a list of states that is empty). Modes of least depth cut what is
/// deeper.
class Loop {
 public:
  explicit Loop(Options options) : options_(std::move(options)) {}

  std::vector<std::size_t> over(const Ways& ways) {
    for (std::size_t i = 0; i < ways.all().size() && !over_; ++i) meet(ways.all(), i);
    return kept_;
  }

 private:
  bool bounded() const { return options_.optimize_cost || options_.cost_limit; }
  bool acceptable(int cost) const {
    if (options_.cost_limit) return cost <= *options_.cost_limit;
    return !options_.optimize_cost || !best_ || cost <= *best_;
  }

  void meet(const std::vector<Way>& all, std::size_t i) {
    const Way& way = all[i];
    if (deepest_ && way.steps > *deepest_) return;
    if (!acceptable(way.total())) return;
    if (options_.which == Which::kFirst && bounded() && best_ == way.total()) return;
    if (bounded()) {
      best_ = best_ ? std::min(*best_, way.total()) : way.total();
      kept_.clear();
    }
    if (options_.which == Which::kShallowest) {
      kept_.clear();
      deepest_ = bounded() ? way.steps : way.steps - 1;
    } else if (options_.which == Which::kAllShallowest) {
      if (deepest_ != way.steps) kept_.clear();
      deepest_ = way.steps;
    }
    kept_.push_back(i);
    over_ = options_.which == Which::kFirst && !goes_on();
  }

  bool goes_on() const {
    if (!bounded()) return false;
    if (*best_ == 0) return false;
    return options_.cost_limit ? *best_ >= *options_.cost_limit : true;
  }

  Options options_;
  std::vector<std::size_t> kept_;
  std::optional<int> best_;
  std::optional<int> deepest_;
  bool over_ = false;
};

// ---- by hand -----------------------------------------------------------------------------------

TEST(SearchCost, OnePlanIsKeptWhereCostCountsAlsoWhereAllAreAskedFor) {
  const Ways ways({{1, 6}, {2, 2}, {1, 5}, {1, 4}, {2, 3}});

  EXPECT_EQ(found(ways, cheapest(Which::kAll)), ways.names({3})) << "the last of the cheapest";
  EXPECT_EQ(found(ways, up_to(5, Which::kAll)), ways.names({3})) << "the last that is cheap enough";
  EXPECT_EQ(found(ways, up_to(3.5, Which::kAll)), Plans{});
}

TEST(SearchCost, OfPlansThatCostExactlyTheLimitTheFirstStays) {
  const Ways ways({{1, 9}, {2, 2}, {1, 4}, {4, 1}});

  EXPECT_EQ(found(ways, up_to(4, Which::kFirst)), ways.names({1}));
}

TEST(SearchCost, APlanBelowTheLimitIsTakenBeforeOneAtIt) {
  const Ways ways({{1, 4}, {1, 3}, {1, 2}});

  EXPECT_EQ(found(ways, up_to(4, Which::kFirst)), ways.names({1})) << "as SHOP3 looks on";
}

TEST(SearchCost, OfTheCheapestTheFirstStaysAndTheSearchEndsWhereNothingCostsAnything) {
  EXPECT_EQ(found(Ways({{1, 3}, {1, 2}, {2, 1}}), cheapest(Which::kFirst)), Plans{"(!w1)"});

  Case made(does("(go)", "((!free))") + does("(go)", "((turn))") + does("(turn)", "((turn))") +
                adds("(!free)", "", "0"),
            "", "((go))");
  made.options.optimize_cost = true;
  made.options.limits.expansions = 1'000;
  EXPECT_EQ(made.first(), "(!free)") << "the endless way is not entered";
}

TEST(SearchCost, TheBestPlanIsTheFirstOfLeastCost) {
  EXPECT_EQ(found(Ways({{1, 3}, {1, 2}, {2, 1}, {1, 9}}), wanting(Which::kBest)), Plans{"(!w1)"});
}

TEST(SearchCost, PlansInADearBranchAreNotWorkedOut) {
  const std::string dear =
      does("(go)", "((!dear) (think))") + does("(think)", "((think))") + adds("(!dear)", "", "6");
  for (const Options& options :
       {cheapest(Which::kAll), wanting(Which::kBest), up_to(5, Which::kAll)}) {
    Case made(does("(go)", "((!a))") + dear + adds("(!a)", "", "5"), "", "((go))");
    made.options = options;
    made.options.limits.expansions = 1'000;

    EXPECT_EQ(made.first(), "(!a)");
  }
}

TEST(SearchCost, CostsAreAddedOnAsExactlyAsTheirKindsAllow) {
  Case ratios(adds("(!a)", "", "1/3"), "", "((!a) (!a) (!a))");
  Case mixed(adds("(!a)", "", "1/2") + adds("(!b)", "", "0.25d0"), "", "((!a) (!b))");
  Case beyond(adds("(!a)", "", "9223372036854775807"), "", "((!a) (!a))");

  EXPECT_EQ(to_text(ratios.run().plans.at(0).cost), "1");
  EXPECT_EQ(to_text(mixed.run().plans.at(0).cost), "0.75");
  EXPECT_EQ(beyond.first(), "error: the cost of the plan: the result is an integer beyond 64 bits");
}

TEST(SearchCost, WhatIsNoNumberCountsAsOne) {
  Case made("(:operator (!a ?x) () () () ?x)", "", "((!a nil) (!a word) (!a 5))");

  EXPECT_EQ(to_text(made.run().plans.at(0).cost), "7");
}

// ---- against the loop --------------------------------------------------------------------------

RC_GTEST_PROP(SearchCostProperty, PlansAreKeptAsByTheLoopOfShop3, ()) {
  const Ways ways = Ways::drawn();
  Options options = wanting(
      *rc::gen::element(Which::kFirst, Which::kAll, Which::kShallowest, Which::kAllShallowest));
  switch (*rc::gen::inRange(0, 3)) {
    case 1:
      options.optimize_cost = true;
      break;
    case 2:
      options.cost_limit = *rc::gen::inRange(0, 9);
      break;
    default:
      break;
  }
  RC_LOG() << ways.items();

  RC_ASSERT(found(ways, options) == ways.names(Loop(options).over(ways)));
}

RC_GTEST_PROP(SearchCostProperty, DeepeningGivesWhatAllGivesWithTheShallowFirst, ()) {
  const Ways ways = Ways::drawn();
  std::vector<std::size_t> expected = Loop(wanting(Which::kAll)).over(ways);
  std::stable_sort(expected.begin(), expected.end(), [&](std::size_t left, std::size_t right) {
    return ways.all()[left].steps < ways.all()[right].steps;
  });
  RC_LOG() << ways.items();

  RC_ASSERT(found(ways, wanting(Which::kIdAll)) == ways.names(expected));
}

RC_GTEST_PROP(SearchCostProperty, SoManyPlansAreTheFirstOfAll, ()) {
  const Ways ways = Ways::drawn();
  Options options = wanting(*rc::gen::element(Which::kAll, Which::kIdAll));
  const Plans all = found(ways, options);
  const auto most = *rc::gen::inRange<std::size_t>(1, ways.all().size() + 2);

  options.limits.plans = most;

  RC_ASSERT(
      found(ways, options) ==
      Plans(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(most, all.size()))));
}

}  // namespace
}  // namespace skein::htn
