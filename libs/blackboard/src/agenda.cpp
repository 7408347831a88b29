// SPDX-License-Identifier: Apache-2.0
#include "agenda.hpp"

#include <algorithm>

namespace skein::blackboard {

namespace {

template <class Key>
void move_to(Agenda::Order<Key>& order, NodeNumber peer, Agenda::Place<Key>& place,
             const std::optional<Key>& to) {
  const bool is_there = place.has_value();
  if (is_there ? to == (*place)->first : !to) return;
  auto entry = is_there ? order.extract(*place) : typename Agenda::Order<Key>::node_type();
  place.reset();
  if (!to) return;
  if (entry) {
    entry.value().first = *to;
    place = order.insert(std::move(entry)).position;
  } else {
    place = order.emplace(*to, peer).first;
  }
}

}  // namespace

void Agenda::set(NodeNumber peer, std::optional<Duration> due, std::optional<MissionTime> expires) {
  Entry& entry = entries_[peer];
  move_to(by_due_, peer, entry.due, due);
  move_to(by_expiry_, peer, entry.expires, expires);
}

std::vector<NodeNumber> Agenda::due(Now now) const {
  std::vector<NodeNumber> peers;
  for (auto one = by_due_.begin(); one != by_due_.end() && one->first <= now.steady; ++one) {
    peers.push_back(one->second);
  }
  for (auto one = by_expiry_.begin(); one != by_expiry_.end() && one->first < now.mission; ++one) {
    peers.push_back(one->second);
  }
  std::sort(peers.begin(), peers.end());
  peers.erase(std::unique(peers.begin(), peers.end()), peers.end());
  return peers;
}

std::optional<Duration> Agenda::next_due() const {
  if (by_due_.empty()) return std::nullopt;
  return by_due_.begin()->first;
}

std::optional<MissionTime> Agenda::next_expiry() const {
  if (by_expiry_.empty()) return std::nullopt;
  return by_expiry_.begin()->first;
}

}  // namespace skein::blackboard
