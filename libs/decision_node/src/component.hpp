// SPDX-License-Identifier: Apache-2.0
// The interface of the components of a decision node.
#pragma once

#include <optional>
#include <string>

#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

/// A deciding component: executive, supervisor, interaction manager, auction, temporal agent. Each
/// is listed once in Core::components(), and overrides the functions that concern it.
class Component {
 public:
  Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component() = default;

  /// A request that the table of routes assigns to this component; to be answered by Commands.
  virtual void take(const Command&) {}
  /// A task entered a state, whichever executive has it, if any.
  virtual void task_changed(const executive::TaskEvent&) {}
  virtual void vehicle_told(const world::Telemetry&) {}
  virtual void peer_in_reach(const std::string&) {}
  virtual void place_told(const mission::ChangeWorld&) {}
  virtual void time_passes() {}
  virtual std::optional<MissionTime> next_wakeup() const { return std::nullopt; }
};

}  // namespace skein::decision_node
