// SPDX-License-Identifier: Apache-2.0
// A law of the event log that a run broke.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skein::laws {

struct Violation {
  std::string law;        ///< its name, one of `law_names`
  double at = 0;          ///< mission time [s]
  std::string uav;        ///< empty: of no single one
  std::int64_t goal = 0;  ///< the high-level task; 0: of none
  std::string sentence;   ///< what was seen, with figures
};

/// "312.5 s, karma, goal 701: achieved-was-done: looked at P1 for 3 of 120 s".
std::string to_text(const Violation& violation);
std::string to_text(const std::vector<Violation>& violations);

}  // namespace skein::laws
