// SPDX-License-Identifier: Apache-2.0
// A constraint "target - source >= weight" is an edge source -> target; dates are longest paths.
#include "skein/temporal/stn_solution.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "indexed_heap.hpp"
#include "propagation.hpp"
#include "sweep_order.hpp"

namespace skein::temporal {

namespace {

constexpr Ticks kLatestDate = 2 * kLargest;

/// The finite constraints of a network by the node they leave, or, reversed, by the one they enter.
class ConstraintGraph {
 public:
  struct Edge {
    NodeIndex other = 0;
    Constraint constraint = 0;
    Ticks weight = 0;
  };
  enum class Direction : std::uint8_t { kForward, kReversed };

  ConstraintGraph(const Stn& network, Direction direction) : begin_(network.nodes.size() + 1, 0) {
    const bool reversed = direction == Direction::kReversed;
    for_each(network, [&](NodeIndex source, NodeIndex target, Constraint, Ticks) {
      ++begin_[(reversed ? target : source) + 1];
    });
    for (std::size_t node = 0; node + 1 < begin_.size(); ++node) begin_[node + 1] += begin_[node];
    edges_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_each(network, [&](NodeIndex source, NodeIndex target, Constraint k, Ticks weight) {
      const NodeIndex node = reversed ? target : source;
      edges_[next[node]++] = {reversed ? source : target, k, weight};
    });
  }

  std::span<const Edge> of(NodeIndex node) const {
    return {edges_.data() + begin_[node], edges_.data() + begin_[node + 1]};
  }

  /// visit(source, target, constraint, weight) of every constraint that is one.
  template <class Visit>
  static void for_each(const Stn& network, const Visit& visit) {
    for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
      const Arc& arc = network.arcs[i];
      if (arc.min != kMinusInfinite) visit(arc.from, arc.to, 2 * i, weight_of_min(arc.min));
      if (arc.max != kInfinite) visit(arc.to, arc.from, 2 * i + 1, weight_of_max(arc.max));
    }
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<Edge> edges_;
};

std::vector<NodeIndex> order_of(const Stn& network) {
  std::vector<Precedence> precedences;
  ConstraintGraph::for_each(network,
                            [&](NodeIndex source, NodeIndex target, Constraint, Ticks weight) {
                              if (weight >= 0 && source != target)
                                precedences.push_back({source, target});
                            });
  return sweep_order(network.nodes.size(), precedences);
}

/// Dates >= 0 that keep every constraint, or a circle of constraints that nothing keeps.
class FeasibleSchedule {
 public:
  enum class Outcome : std::uint8_t { kDone, kCycle, kOverflow };

  explicit FeasibleSchedule(std::size_t nodes)
      : dates_(nodes, 0), parents_(nodes), active_(nodes, 1) {}

  Outcome solve(const ConstraintGraph& graph, const std::vector<NodeIndex>& order) {
    const std::size_t nodes = order.size();
    for (bool forward = true;; forward = !forward) {
      bool moved = false;
      for (std::size_t i = 0; i < nodes; ++i) {
        const NodeIndex node = order[forward ? i : nodes - 1 - i];
        if (active_[node] == 0) continue;
        active_[node] = 0;
        moved = push(graph, node) || moved;
        if (overflow_) return find_cycle() ? Outcome::kCycle : Outcome::kOverflow;
        if (moves_ <= nodes) continue;
        moves_ = 0;
        if (find_cycle()) return Outcome::kCycle;
      }
      if (!moved) return Outcome::kDone;
    }
  }

  const std::vector<Ticks>& dates() const { return dates_; }
  const std::vector<ConflictArc>& cycle() const { return cycle_; }
  std::uint64_t checks() const { return checks_; }

 private:
  struct Parent {
    NodeIndex node = kNone;
    Constraint constraint = 0;
  };

  bool push(const ConstraintGraph& graph, NodeIndex node) {
    bool moved = false;
    for (const ConstraintGraph::Edge& edge : graph.of(node)) {
      ++checks_;
      const Ticks date = dates_[node] + edge.weight;
      if (date <= dates_[edge.other]) continue;
      dates_[edge.other] = date;
      parents_[edge.other] = {node, edge.constraint};
      active_[edge.other] = 1;
      moved = true;
      ++moves_;
      overflow_ = date > kLatestDate;
      if (overflow_) return true;
    }
    return moved;
  }

  // Follows parents from every node; each walk has its own mark.
  bool find_cycle() {
    mark_.assign(parents_.size(), kNone);
    for (NodeIndex start = 0; start < parents_.size(); ++start) {
      NodeIndex node = start;
      while (node != kNone && mark_[node] == kNone) {
        mark_[node] = start;
        node = parents_[node].node;
      }
      if (node != kNone && mark_[node] == start) {
        read_cycle(node);
        return true;
      }
    }
    return false;
  }

  void read_cycle(NodeIndex on_cycle) {
    NodeIndex node = on_cycle;
    do {
      const Constraint k = parents_[node].constraint;
      cycle_.push_back({k / 2, (k & 1) == 0 ? Bound::kLower : Bound::kUpper});
      node = parents_[node].node;
    } while (node != on_cycle);
    std::reverse(cycle_.begin(), cycle_.end());
  }

  std::vector<Ticks> dates_;
  std::vector<Parent> parents_;
  std::vector<std::uint8_t> active_;
  std::vector<NodeIndex> mark_;
  std::vector<ConflictArc> cycle_;
  std::size_t moves_ = 0;
  std::uint64_t checks_ = 0;
  bool overflow_ = false;
};

/// How much later the schedule has each node than the longest path from the origin asks for; along
/// reversed edges, how much earlier than the longest path to it.
struct Slack {
  std::vector<std::optional<Ticks>> of;  ///< nothing: no path
  bool overflow = false;
  std::uint64_t checks = 0;
};

Slack slack_of(const ConstraintGraph& graph, const std::vector<Ticks>& dates, NodeIndex origin,
               bool reversed) {
  Slack slack{std::vector<std::optional<Ticks>>(dates.size()), false, 0};
  IndexedHeap<Ticks> queue(dates.size());
  queue.lower(origin, 0);
  while (!queue.empty()) {
    const NodeIndex node = queue.pop();
    const Ticks here = queue.key(node);
    slack.of[node] = here;
    const Ticks ahead = reversed ? dates[origin] - dates[node] : dates[node] - dates[origin];
    slack.overflow = std::abs(ahead - here) > kLargest;  // the longest path is as long as that
    if (slack.overflow) return slack;
    for (const ConstraintGraph::Edge& edge : graph.of(node)) {
      ++slack.checks;
      if (slack.of[edge.other]) continue;
      const Ticks rise =
          reversed ? dates[node] - dates[edge.other] : dates[edge.other] - dates[node];
      queue.lower(edge.other, here + rise - edge.weight);
    }
  }
  return slack;
}

std::optional<StnRefusal> wrong_arc(const Stn& network) {
  const std::size_t nodes = network.nodes.size();
  if (network.origin >= nodes) return StnRefusal{StnError::kUnknownNode, network.origin};
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    for (const NodeIndex node : {arc.from, arc.to}) {
      if (node >= nodes) return StnRefusal{StnError::kUnknownNode, node};
    }
    const auto too_large = [](Ticks bound) {
      return bound != kInfinite && bound != kMinusInfinite && std::abs(bound) > kLargest;
    };
    if (too_large(arc.min) || too_large(arc.max)) return StnRefusal{StnError::kOverflow, i};
  }
  return std::nullopt;
}

}  // namespace

Result<StnSolution, StnRefusal> solve_stn(const Stn& network) {
  if (const std::optional<StnRefusal> wrong = wrong_arc(network)) return tl::unexpected(*wrong);
  StnSolution solution;
  FeasibleSchedule schedule(network.nodes.size());
  const StnRefusal overflow{StnError::kOverflow, 0};
  Slack behind;
  {
    const ConstraintGraph graph(network, ConstraintGraph::Direction::kForward);
    const FeasibleSchedule::Outcome outcome = schedule.solve(graph, order_of(network));
    if (outcome == FeasibleSchedule::Outcome::kOverflow) return tl::unexpected(overflow);
    solution.conflict = schedule.cycle();
    solution.checks = schedule.checks();
    if (outcome == FeasibleSchedule::Outcome::kCycle) return solution;
    behind = slack_of(graph, schedule.dates(), network.origin, false);
  }
  const ConstraintGraph reversed(network, ConstraintGraph::Direction::kReversed);
  const Slack ahead = slack_of(reversed, schedule.dates(), network.origin, true);
  if (behind.overflow || ahead.overflow) return tl::unexpected(overflow);
  solution.consistent = true;
  solution.checks += behind.checks + ahead.checks;
  for (NodeIndex node = 0; node < network.nodes.size(); ++node) {
    const Ticks date = schedule.dates()[node] - schedule.dates()[network.origin];
    DateWindow& window = solution.windows.emplace_back();
    if (behind.of[node]) window.earliest = date - *behind.of[node];
    if (ahead.of[node]) window.latest = date + *ahead.of[node];
  }
  return solution;
}

}  // namespace skein::temporal
