// SPDX-License-Identifier: Apache-2.0
#include "router.hpp"

#include <utility>

namespace skein::blackboard::routing {

void Router::on_heartbeat(NodeNumber peer, Duration steady) {
  if (!watch_.hears(peer)) new_links_.push_back(peer);
  if (watch_.on_heartbeat(peer, steady)) tell_links();
}

void Router::on_report(const wire::Neighbours& report) {
  map_.learn(NodeNumber(report.header.origin), report.hears);
  is_stale_ = true;
}

void Router::tell_links() {
  map_.learn(self_, watch_.heard());
  is_stale_ = true;
  has_news_ = true;
}

std::vector<WayChange> Router::update(Duration steady) {
  if (watch_.update(steady)) tell_links();
  if (!std::exchange(is_stale_, false)) return {};
  const auto ways = std::exchange(ways_, map_.ways(ways_));
  const auto heard_of = std::exchange(heard_of_, map_.heard_of());
  std::set<NodeNumber> met = heard_of;
  met.insert(heard_of_.begin(), heard_of_.end());
  for (const auto& [peer, way] : ways) met.insert(peer);
  for (const auto& [peer, way] : ways_) met.insert(peer);
  std::vector<WayChange> changes;
  for (const NodeNumber peer : met) {
    const auto before = ways.find(peer);
    const auto after = ways_.find(peer);
    std::optional<Way> was, is;
    if (before != ways.end()) was = before->second;
    if (after != ways_.end()) is = after->second;
    const bool is_heard_of = heard_of_.contains(peer);
    if (was != is || heard_of.contains(peer) != is_heard_of)
      changes.push_back({peer, is, is_heard_of});
  }
  return changes;
}

std::optional<wire::Neighbours> Router::take_report() {
  if (!std::exchange(has_news_, false)) return std::nullopt;
  wire::Neighbours report;
  report.hears = watch_.heard();
  return report;
}

NodeNumber Router::next_hop(NodeNumber to) const {
  const auto found = ways_.find(to);
  return found == ways_.end() ? to : found->second.next;
}

}  // namespace skein::blackboard::routing
