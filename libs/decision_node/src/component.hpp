// SPDX-License-Identifier: Apache-2.0
// What every component of a decision node can be asked and told.
#pragma once

#include <optional>
#include <string>

#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

/// A component that decides: executive, supervisor, and further ones beside them (interaction,
/// auction, temporal agent), each listed once in Core::components(). What it does not care for it
/// does not override.
class Component {
 public:
  Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component() = default;

  /// A request that the table of routes gives to it; it answers by Commands.
  virtual void take(const Command&) {}
  /// A task of whatever executive, or of none, entered a state.
  virtual void task_changed(const executive::TaskEvent&) {}
  virtual void vehicle_told(const world::Telemetry&) {}
  virtual void peer_in_reach(const std::string&) {}
  virtual void place_told(const mission::ChangeWorld&) {}
  virtual void time_passes() {}
  virtual std::optional<MissionTime> next_wakeup() const { return std::nullopt; }
};

}  // namespace skein::decision_node
