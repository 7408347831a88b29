// SPDX-License-Identifier: Apache-2.0
#include "link_watch.hpp"

#include <algorithm>

namespace skein::blackboard::routing {

bool LinkWatch::on_heartbeat(NodeNumber peer, Duration steady) {
  Link& link = links_[peer];
  const bool was_up = link.up;
  const bool was_steady = link.steady();
  link.last = steady;
  link.up = true;
  link.in_a_row = was_up ? std::min(link.in_a_row + 1, kSteadyAfter) : 1;
  return !was_up || link.steady() != was_steady;
}

void LinkWatch::on_sign_of_life(NodeNumber peer, Duration steady) {
  const auto found = links_.find(peer);
  if (found != links_.end() && found->second.up) found->second.last = steady;
}

bool LinkWatch::update(Duration steady) {
  bool any = false;
  for (auto& [peer, link] : links_) {
    if (!link.up || steady - link.last < silence_) continue;
    link.up = false;
    link.was_lost = true;
    link.in_a_row = 0;
    any = true;
  }
  return any;
}

std::optional<Duration> LinkWatch::next_silence() const {
  std::optional<Duration> next;
  for (const auto& [peer, link] : links_) {
    if (link.up) next = next ? std::min(*next, link.last + silence_) : link.last + silence_;
  }
  return next;
}

bool LinkWatch::hears(NodeNumber peer) const {
  const auto found = links_.find(peer);
  return found != links_.end() && found->second.up;
}

std::vector<wire::Neighbour> LinkWatch::heard() const {
  std::vector<wire::Neighbour> all;
  for (const auto& [peer, link] : links_) {
    if (link.up) all.push_back({peer.value(), link.steady()});
  }
  return all;
}

}  // namespace skein::blackboard::routing
