// SPDX-License-Identifier: Apache-2.0
// Effects as short lines, for comparing and for messages: "3 b1 running", "3 run t1".
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/overloaded.hpp"
#include "skein/interaction/effect.hpp"

namespace skein::interaction::testing {

inline std::string show(const Effect& effect) {
  const std::string said = std::visit(
      Overloaded{
          [](const StateChanged& e) { return e.componel + " " + std::string(to_text(e.state)); },
          [](const Compute& e) { return "compute " + e.parameter; },
          [](const Run& e) { return "run " + e.task; },
          [](const Negotiate& e) { return "negotiate " + e.action; },
          [](const Interrupt& e) { return "interrupt " + e.task; },
          [](const Withdraw& e) { return "withdraw " + e.action; },
          [](const Read& e) { return e.by + " reads " + e.message; },
          [](const ModelOver& e) { return "model " + std::string(to_text(e.state)); }},
      effect.what);
  return to_text(effect.at) + " " + said;
}

inline std::vector<std::string> show(const Effects& effects) {
  std::vector<std::string> lines;
  for (const Effect& effect : effects) lines.push_back(show(effect));
  return lines;
}

}  // namespace skein::interaction::testing
