// SPDX-License-Identifier: Apache-2.0
// The actions of a script, of steps and of operators alike.
#pragma once

#include <variant>

#include "skein/ground_orders/script.hpp"

namespace skein::deliberation_setup {

/// When the actions may begin at the earliest: at the trigger's time, if it is a time alone.
inline MissionTime begin_of(const ground_station::Trigger& when) {
  const auto* time = std::get_if<ground_station::AtTime>(&when.what);
  return time == nullptr ? MissionTime() : time->at;
}

/// visit(Action, MissionTime begin), in the order of the file: steps, then operators.
template <typename Visit>
void for_each_action(const ground_station::Script& script, const Visit& visit) {
  for (const auto& step : script.steps) {
    for (const auto& action : step.actions) visit(action, begin_of(step.when));
  }
  for (const auto& one : script.operators) {
    for (const auto& action : one.actions) visit(action, begin_of(one.when));
  }
}

}  // namespace skein::deliberation_setup
