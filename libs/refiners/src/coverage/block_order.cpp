// SPDX-License-Identifier: Apache-2.0
#include "coverage/block_order.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostExact = 8;      ///< blocks
constexpr std::size_t kMostChoices = 40;   ///< options of all blocks together
constexpr std::size_t kMostImproved = 64;  ///< blocks

/// A block, in one of its options.
struct Choice {
  std::uint32_t block = 0, option = 0;
};

class BlockOrder {
 public:
  BlockOrder(const std::vector<Block>& blocks, const TurnModel& model, const SweepEnds& ends)
      : model_(model), ends_(ends) {
    for (const Block& block : blocks) blocks_.push_back(options_of(block, model));
  }

  std::vector<Choice> best() const {
    if (blocks_.size() == 1) return best_of_one();
    if (blocks_.size() <= kMostExact && all_choices().size() <= kMostChoices) return exact();
    std::vector<Choice> order = nearest_next();
    if (blocks_.size() <= kMostImproved)
      for (int pass = 0; pass < 8 && improve(order); ++pass) continue;
    return order;
  }

  std::vector<Choice> quick() const {
    if (blocks_.size() == 1) return best_of_one();
    std::vector<Choice> order = nearest_next();
    if (blocks_.size() <= kMostExact) improve(order);
    return order;
  }

  double seconds(const std::vector<Choice>& order) const {
    double sum = before(order.front()) + after(order.back());
    for (std::size_t i = 0; i < order.size(); ++i)
      sum += option(order[i]).seconds + (i > 0 ? between(order[i - 1], order[i]) : 0);
    return sum;
  }
  const BlockOption& option(const Choice& choice) const {
    return blocks_[choice.block].options[choice.option];
  }
  const BlockOptions& options(const Choice& choice) const { return blocks_[choice.block]; }

 private:
  double before(const Choice& first) const {
    return ends_.start ? model_.reach(*ends_.start, option(first).first) : 0;
  }
  double after(const Choice& last) const {
    return ends_.end ? model_.leave(option(last).last, *ends_.end) : 0;
  }
  double between(const Choice& from, const Choice& to) const {
    return model_.between(option(from).last, option(to).first);
  }
  double joined(const std::vector<Choice>& order, std::size_t at, const Choice& inserted) const {
    const double in = at > 0 ? between(order[at - 1], inserted) : before(inserted);
    const double out = at < order.size() ? between(inserted, order[at]) : after(inserted);
    return option(inserted).seconds + in + out;
  }
  /// What the route has between two that are neighbours in it, or at its ends.
  double link(const std::vector<Choice>& order, std::size_t at) const {
    if (at == 0) return before(order.front());
    if (at == order.size()) return after(order.back());
    return between(order[at - 1], order[at]);
  }

  std::vector<Choice> all_choices() const {
    std::vector<Choice> choices;
    for (std::uint32_t block = 0; block < blocks_.size(); ++block)
      for (std::uint32_t i = 0; i < blocks_[block].options.size(); ++i)
        choices.push_back({block, i});
    return choices;
  }

  std::vector<Choice> best_of_one() const {
    Choice best;
    for (std::uint32_t i = 1; i < blocks_[0].options.size(); ++i)
      if (seconds({{0, i}}) < seconds({best})) best.option = i;
    return {best};
  }
  std::vector<Choice> exact() const;
  std::vector<Choice> nearest_next() const;
  bool improve(std::vector<Choice>& order) const;

  const TurnModel& model_;
  const SweepEnds& ends_;
  std::vector<BlockOptions> blocks_;
};

/// Dynamic programming over the sets of blocks that are done. Source: Held and Karp 1962.
std::vector<Choice> BlockOrder::exact() const {
  const std::vector<Choice> choices = all_choices();
  const std::size_t n = choices.size(), sets = std::size_t{1} << blocks_.size();
  std::vector<double> link(n * n, 0), least(sets * n, kInfinity);
  std::vector<std::uint32_t> from(sets * n, 0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (choices[a].block != choices[b].block) link[a * n + b] = between(choices[a], choices[b]);
  for (std::size_t a = 0; a < n; ++a)
    least[(std::size_t{1} << choices[a].block) * n + a] =
        before(choices[a]) + option(choices[a]).seconds;
  for (std::size_t set = 1; set + 1 < sets; ++set)
    for (std::size_t a = 0; a < n; ++a) {
      if (least[set * n + a] == kInfinity) continue;
      for (std::size_t b = 0; b < n; ++b) {
        const std::size_t bit = std::size_t{1} << choices[b].block;
        if (set & bit) continue;
        const double seconds = least[set * n + a] + link[a * n + b] + option(choices[b]).seconds;
        double& known = least[(set | bit) * n + b];
        if (seconds >= known) continue;
        known = seconds;
        from[(set | bit) * n + b] = static_cast<std::uint32_t>(a);
      }
    }
  std::size_t set = sets - 1, last = 0;
  const auto whole = [&](std::size_t a) { return least[set * n + a] + after(choices[a]); };
  for (std::size_t a = 1; a < n; ++a)
    if (whole(a) < whole(last)) last = a;
  std::vector<Choice> order;
  while (set != 0) {
    order.push_back(choices[last]);
    const std::size_t before_it = from[set * n + last];
    set &= ~(std::size_t{1} << choices[last].block);
    last = before_it;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<Choice> BlockOrder::nearest_next() const {
  std::vector<Choice> order;
  std::vector<bool> done(blocks_.size(), false);
  while (order.size() < blocks_.size()) {
    Choice best;
    double least = kInfinity;
    for (std::uint32_t block = 0; block < blocks_.size(); ++block) {
      if (done[block]) continue;
      for (std::uint32_t i = 0; i < blocks_[block].options.size(); ++i) {
        const Choice choice{block, i};
        const double straight =
            order.empty() ? 0 : (option(choice).first.from - option(order.back()).last.to).norm();
        if (straight / model_.speed() >= least) continue;
        const double seconds = order.empty() ? before(choice) : between(order.back(), choice);
        if (seconds >= least) continue;
        best = choice;
        least = seconds;
      }
    }
    done[best.block] = true;
    order.push_back(best);
  }
  return order;
}

/// Moves every block once to where, and in which option, it costs least; true when that saved time.
bool BlockOrder::improve(std::vector<Choice>& order) const {
  bool saved = false;
  for (std::uint32_t block = 0; block < blocks_.size(); ++block) {
    const auto is_it = [&](const Choice& choice) { return choice.block == block; };
    const auto place = std::find_if(order.begin(), order.end(), is_it);
    const Choice old = *place;
    std::size_t best_at = static_cast<std::size_t>(place - order.begin());
    order.erase(place);
    Choice best = old;
    double least = joined(order, best_at, old) - link(order, best_at) - 1e-9;
    for (std::size_t at = 0; at <= order.size(); ++at) {
      const double cut = link(order, at);
      for (std::uint32_t i = 0; i < blocks_[block].options.size(); ++i) {
        const double added = joined(order, at, {block, i}) - cut;
        if (added >= least) continue;
        least = added;
        best = {block, i};
        best_at = at;
        saved = true;
      }
    }
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(best_at), best);
  }
  return saved;
}

}  // namespace

Route order_blocks(const std::vector<Block>& blocks, const TurnModel& model,
                   const SweepEnds& ends) {
  SKEIN_EXPECTS(!blocks.empty());
  const BlockOrder search(blocks, model, ends);
  const std::vector<Choice> order = search.best();
  Route route;
  route.seconds = search.seconds(order);
  for (const Choice& choice : order) {
    const auto passes =
        passes_of(blocks[choice.block], search.options(choice), search.option(choice));
    route.passes.insert(route.passes.end(), passes.begin(), passes.end());
  }
  return route;
}

double quick_seconds(const std::vector<Block>& blocks, const TurnModel& model,
                     const SweepEnds& ends) {
  SKEIN_EXPECTS(!blocks.empty());
  const BlockOrder search(blocks, model, ends);
  return search.seconds(search.quick());
}

}  // namespace skein::refiners
