// SPDX-License-Identifier: Apache-2.0
// Violations as `skein storm --json` and `skein judge --json` tell them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "skein/laws/violation.hpp"

namespace skein::storm_tool {

inline nlohmann::ordered_json json_of_violations(const std::vector<laws::Violation>& violations) {
  auto all = nlohmann::ordered_json::array();
  for (const laws::Violation& one : violations)
    all.push_back({{"law", one.law},
                   {"at", one.at},
                   {"uav", one.uav},
                   {"goal", one.goal},
                   {"sentence", one.sentence}});
  return all;
}

}  // namespace skein::storm_tool
