// SPDX-License-Identifier: Apache-2.0
// Lanes first, then the dates a fixed policy can lead to, then bounds wide enough for them.
#include "skein/temporal_lab/stnu_generator.hpp"

#include <algorithm>
#include <string>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

class Generator {
 public:
  Generator(const StnuGeneratorOptions& options, Random& random)
      : options_(options), random_(random) {}

  Stnu run() {
    add_nodes();
    choose_contingent_steps();
    add_steps();
    for (std::uint32_t i = 0; i < extra_arcs() / 6; ++i) add_precedence();
    find_ranges();
    bound_steps();
    while (out_.arcs.size() < steps_ + extra_arcs()) add_window();
    if (options_.break_it) break_one();
    return std::move(out_);
  }

 private:
  struct Step {
    NodeIndex before = 0;
    Ticks fast = 0;  ///< the policy's delay after the node before, at least
    Ticks slow = 0;  ///< and at most
    bool contingent = false;
  };
  /// Dates a node can have under the policy.
  struct Range {
    Ticks first = 0;
    Ticks last = 0;
  };

  std::uint32_t extra_arcs() const {
    return static_cast<std::uint32_t>(std::uint64_t{options_.nodes} * options_.extra_arcs_percent /
                                      100);
  }
  Ticks seconds(std::uint64_t low, std::uint64_t high) {
    return static_cast<Ticks>(low + random_.below(high - low + 1)) * kTicksPerSecond;
  }
  NodeIndex any_node() { return 1 + static_cast<NodeIndex>(random_.below(options_.nodes - 1)); }
  std::uint32_t lane(NodeIndex node) const { return (node - 1) % options_.lanes; }

  // Node 1 + lanes·i + j is the i-th of lane j: numbers follow the dates roughly.
  void add_nodes() {
    out_.nodes.emplace_back("z");
    for (NodeIndex node = 1; node < options_.nodes; ++node) {
      const NodeIndex place = (node - 1) / options_.lanes;
      out_.nodes.push_back("l" + std::to_string(lane(node)) + "n" + std::to_string(place));
    }
  }

  bool fits(NodeIndex node) const {
    const std::uint32_t lanes = options_.lanes;
    if (node <= lanes || step_of_[node].contingent || step_of_[node - lanes].contingent)
      return false;
    return node + lanes >= options_.nodes || !step_of_[node + lanes].contingent;
  }

  void choose_contingent_steps() {
    step_of_.resize(options_.nodes);
    for (std::uint32_t left = options_.contingent; left > 0;) {
      NodeIndex node = any_node();
      for (std::uint32_t tries = 0; !fits(node) && tries < options_.nodes; ++tries) {
        node = node + 1 < options_.nodes ? node + 1 : 1;
      }
      if (!fits(node)) return;
      step_of_[node].contingent = true;
      --left;
    }
  }

  void add_steps() {
    for (NodeIndex node = 1; node < options_.nodes; ++node) {
      Step& step = step_of_[node];
      step.before = node <= options_.lanes ? 0 : node - options_.lanes;
      step.fast = seconds(1, 20);
      step.slow = step.contingent ? step.fast + seconds(1, 20) : step.fast;
      if (step.contingent) {
        out_.contingent.push_back({step.before, node, step.fast, step.slow});
      } else {
        out_.arcs.push_back({step.before, node, step.fast, kInfinite});
      }
    }
    steps_ = out_.arcs.size();
  }

  void add_precedence() {
    const NodeIndex to = any_node();
    if (to <= options_.lanes || step_of_[to].contingent) return;
    const std::uint64_t reach = std::min<std::uint64_t>(to - 1, std::uint64_t{8} * options_.lanes);
    const NodeIndex from = to - 1 - static_cast<NodeIndex>(random_.below(reach));
    if (from == 0 || lane(from) == lane(to)) return;
    out_.arcs.push_back({from, to, seconds(0, 5), kInfinite});
  }

  // Numbers grow along steps and precedences.
  void find_ranges() {
    std::vector<std::vector<std::size_t>> into(options_.nodes);
    for (std::size_t arc = steps_; arc < out_.arcs.size(); ++arc)
      into[out_.arcs[arc].to].push_back(arc);
    range_.resize(options_.nodes);
    for (NodeIndex node = 1; node < options_.nodes; ++node) {
      const Step& step = step_of_[node];
      Range range{range_[step.before].first + step.fast, range_[step.before].last + step.slow};
      for (const std::size_t index : into[node]) {
        const Arc& arc = out_.arcs[index];
        range.first = std::max(range.first, range_[arc.from].first + arc.min);
        range.last = std::max(range.last, range_[arc.from].last + arc.min);
      }
      range_[node] = range;
    }
  }

  Ticks longest(NodeIndex from, NodeIndex to) const { return range_[to].last - range_[from].first; }
  Ticks shortest(NodeIndex from, NodeIndex to) const {
    return range_[to].first - range_[from].last;
  }

  void bound_steps() {
    for (Arc& arc : out_.arcs)
      arc.max = std::max(arc.min, longest(arc.from, arc.to)) + seconds(0, 10);
  }

  void add_window() {
    const NodeIndex from = any_node();
    const bool same_lane = random_.chance(0.5);
    std::uint64_t offset = 1 + random_.below(std::uint64_t{10} * options_.lanes);
    if (same_lane) offset = (1 + offset / options_.lanes) * options_.lanes;
    if (from + offset >= options_.nodes) return;
    const auto to = static_cast<NodeIndex>(from + offset);
    out_.arcs.push_back(
        {from, to, shortest(from, to) - seconds(0, 10), longest(from, to) + seconds(0, 10)});
  }

  // The least time from the start of a task to a node after it in the lane, if the task is quick,
  // plus half of what the task may take longer.
  void break_one() {
    const ContingentLink& link = out_.contingent[out_.contingent.size() / 2];
    Ticks least = link.min;
    NodeIndex node = link.contingent;
    for (int i = 0; i < 6 && node + options_.lanes < options_.nodes; ++i) {
      node += options_.lanes;
      least += step_of_[node].fast;
    }
    out_.arcs.push_back({link.activation, node, kMinusInfinite, least + (link.max - link.min) / 2});
  }

  const StnuGeneratorOptions& options_;
  Random& random_;
  Stnu out_;
  std::vector<Step> step_of_;
  std::vector<Range> range_;
  std::size_t steps_ = 0;
};

}  // namespace

Stnu generate_stnu(const StnuGeneratorOptions& options, Random& random) {
  SKEIN_EXPECTS(options.lanes >= 2 && options.nodes >= 1 + 3 * options.lanes);
  SKEIN_EXPECTS(options.contingent + options.lanes <= (options.nodes - 1) / 3);
  SKEIN_EXPECTS(!options.break_it || options.contingent > 0);
  return Generator(options, random).run();
}

}  // namespace skein::temporal
