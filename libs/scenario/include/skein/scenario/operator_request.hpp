// SPDX-License-Identifier: Apache-2.0
// Requests of an operator to the ground station during the mission, as text.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/ground_orders/operator_request.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario {

/// Reads requests: YAML or JSON, a list of the actions that steps of a script have
/// (docs/scenario-format.md), and in addition
///   ask: {uav}                      asks the operator that controls the UAV to release it
///   keep: {uav}                     refuses such a request
///   let_go: {uav, to}               releases the UAV, to operator `to` if given
///   answer: TEXT                    the operator's answer that a step of the script waits for
///   judge_alarm: {alarm, as}        the operator confirms or infirms an alarm
///   go: {uav, to, altitude}         the UAV flies at once to places or points, as in tasks
/// A map without a list is a list of one action; a map with `tasks` is a mission.
/// Thread rule: one thread (the terrain is built on first use).
class RequestReader {
 public:
  explicit RequestReader(std::shared_ptr<const Scenario> scenario)
      : scenario_(std::move(scenario)) {}

  /// All errors at once, with their positions in the text, as file "request".
  Result<std::vector<ground_station::OperatorDeed>, Diagnostics> read(std::string_view text);

 private:
  std::shared_ptr<const Scenario> scenario_;
  std::unique_ptr<world::Terrain> terrain_;
};

}  // namespace skein::scenario
