// SPDX-License-Identifier: Apache-2.0
// The two halves of a step.
#include <algorithm>
#include <utility>

#include "blackboard_impl.hpp"

namespace skein::blackboard {
namespace {

bool tells_of_links(const Arrival& arrival) {
  const auto* sample = std::get_if<wire::Sample>(&arrival.content);
  return sample != nullptr && std::holds_alternative<wire::LinkState>(*sample);
}

}  // namespace

std::vector<Incoming> Blackboard::Impl::receive(Now now, bool handled) {
  if (handled) {
    for (Peer* peer : heard_) peer->commit();
    heard_.clear();
  } else {
    std::ranges::sort(heard_);
    heard_.erase(std::unique(heard_.begin(), heard_.end()), heard_.end());
  }
  connections_.update(now.steady, out_);
  std::vector<Arrival> arrivals = transport_.take();
  const bool waits = std::ranges::any_of(arrivals, tells_of_links);
  for (Arrival& arrival : arrivals) {
    if (waits && directory_.over(arrival.channel) != nullptr) {
      behind_links_.push_back(std::move(arrival));
    } else {
      arrive(std::move(arrival), now);
    }
  }
  while (auto due = delayed_.take_due(now.steady)) admit(due->channel, std::move(due->sample), now);
  return std::exchange(out_, {});
}

std::vector<Incoming> Blackboard::Impl::act(Now now) {
  for (Arrival& arrival : std::exchange(behind_links_, {})) {
    if (directory_.over(arrival.channel)->line().incoming().up) arrive(std::move(arrival), now);
  }
  for (const NodeNumber number : directory_.agenda().due(now)) {
    Peer& peer = directory_.at(number);
    peer.update(now, out_);
    serve(peer, now);
  }
  if (const auto number = pulse_.beat(now.steady)) {
    wire::Heartbeat heartbeat;
    signature_.sign_published(heartbeat.header, *number, now);
    write(*directory_.world(), heartbeat);
  }
  route(now);
  connections_.write_again();
  return std::exchange(out_, {});
}

}  // namespace skein::blackboard
