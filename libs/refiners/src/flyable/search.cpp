// SPDX-License-Identifier: Apache-2.0
#include "flyable/search.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace skein::refiners {
namespace {

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();
constexpr std::uint32_t kFollowers = 30;  ///< of a node, about
constexpr double kFar = std::numeric_limits<double>::infinity();

class Search {
 public:
  Search(const std::vector<StationLayer>& layers, FlyableLegs& legs, const StationSearch& search)
      : layers_(layers), legs_(legs), search_(search) {
    for (std::size_t layer = 0; layer < layers.size(); ++layer)
      for (const Station& station : layers[layer].stations) nodes_.push_back({layer, &station});
    first_of_.assign(layers.size() + 1, nodes_.size());
    for (std::size_t i = nodes_.size(); i-- > 0;) first_of_[nodes_[i].layer] = i;
    find_remainders();
  }

  FoundWay run() {
    for (std::size_t i = 0; i < first_of_[1]; ++i)
      queue_.push({nodes_[i].remainder, 0, kNobody, i, true, {}});
    FoundWay found;
    while (!queue_.empty() && !legs_.exhausted_after(1)) {
      Entry entry = queue_.top();
      queue_.pop();
      if (nodes_[entry.to].closed) continue;
      if (!entry.flown) {
        fly(entry);
        continue;
      }
      close(entry);
      found.furthest = std::max(found.furthest, nodes_[entry.to].layer);
      if (nodes_[entry.to].layer + 1 == layers_.size()) {
        found.way = traced(entry.to);
        break;
      }
      expand(entry.to);
    }
    return found;
  }

 private:
  struct Node {
    std::size_t layer;
    const Station* station;
    double remainder = kFar;  ///< least length from here to the end
    double length = 0;        ///< of the way to here
    bool closed = false;
    std::size_t parent = kNobody;
    Way leg{};  ///< from the parent
  };
  struct Entry {
    double priority;
    double length;  ///< up to `to`; a lower bound until it is flown
    std::size_t from, to;
    bool flown;
    Way leg;
    bool operator>(const Entry& other) const {
      if (priority != other.priority) return priority > other.priority;
      if (to != other.to) return to < other.to;
      return from > other.from;
    }
  };

  std::size_t last_layer_from(std::size_t layer) const {
    return std::min(layers_.size() - 1, layer + 1 + search_.most_skipped);
  }

  void find_remainders() {
    for (std::size_t i = nodes_.size(); i-- > 0 && !legs_.exhausted_after(kFollowers);) {
      Node& node = nodes_[i];
      if (node.layer + 1 == layers_.size()) node.remainder = 0;
      for_followers(i, [&](std::size_t next) {
        node.remainder = std::min(node.remainder, least(i, next) + nodes_[next].remainder);
      });
    }
  }

  template <class Visit>
  void for_followers(std::size_t i, const Visit& visit) const {
    const std::size_t layer = nodes_[i].layer;
    if (layer + 1 == layers_.size()) return;
    for (std::size_t k = first_of_[layer + 1]; k < first_of_[last_layer_from(layer) + 1]; ++k)
      visit(k);
  }

  double least(std::size_t from, std::size_t to) const {
    return legs_.least_length(*nodes_[from].station, *nodes_[to].station);
  }

  void expand(std::size_t i) {
    for_followers(i, [&](std::size_t next) {
      if (nodes_[next].closed) return;
      const double length = nodes_[i].length + least(i, next);
      queue_.push({length + nodes_[next].remainder, length, i, next, false, {}});
    });
  }

  void fly(Entry& entry) {
    auto leg = legs_.leg(*nodes_[entry.from].station, *nodes_[entry.to].station, search_.thorough);
    if (!leg) return;
    entry.length = std::max(entry.length, nodes_[entry.from].length + level_length(*leg));
    entry.priority = entry.length + nodes_[entry.to].remainder;
    entry.flown = true;
    entry.leg = std::move(*leg);
    queue_.push(std::move(entry));
  }

  void close(Entry& entry) {
    Node& node = nodes_[entry.to];
    node.closed = true;
    node.length = entry.length;
    node.parent = entry.from;
    node.leg = std::move(entry.leg);
  }

  Way traced(std::size_t i) const {
    std::vector<std::size_t> chain;
    for (; nodes_[i].parent != kNobody; i = nodes_[i].parent) chain.push_back(i);
    const Station& start = *nodes_[i].station;
    Way way = {{start.pose.at.x(), start.pose.at.y(), start.z}};
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
      const Way& leg = nodes_[*link].leg;
      way.insert(way.end(), leg.begin() + 1, leg.end());
    }
    return way;
  }

  const std::vector<StationLayer>& layers_;
  FlyableLegs& legs_;
  StationSearch search_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> first_of_;  // node of each layer, and the count
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

FoundWay search_stations(const std::vector<StationLayer>& layers, FlyableLegs& legs,
                         const StationSearch& search) {
  return Search(layers, legs, search).run();
}

}  // namespace skein::refiners
