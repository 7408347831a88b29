// SPDX-License-Identifier: Apache-2.0
#include "coverage/lane_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

Pass pass_of(const Strip& strip, bool along) {
  const world::Vector2 from(strip.from, strip.y), to(strip.to, strip.y);
  return along ? Pass{from, to, 0} : Pass{to, from, std::numbers::pi};
}

Pass turned_round(const Pass& pass) {
  return {pass.to, pass.from, pass.heading == 0 ? std::numbers::pi : 0};
}

/// With what it takes more when flown backwards.
std::pair<BlockOption, double> flown(const Block& block, const LaneOrder& order, bool along,
                                     const TurnModel& model) {
  BlockOption option;
  option.along = along;
  option.first = option.last = pass_of(block[order.front()], along);
  double more = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Strip& strip = block[order[i]];
    const double length = strip.to - strip.from, seconds = model.lane(length, along);
    option.seconds += seconds;
    more += model.lane(length, !along) - seconds;
    const Pass next = pass_of(strip, along);
    if (i > 0) option.seconds += model.between(option.last, next);
    option.last = next;
    along = !along;
  }
  return {option, more};
}

LaneOrder neighbours(std::size_t lanes) {
  LaneOrder order(lanes);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

/// Seconds of the turns of an order if all lanes were level, by how many lanes each leads over.
double level_turns(const LaneOrder& order, const std::vector<double>& beside) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    sum += beside[order[i] > order[i - 1] ? order[i] - order[i - 1] : order[i - 1] - order[i]];
  return sum;
}

/// An order, with the seconds its turns would take if all lanes were level.
struct Levelled {
  LaneOrder order;
  double turns = 0;
};

/// The order in rounds with the fastest level turns. Turns over about two radii are best, so only
/// rounds of about twice as many lanes are tried.
Levelled fastest_interleaved(std::size_t lanes, const std::vector<double>& beside, double over) {
  const auto count = static_cast<double>(lanes);
  const auto fewest = static_cast<std::size_t>(std::max(1.0, std::floor(count / (2 * over + 6))));
  const auto most = static_cast<std::size_t>(std::clamp(std::ceil(count / (2 * over)), 1.0, count));
  Levelled best;
  for (std::size_t rounds = fewest; rounds <= std::min(most, fewest + 8); ++rounds) {
    LaneOrder order = interleaved(lanes, rounds);
    const double turns = level_turns(order, beside);
    if (best.order.empty() || turns < best.turns) best = {std::move(order), turns};
  }
  return best;
}

/// The order of neighbours, and where turns are wider than lanes, one that skips lanes.
std::vector<Levelled> levelled_orders(const Block& block, const TurnModel& model) {
  const std::size_t lanes = block.size();
  const double spacing = lanes > 1 ? block[1].y - block[0].y : 0;
  if (lanes < 2 || model.hovers() || spacing >= 2 * model.radius() || spacing <= 0)
    return {{neighbours(lanes), static_cast<double>(lanes - 1) * model.beside(spacing)}};
  std::vector<double> beside(lanes);
  for (std::size_t i = 0; i < lanes; ++i)
    beside[i] = model.beside(static_cast<double>(i) * spacing);
  return {{neighbours(lanes), static_cast<double>(lanes - 1) * beside[1]},
          fastest_interleaved(lanes, beside, 2 * model.radius() / spacing)};
}

/// The faster of them, its mirror image if it skips lanes, and the other where the lanes would have
/// to be flown to tell.
std::vector<LaneOrder> orders_of(const Block& block, const TurnModel& model) {
  constexpr double kClearlyLess = 0.9;
  std::vector<Levelled> levelled = levelled_orders(block, model);
  std::vector<LaneOrder> orders{std::move(levelled[0].order)};
  if (levelled.size() < 2 || levelled[0].turns < kClearlyLess * levelled[1].turns) return orders;
  if (levelled[1].turns < kClearlyLess * levelled[0].turns) orders.clear();
  orders.push_back(levelled[1].order);
  for (std::uint32_t& lane : levelled[1].order)
    lane = static_cast<std::uint32_t>(block.size()) - 1 - lane;
  orders.push_back(std::move(levelled[1].order));
  return orders;
}

void add_both_ways(BlockOption option, double more, std::vector<BlockOption>& options) {
  options.push_back(option);
  option.seconds += more;
  option.backwards = true;
  std::swap(option.first, option.last);
  option.first = turned_round(option.first);
  option.last = turned_round(option.last);
  options.push_back(option);
}

}  // namespace

double level_seconds(const Block& block, const TurnModel& model) {
  double turns = std::numeric_limits<double>::infinity();
  for (const Levelled& order : levelled_orders(block, model)) turns = std::min(turns, order.turns);
  double lanes = 0;
  for (const Strip& strip : block) {
    const double length = strip.to - strip.from;
    lanes += (model.lane(length, true) + model.lane(length, false)) / 2;
  }
  return lanes + turns;
}

LaneOrder interleaved(std::size_t lanes, std::size_t rounds) {
  SKEIN_EXPECTS(rounds > 0);
  LaneOrder order;
  order.reserve(lanes);
  const auto lane = [](std::size_t index) { return static_cast<std::uint32_t>(index); };
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t begin = lanes * round / rounds, end = lanes * (round + 1) / rounds;
    const std::size_t half = (end - begin + 1) / 2;
    // Every other round begins with its second half, so that the turn into it is as wide as others.
    const bool second_first = round % 2 == 1 && begin + half < end;
    for (std::size_t i = 0; i < half; ++i) {
      const bool has_second = begin + half + i < end;
      if (second_first && has_second) order.push_back(lane(begin + half + i));
      order.push_back(lane(begin + i));
      if (!second_first && has_second) order.push_back(lane(begin + half + i));
    }
  }
  return order;
}

BlockOptions options_of(const Block& block, const TurnModel& model) {
  SKEIN_EXPECTS(!block.empty());
  BlockOptions found;
  found.orders = orders_of(block, model);
  for (std::uint32_t order = 0; order < found.orders.size(); ++order)
    for (const bool along : {true, false}) {
      auto [option, more] = flown(block, found.orders[order], along, model);
      option.order = order;
      add_both_ways(option, more, found.options);
    }
  return found;
}

std::vector<Pass> passes_of(const Block& block, const BlockOptions& options,
                            const BlockOption& option) {
  std::vector<Pass> passes;
  bool along = option.along;
  for (const std::uint32_t lane : options.orders[option.order]) {
    passes.push_back(pass_of(block[lane], along));
    along = !along;
  }
  if (!option.backwards) return passes;
  std::reverse(passes.begin(), passes.end());
  for (Pass& pass : passes) pass = turned_round(pass);
  return passes;
}

}  // namespace skein::refiners
