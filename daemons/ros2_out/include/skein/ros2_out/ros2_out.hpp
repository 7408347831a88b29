// SPDX-License-Identifier: Apache-2.0
// ROS 2 topics about the team, from the process of the ground station.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/result.hpp"
#include "skein/node/companion.hpp"
#include "skein/ros2_out/narrator.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ros2_out {

struct Ros2Config {
  std::uint32_t domain = 0;  ///< ROS_DOMAIN_ID
  blackboard::NetworkConfig network;
  NarratorConfig narrator;
};

NarratorConfig narrator_config_of(const scenario::Scenario& scenario);

/// A text of the topic skein/mission as the request of an operator: a list of actions is taken as
/// it is, anything else as a mission.
std::string request_of(const std::string& text);

/// Publishes the inputs and outputs of the ground station on topics of ROS 2, and accepts missions
/// and actions from one, as the operator "ros2". Replies go to skein/reply, as JSON. Needs no ROS
/// installation: it uses DDS with the names and types of ROS 2. Source: ADR 28.
class Ros2Out final : public node::Companion {
 public:
  static Result<std::unique_ptr<Ros2Out>, Failure> open(Ros2Config config);
  ~Ros2Out() override;

  void attach(std::function<void()> wake) override;
  void detach() override;
  std::string speaks_as() const override { return "operator"; }
  std::vector<wire::Sample> take() override;
  void sees(const wire::Sample& sample) override;
  void sees(const journal::Record&) override {}
  void turn(const node::DaemonState& state) override;

 private:
  class Impl;
  explicit Ros2Out(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::ros2_out
