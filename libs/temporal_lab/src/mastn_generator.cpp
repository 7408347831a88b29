// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_lab/mastn_generator.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/random.hpp"

namespace skein::temporal {

namespace {

// U{0..most} whole seconds.
Ticks seconds_up_to(Random& random, std::uint64_t most) {
  return static_cast<Ticks>(random.below(most + 1)) * kTicksPerSecond;
}

// Agents are called A, B, … Z, then A1, B1, …; nodes are called after their agent: a1, a2, …
std::string agent_name(std::uint32_t agent, char first) {
  std::string name(1, static_cast<char>(first + agent % 26));
  return agent < 26 ? name : name + std::to_string(agent / 26);
}

std::string node_name(std::uint32_t agent, std::uint32_t node) {
  const std::string own = agent_name(agent, 'a');
  return own + (agent < 26 ? "" : "_") + std::to_string(node + 1);
}

/// One generation: the network under construction and its hidden solution.
class Generation {
 public:
  Generation(const MastnShape& shape, std::uint64_t seed)
      : shape_(shape), random_(seed, "mastn/network") {}

  Mastn run() {
    mastn_.nodes = {"v0"};
    mastn_.owner = {0};
    hidden_ = {0};
    for (std::uint32_t agent = 0; agent < shape_.agents; ++agent) add_chain(agent);
    for (std::uint32_t agent = 0; agent < shape_.agents; ++agent) add_local_arcs(agent);
    for (std::uint32_t agent = 0; agent < shape_.agents; ++agent) add_external_arcs(agent);
    return std::move(mastn_);
  }

 private:
  NodeIndex node_of(std::uint32_t agent, std::uint32_t position) const {
    return 1 + agent * shape_.nodes + position;
  }

  NodeIndex random_node_of(std::uint32_t agent) {
    return node_of(agent, static_cast<std::uint32_t>(random_.below(shape_.nodes)));
  }

  void add_arc(NodeIndex from, NodeIndex to, Ticks min, Ticks max) {
    mastn_.arcs.push_back({from, to, min, max});
    joined_.insert(std::minmax(from, to));
  }

  void add_chain(std::uint32_t agent) {
    mastn_.agents.push_back(agent_name(agent, 'A'));
    for (std::uint32_t position = 0; position < shape_.nodes; ++position) {
      const NodeIndex node = node_of(agent, position);
      const NodeIndex before = position == 0 ? 0 : node - 1;
      const Ticks step = seconds_up_to(random_, 30);
      mastn_.nodes.push_back(node_name(agent, position));
      mastn_.owner.push_back(agent);
      hidden_.push_back(hidden_[before] + step);
      const Ticks below = seconds_up_to(random_, position == 0 ? 10 : 5);
      const Ticks above = seconds_up_to(random_, 15);
      add_arc(before, node, std::max<Ticks>(0, step - below), step + above);
    }
  }

  void add_slack_arc(NodeIndex from, NodeIndex to, std::uint64_t most) {
    const Ticks distance = hidden_[to] - hidden_[from];
    const Ticks below = seconds_up_to(random_, most);
    const Ticks above = seconds_up_to(random_, most);
    add_arc(from, to, distance - below, distance + above);
  }

  void add_local_arcs(std::uint32_t agent) {
    std::vector<std::pair<NodeIndex, NodeIndex>> pairs;
    for (std::uint32_t first = 0; first < shape_.nodes; ++first) {
      for (std::uint32_t second = first + 2; second < shape_.nodes; ++second) {
        pairs.emplace_back(node_of(agent, first), node_of(agent, second));
      }
    }
    for (std::uint32_t arc = 0; arc < shape_.local && !pairs.empty(); ++arc) {
      const auto chosen = pairs.begin() + static_cast<std::ptrdiff_t>(random_.below(pairs.size()));
      add_slack_arc(chosen->first, chosen->second, 40);
      pairs.erase(chosen);
    }
  }

  // A pair already joined is drawn again; small networks run out of pairs.
  void add_external_arcs(std::uint32_t agent) {
    constexpr int kDraws = 200;
    if (shape_.agents < 2) return;
    for (std::uint32_t arc = 0; arc < shape_.external; ++arc) {
      for (int draw = 0; draw < kDraws; ++draw) {
        const NodeIndex from = random_node_of(agent);
        const auto step = static_cast<std::uint32_t>(1 + random_.below(shape_.agents - 1));
        const NodeIndex to = random_node_of((agent + step) % shape_.agents);
        if (joined_.contains(std::minmax(from, to))) continue;
        add_slack_arc(from, to, 60);
        break;
      }
    }
  }

  MastnShape shape_;
  Random random_;
  Mastn mastn_;
  std::vector<Ticks> hidden_;                         // the dates of one solution
  std::set<std::pair<NodeIndex, NodeIndex>> joined_;  // lesser node first
};

}  // namespace

Mastn generate_mastn(const MastnShape& shape, std::uint64_t seed) {
  SKEIN_EXPECTS(shape.agents >= 1 && shape.nodes >= 1);
  return Generation(shape, seed).run();
}

std::vector<std::uint32_t> chain_arcs(const MastnShape& shape) {
  std::vector<std::uint32_t> arcs(std::size_t{shape.agents} * shape.nodes);
  for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) arcs[arc] = arc;
  return arcs;
}

double frontier_ratio(const Mastn& mastn) {
  std::vector<bool> frontier(mastn.nodes.size(), false);
  for (const Arc& arc : mastn.arcs) {
    if (arc.from == 0 || arc.to == 0 || mastn.owner[arc.from] == mastn.owner[arc.to]) continue;
    frontier[arc.from] = frontier[arc.to] = true;
  }
  if (frontier.size() < 2) return 0;
  return static_cast<double>(std::count(frontier.begin(), frontier.end(), true)) /
         static_cast<double>(frontier.size() - 1);
}

}  // namespace skein::temporal
