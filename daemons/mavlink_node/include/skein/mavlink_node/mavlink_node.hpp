// SPDX-License-Identifier: Apache-2.0
// The bridge to an autopilot as a node: a functional layer of one UAV.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "skein/mavlink_node/cockpit.hpp"
#include "skein/node/companion.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/translation/functional_layer.hpp"

namespace skein::mavlink_node {

/// Passes requests, and the loss of the decision node, to the cockpit. The cockpit's effects come
/// back through LinkCompanion as samples in this node's name; the node sends them to the UAV, and
/// publishes the vehicle's position on the world channel and event log records.
class MavlinkNode final : public node::Node {
 public:
  /// `name`: of this node, the functional layer of `uav`; both in the roster.
  MavlinkNode(std::string name, std::string uav, node::Roster roster,
              std::shared_ptr<Cockpit> cockpit);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  /// None: time passes in the cockpit.
  std::optional<MissionTime> next_wakeup() const override { return std::nullopt; }

 private:
  void relay(wire::Sample sample, MissionTime now, node::Effects& out);

  std::string name_, uav_;
  node::NodeNumber self_, peer_;
  std::shared_ptr<Cockpit> cockpit_;
  translation::FunctionalLines lines_;
};

/// Turns the cockpit whenever data arrives over the link, and every 100 ms of mission time; passes
/// the cockpit's effects to the node. Its one thread only waits and wakes the daemon.
class LinkCompanion final : public node::Companion {
 public:
  LinkCompanion(std::string name, std::string uav, std::shared_ptr<Cockpit> cockpit);
  ~LinkCompanion() override;

  void attach(std::function<void()> wake) override;
  void detach() override;
  std::string speaks_as() const override { return name_; }
  std::vector<wire::Sample> take() override;
  void sees(const wire::Sample&) override {}
  void sees(const journal::Record&) override {}
  void turn(const node::DaemonState& state) override { mission_ = state.now.mission; }

 private:
  void watch(const std::function<void()>& wake) const;
  wire::Sample sample_of(const autopilot::Effect& effect) const;

  std::string name_, uav_;
  std::shared_ptr<Cockpit> cockpit_;
  MissionTime mission_{};
  int stop_ = -1;  ///< readable when the thread is to end
  std::thread thread_;
};

}  // namespace skein::mavlink_node
