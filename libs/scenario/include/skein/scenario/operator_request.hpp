// SPDX-License-Identifier: Apache-2.0
// What an operator asks of the ground station while the mission runs, as text.
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

/// Reads requests: YAML or JSON, a list of actions as the steps of a script have them
/// (docs/scenario-format.md), and beside these
///   ask: {uav}                      its holder is asked to let go of it
///   keep: {uav}                     the answer: no
///   let_go: {uav, to}               nobody has it in hand, or operator `to`
///   answer: TEXT                    what a step waits for from an operator
///   judge_alarm: {alarm, as}        confirmed or infirmed, by a person
///   go: {uav, to, altitude}         it flies there at once: places or points, as in tasks
/// A map by itself is a list of one; a map with `tasks` is a mission.
/// Not safe to share between threads: its terrain is made when it is needed.
class RequestReader {
 public:
  explicit RequestReader(std::shared_ptr<const Scenario> scenario)
      : scenario_(std::move(scenario)) {}

  /// Every error at once; places are of the text, in file "request".
  Result<std::vector<ground_station::OperatorDeed>, Diagnostics> read(std::string_view text);

 private:
  std::shared_ptr<const Scenario> scenario_;
  std::unique_ptr<world::Terrain> terrain_;
};

}  // namespace skein::scenario
