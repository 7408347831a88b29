// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/cockpit.hpp"

#include <utility>

#include "skein/node/waker.hpp"

namespace skein::mavlink_node {

Cockpit::Cockpit(autopilot::Bridge bridge, std::unique_ptr<Link> link, double rate)
    : bridge_(std::move(bridge)), link_(std::move(link)), rate_(rate) {}

void Cockpit::give(const autopilot::Input& input) {
  const Duration now = Duration::seconds(node::Waker::steady_now().to_seconds() * rate_);
  for (autopilot::Effect& effect : bridge_.handle(input, now)) {
    if (const auto* sent = std::get_if<autopilot::Transmit>(&effect)) {
      link_->send(sent->bytes);
    } else {
      told_.push_back(std::move(effect));
    }
  }
}

void Cockpit::turn() {
  auto bytes = link_->receive();
  if (bytes.empty()) return give(autopilot::Tick{});
  give(autopilot::Heard{std::move(bytes)});
}

std::vector<autopilot::Effect> Cockpit::take() { return std::exchange(told_, {}); }

}  // namespace skein::mavlink_node
