// SPDX-License-Identifier: Apache-2.0
#include "tour/rounds.hpp"

#include <algorithm>
#include <limits>

#include "tour/search.hpp"

namespace skein::refiners {
namespace {

constexpr std::uint64_t kNoBound = std::numeric_limits<std::uint64_t>::max();
/// Among as many gates ways that are straight are found at once, late or not.
constexpr std::size_t kFewGates = 60;

}  // namespace

TourRounds::TourRounds(TourLegs& legs, const Setting& setting) : legs_(legs), setting_(setting) {
  started_ = legs_.start_optimistic(setting.budget);
  if (!started_) return;
  exact_sets_ = exact_sets(legs_.problem());
  thorough_ = exact_sets_ == 0 || exact_tour_steps(legs_.problem()) <= kMostQuickSteps;
}

std::optional<TourOrder> TourRounds::run() {
  if (!started_) return std::nullopt;
  Next next = Next::kGoOn;
  for (std::size_t i = 0; i < kMostTourRounds && next == Next::kGoOn; ++i) next = round();
  const bool proved = best_ && best_->exact;
  if (!proved) finish(next == Next::kSettled);
  if (best_) best_->effort = effort_;
  return best_;
}

TourRounds::Next TourRounds::round() {
  const TourOrder order = solve(legs_.problem(), steps_of_round());
  const bool impossible = order.cost >= kNoWay;
  if (!impossible) {
    const bool all = legs_.settle(order.gates);
    keep(order);
    if (!all || setting_.budget.expired()) {
      effort_.cut_short = true;
      return Next::kStop;
    }
  }
  const bool settled = best_ && best_->cost <= order.cost;
  if (!settled && !impossible) return Next::kGoOn;
  if (!thorough_) {
    thorough_ = true;
    return Next::kGoOn;
  }
  if (settled) best_->exact = order.exact;
  return settled ? Next::kSettled : Next::kStop;
}

/// Without looking for more ways.
void TourRounds::finish(bool settled) {
  const bool more = has_bounds() && steps_left() > 0 && !setting_.budget.expired();
  const bool late = best_ || legs_.problem().gates() > kFewGates;
  if ((settled && !more) || (late && setting_.budget.expired())) return;
  const auto known = legs_.known_only(setting_.budget);
  if (!known) return;
  TourOrder order = solve(*known, kNoBound);
  order.exact = false;
  if (order.cost >= kNoWay) return;
  legs_.settle(order.gates);
  keep(std::move(order));
}

TourOrder TourRounds::solve(const TourProblem& problem, std::uint64_t most_steps) {
  const Budget budget{setting_.budget.time_is_up, std::min(steps_left(), most_steps)};
  TourOrder order = solve_tour(problem, budget, setting_.seed);
  effort_.steps += order.effort.steps;
  effort_.cut_short = effort_.cut_short || order.effort.cut_short;
  return order;
}

std::uint64_t TourRounds::steps_of_round() const {
  const std::uint64_t usual = default_tour_steps(legs_.problem());
  if (exact_sets_ == 0) return usual;
  return thorough_ ? std::max(usual, exact_sets_) : std::min(usual, exact_sets_ - 1);
}

std::uint64_t TourRounds::steps_left() const {
  const std::uint64_t given = setting_.budget.steps;
  return given == kNoBound ? kNoBound : given - std::min(given, effort_.steps);
}

bool TourRounds::has_bounds() const {
  return setting_.budget.time_is_up || setting_.budget.steps != kNoBound;
}

void TourRounds::keep(TourOrder order) {
  if (!legs_.are_known(order.gates)) return;
  order.cost = cost_of(legs_.problem(), order.gates);
  order.exact = false;
  if (order.cost < kNoWay && (!best_ || order.cost < best_->cost)) best_ = std::move(order);
}

}  // namespace skein::refiners
