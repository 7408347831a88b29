// SPDX-License-Identifier: Apache-2.0
#include "link_map.hpp"

#include <deque>
#include <tuple>

namespace skein::blackboard::routing {
namespace {

/// A link that has just come back weighs as much as a way past two relays, and a little.
constexpr std::size_t kSteadyLink = 2;
constexpr std::size_t kUnsteadyLink = 7;

}  // namespace

void LinkMap::learn(NodeNumber author, const std::vector<wire::Neighbour>& hears) {
  Hears& report = reports_[author];
  report.clear();
  for (const wire::Neighbour& one : hears) {
    if (NodeNumber(one.node) != author) report.emplace(NodeNumber(one.node), one.steady);
  }
}

const LinkMap::Hears* LinkMap::report(NodeNumber author) const {
  const auto found = reports_.find(author);
  return found == reports_.end() ? nullptr : &found->second;
}

bool LinkMap::hears(NodeNumber author, NodeNumber node) const {
  const Hears* hears = report(author);
  return hears != nullptr && hears->contains(node);
}

std::set<NodeNumber> LinkMap::known_to(NodeNumber at) const {
  std::set<NodeNumber> met{at};
  for (std::deque<NodeNumber> ends{at}; !ends.empty(); ends.pop_front()) {
    const bool passes_on = ends.front() == at || relays_.contains(ends.front());
    const Hears* hears = passes_on ? report(ends.front()) : nullptr;
    if (hears == nullptr) continue;
    for (const auto& [node, steady] : *hears) {
      if (met.insert(node).second) ends.push_back(node);
    }
  }
  return met;
}

std::set<NodeNumber> LinkMap::heard_of() const {
  std::set<NodeNumber> all;
  for (const NodeNumber relay : known_to(self_)) {
    const Hears* hears = relay != self_ && relays_.contains(relay) ? report(relay) : nullptr;
    if (hears == nullptr) continue;
    for (const auto& [node, steady] : *hears) {
      if (node != self_) all.insert(node);
    }
  }
  return all;
}

LinkMap::Links LinkMap::links() const {
  Links links;
  std::map<NodeNumber, std::set<NodeNumber>> known;
  const auto knows = [&](NodeNumber node, NodeNumber author) {
    if (hears(node, author)) return true;
    const auto [entry, is_new] = known.try_emplace(node);
    if (is_new) entry->second = known_to(node);
    return entry->second.contains(author);
  };
  for (const NodeNumber author : known_to(self_)) {
    const Hears* hears = report(author);
    if (hears == nullptr) continue;
    for (const auto& [node, steady] : *hears) {
      if (knows(node, author)) links[node].emplace(author, steady);
    }
  }
  return links;
}

std::map<NodeNumber, Way> LinkMap::ways(const std::map<NodeNumber, Way>& before) const {
  struct Best {
    std::size_t cost = 0;
    std::size_t links = 0;
    std::set<NodeNumber> first;  ///< hops of equally good ways
  };
  Links out = links();
  std::map<NodeNumber, Best> best;
  std::set<std::tuple<std::size_t, std::size_t, NodeNumber>> open{{0, 0, self_}};
  best[self_] = {};
  while (!open.empty()) {
    const auto [cost, links, node] = *open.begin();
    open.erase(open.begin());
    if (node != self_ && !relays_.contains(node)) continue;
    const std::set<NodeNumber> first = best[node].first;
    for (const auto& [to, steady] : out[node]) {
      if (to == self_) continue;
      const std::size_t to_cost = cost + (steady ? kSteadyLink : kUnsteadyLink);
      const auto [entry, is_new] = best.try_emplace(to, Best{to_cost, links + 1, {}});
      Best& known = entry->second;
      const auto is = std::pair(known.cost, known.links);
      const auto would_be = std::pair(to_cost, links + 1);
      if (would_be > is) continue;
      if (is_new || would_be < is) {
        open.erase({known.cost, known.links, to});
        known = {to_cost, links + 1, {}};
        open.insert({to_cost, links + 1, to});
      }
      if (node == self_) {
        known.first.insert(to);
      } else {
        known.first.insert(first.begin(), first.end());
      }
    }
  }
  std::map<NodeNumber, Way> all;
  for (const auto& [node, way] : best) {
    if (node == self_) continue;
    const auto was = before.find(node);
    const bool keeps = was != before.end() && way.first.contains(was->second.next);
    all.emplace(node, Way{keeps ? was->second.next : *way.first.begin(), way.links - 1});
  }
  return all;
}

}  // namespace skein::blackboard::routing
