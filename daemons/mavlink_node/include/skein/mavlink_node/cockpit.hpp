// SPDX-License-Identifier: Apache-2.0
// A bridge on a real link and a real clock.
#pragma once

#include <memory>
#include <vector>

#include "skein/autopilot/bridge.hpp"
#include "skein/mavlink_node/link.hpp"

namespace skein::mavlink_node {

/// What the bridge sends goes to the link, what comes from there to the bridge; the rest is kept
/// until it is taken. Thread rule: one thread.
class Cockpit {
 public:
  /// `rate`: mission seconds per second; 1 but for simulated vehicles that keep up.
  Cockpit(autopilot::Bridge bridge, std::unique_ptr<Link> link, double rate);

  void give(const autopilot::Input& input);
  /// Takes what has come, and lets time pass.
  void turn();
  /// In order, without transmissions.
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
