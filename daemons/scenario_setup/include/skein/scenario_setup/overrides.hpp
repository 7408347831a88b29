// SPDX-License-Identifier: Apache-2.0
// Overrides of a scenario from the command line.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/scenario/scenario.hpp"

namespace skein::scenario_setup {

struct Overrides {
  std::optional<double> rate;  ///< > 0
  std::optional<std::uint64_t> seed;
  std::vector<std::string> degrees;  ///< "2" for all UAVs, "marvin=1" for one; later ones win
  /// DDS vendor: "cyclonedds" for all nodes, "marvin=cyclonedds" for one; later ones win. Each
  /// daemon gets its own, so as_options() leaves it out.
  std::vector<std::string> dds = {};
  /// The same as options of another program's command line.
  std::vector<std::string> as_options() const;
};

/// Changes the scenario, then draws its random faults and variations with the seed in force. Every
/// error at once.
Diagnostics apply(const Overrides& overrides, scenario::Scenario& scenario);

/// A check of the scenario for a node; returns all problems.
using Check = std::function<Diagnostics(const scenario::Scenario&)>;

/// Reads a scenario file, applies the overrides and checks what came out (no check: none is made).
Result<scenario::Scenario, Diagnostics> load_scenario(const std::string& path,
                                                      const Overrides& overrides,
                                                      const Check& check);

}  // namespace skein::scenario_setup
