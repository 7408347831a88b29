// SPDX-License-Identifier: Apache-2.0
// Iteration over the actions of the ground's script and of its operators.
#pragma once

#include <variant>

#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// Calls `see` with each action: steps, then operators, in the order of the file.
template <class See>
void for_actions(const scenario::Scenario& scenario, const See& see) {
  const auto look = [&](const auto& steps) {
    for (const auto& step : steps)
      for (const ground_station::Action& action : step.actions) see(action);
  };
  look(scenario.ground.script.steps);
  look(scenario.ground.script.operators);
}

/// Calls `see` with each action of type `Wanted`.
template <class Wanted, class See>
void for_scripted(const scenario::Scenario& scenario, const See& see) {
  for_actions(scenario, [&](const ground_station::Action& action) {
    if (const auto* one = std::get_if<Wanted>(&action)) see(*one);
  });
}

}  // namespace skein::laws
