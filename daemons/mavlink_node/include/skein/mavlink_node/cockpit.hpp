// SPDX-License-Identifier: Apache-2.0
// The autopilot bridge on a real link and a real clock.
#pragma once

#include <memory>
#include <vector>

#include "skein/autopilot/bridge.hpp"
#include "skein/mavlink_node/link.hpp"

namespace skein::mavlink_node {

/// Connects the bridge with the link in both directions; other effects of the bridge are kept until
/// take(). Thread rule: one thread.
class Cockpit {
 public:
  /// `rate`: mission seconds per second; other than 1 only for simulated vehicles that keep up.
  Cockpit(autopilot::Bridge bridge, std::unique_ptr<Link> link, double rate);

  void give(const autopilot::Input& input);
  /// Handles received bytes and the passage of time.
  void turn();
  /// Returns and removes the kept effects, in order, without transmissions.
  std::vector<autopilot::Effect> take();

  bool is_ready() const { return bridge_.is_ready(); }
  int descriptor() const { return link_->descriptor(); }
  double rate() const { return rate_; }

 private:
  autopilot::Bridge bridge_;
  std::unique_ptr<Link> link_;
  double rate_;
  std::vector<autopilot::Effect> told_;
};

}  // namespace skein::mavlink_node
