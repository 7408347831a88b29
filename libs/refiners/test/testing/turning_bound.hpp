// SPDX-License-Identifier: Apache-2.0
// What no walk over a lattice can be below in mean idleness, with the turns that its visits need.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "patrol/walk_graph.hpp"

namespace skein::refiners::testing {

/// Passes of places from link to link, as arcs from one directed link to another.
class PassGraph {
 public:
  struct Arc {
    std::size_t to;       ///< directed link
    std::uint32_t place;  ///< that is passed
    double length;        ///< [m], half of each link and the turn
  };

  explicit PassGraph(const WalkGraph& graph) {
    std::vector<std::size_t> first;
    std::size_t count = 0;
    for (const auto& place : graph.places) first.push_back(count), count += place.links.size();
    arcs_.resize(count);
    for (std::uint32_t from = 0; from < graph.places.size(); ++from)
      for (std::size_t i = 0; i < graph.places[from].links.size(); ++i) {
        const auto& in = graph.places[from].links[i];
        const auto& passed = graph.places[in.to];
        for (std::size_t k = 0; k < passed.links.size(); ++k)
          arcs_[first[from] + i].push_back({first[in.to] + k, in.to,
                                            (in.length + passed.links[k].length) / 2 +
                                                graph.detour(from, in.to, passed.links[k].to)});
      }
  }
  const std::vector<std::vector<Arc>>& arcs() const { return arcs_; }

 private:
  std::vector<std::vector<Arc>> arcs_;  ///< from each directed link
};

/// A closed way through a pass graph: visits a metre of the places that it passes.
struct VisitRate {
  std::vector<std::uint32_t> places;
  double each = 0;
};

/// The greatest worth a metre of any closed way, each visit of a place worth so much: Howard's
/// policy iteration, warm from one call to the next.
class BestCycle {
 public:
  explicit BestCycle(const PassGraph& graph)
      : graph_(graph), policy_(graph.arcs().size(), 0), potential_(graph.arcs().size(), 0) {}

  /// Every cycle of the last policy, the best of them among them.
  const std::vector<VisitRate>& cycles() const { return cycles_; }

  /// Not below the greatest worth a metre, whatever the potentials: round a cycle they cancel out.
  double most(const std::vector<double>& worth) {
    constexpr int kMostRounds = 60;
    for (int round = 0; round < kMostRounds; ++round) {
      evaluate(worth);
      if (!improve(worth)) break;
    }
    double most = 0;
    for (std::size_t i = 0; i < graph_.arcs().size(); ++i)
      for (const auto& arc : graph_.arcs()[i])
        most = std::max(most, (worth[arc.place] + potential_[arc.to] - potential_[i]) / arc.length);
    return most;
  }

 private:
  const PassGraph::Arc& chosen(std::size_t i) const { return graph_.arcs()[i][policy_[i]]; }

  void evaluate(const std::vector<double>& worth) {
    const std::size_t n = policy_.size();
    cycles_.clear();
    ratio_ = -1;
    std::size_t root = 0;
    std::vector<std::size_t> seen(n, 0);
    for (std::size_t start = 0, mark = 1; start < n; ++start, ++mark) {
      std::size_t at = start;
      for (; seen[at] == 0; at = chosen(at).to) seen[at] = mark;
      if (seen[at] == mark) note_cycle(at, worth, root);
    }
    potentials_from(root, worth);
  }

  void note_cycle(std::size_t first, const std::vector<double>& worth, std::size_t& root) {
    VisitRate rate;
    double length = 0, sum = 0;
    std::size_t at = first;
    do {
      const auto& arc = chosen(at);
      rate.places.push_back(arc.place);
      length += arc.length;
      sum += worth[arc.place];
      at = arc.to;
    } while (at != first);
    rate.each = 1 / length;
    if (sum / length > ratio_) ratio_ = sum / length, root = first;
    cycles_.push_back(std::move(rate));
  }

  /// Backwards from the best cycle; what its policy does not lead there takes any arc that does.
  void potentials_from(std::size_t root, const std::vector<double>& worth) {
    const std::size_t n = policy_.size();
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> into(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < graph_.arcs()[i].size(); ++k)
        into[graph_.arcs()[i][k].to].emplace_back(i, k);
    std::vector<bool> done(n, false);
    std::vector<std::size_t> open = {root};
    done[root] = true;
    potential_[root] = 0;
    const auto take = [&](bool of_policy) {
      for (std::size_t next = 0; next < open.size(); ++next)
        for (const auto& [i, k] : into[open[next]]) {
          if (done[i] || (of_policy && policy_[i] != k)) continue;
          done[i] = true;
          policy_[i] = k;
          const auto& arc = chosen(i);
          potential_[i] = worth[arc.place] - ratio_ * arc.length + potential_[arc.to];
          open.push_back(i);
        }
    };
    take(true);
    take(false);
  }

  bool improve(const std::vector<double>& worth) {
    bool improved = false;
    for (std::size_t i = 0; i < policy_.size(); ++i) {
      const auto& arcs = graph_.arcs()[i];
      for (std::size_t k = 0; k < arcs.size(); ++k) {
        const double value =
            worth[arcs[k].place] - ratio_ * arcs[k].length + potential_[arcs[k].to];
        if (value > potential_[i] + 1e-10 * ratio_) {
          potential_[i] = value;
          policy_[i] = k;
          improved = true;
        }
      }
    }
    return improved;
  }

  const PassGraph& graph_;
  std::vector<std::size_t> policy_;  ///< arc taken from each directed link
  std::vector<double> potential_;
  std::vector<VisitRate> cycles_;
  double ratio_ = 0;
};

/// Closed ways, each flown for a part of the time.
class WaysInParts {
 public:
  explicit WaysInParts(const WalkGraph& graph) : graph_(graph), worth_(graph.places.size()) {
    const Walk all = walk_in_turn(graph);
    double length = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto before = all[(i + all.size() - 1) % all.size()], after = all[(i + 1) % all.size()];
      length += graph.length(all[i], after) + graph.detour(before, all[i], after);
    }
    ways_.push_back({all, 1 / length});
    weights_.push_back(1);
    reckon();
  }

  /// Σ R / n, and what a visit more a metre of each place would take from it.
  double sum() const { return sum_; }
  const std::vector<double>& worth() const { return worth_; }

  /// Adds ways worth about as much as what there is, for a part `fresh` of the time, finds better
  /// parts of all, and leaves out those with next to none.
  void add(const std::vector<VisitRate>& ways, double fresh) {
    constexpr double kWorthy = 0.9;
    for (const VisitRate& way : ways) {
      if (worth_of(way) < kWorthy * sum_) continue;
      ways_.push_back(way);
      weights_.push_back(fresh / static_cast<double>(ways.size()));
    }
    for (int step = 0; step < kSteps; ++step) {
      reckon();
      for (std::size_t i = 0; i < ways_.size(); ++i)
        weights_[i] *= std::sqrt(worth_of(ways_[i]) / sum_);
    }
    leave_out();
    reckon();
  }

 private:
  static constexpr int kSteps = 60;
  static constexpr double kNone = 1e-9;

  double worth_of(const VisitRate& way) const {
    double sum = 0;
    for (const auto place : way.places) sum += worth_[place] * way.each;
    return sum;
  }

  /// The first visits all places, and stays.
  void leave_out() {
    for (std::size_t i = ways_.size(); i-- > 1;) {
      if (weights_[i] >= kNone) continue;
      std::swap(ways_[i], ways_.back());
      std::swap(weights_[i], weights_.back());
      ways_.pop_back();
      weights_.pop_back();
    }
  }

  void reckon() {
    double total = 0;
    for (const double weight : weights_) total += weight;
    for (double& weight : weights_) weight /= total;
    std::vector<double> visits(worth_.size(), 0);
    for (std::size_t i = 0; i < ways_.size(); ++i)
      for (const auto place : ways_[i].places) visits[place] += weights_[i] * ways_[i].each;
    sum_ = 0;
    for (std::size_t place = 0; place < visits.size(); ++place) {
      sum_ += graph_.places[place].risk / visits[place];
      worth_[place] = graph_.places[place].risk / (visits[place] * visits[place]);
    }
  }

  const WalkGraph& graph_;
  std::vector<VisitRate> ways_;
  std::vector<double> weights_;
  std::vector<double> worth_;  ///< per place
  double sum_ = 0;
};

/// Of the mean idleness by risk of walks, as lengths [m]: no walk is below `proved`, whatever the
/// rounds; no bound of this kind is above `most`.
struct TurningBound {
  double proved = 0, most = std::numeric_limits<double>::infinity();
};

/// Proof: docs/decisions/0027. Cost: at most `rounds` policy iterations over all passes; some
/// milliseconds each for a thousand places.
inline TurningBound least_mean_with_turns(const WalkGraph& graph, int rounds) {
  constexpr double kNearEnough = 2e-4;
  const PassGraph passes(graph);
  BestCycle best(passes);
  WaysInParts ways(graph);
  TurningBound bound;
  for (int round = 0; round < rounds; ++round) {
    const double sum = ways.sum(), most = best.most(ways.worth());
    bound.most = std::min(bound.most, sum / (2 * graph.total_risk));
    bound.proved = std::max(bound.proved, sum * sum / most / (2 * graph.total_risk));
    if (bound.proved > bound.most * (1 - kNearEnough)) break;
    // Less and less, or what is settled is stirred again each round.
    ways.add(best.cycles(), std::max(1e-4, 0.1 / (1 + round / 20.0)));
  }
  return bound;
}

}  // namespace skein::refiners::testing
