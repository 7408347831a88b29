// SPDX-License-Identifier: Apache-2.0
// Parameter sweeps over a scenario.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::batch_tool {

/// A path in a scenario's document, and the values to put there in turn.
struct Sweep {
  std::string path;  ///< keys, and numbers of list items from 0: "faults.0.at"
  std::vector<std::string> values;
};

/// One value of each sweep.
using Combination = std::vector<std::pair<std::string, std::string>>;

/// "radio.loss=0,0.1"; commas within brackets, braces or quotes do not part values. Every error at
/// once.
Result<std::vector<Sweep>, Diagnostics> read_sweeps(const std::vector<std::string>& texts);

/// All combinations, the last sweep varying fastest; without sweeps a single empty combination.
std::vector<Combination> combinations(const std::vector<Sweep>& sweeps);

/// "radio.loss=0.1 seed=3"; empty of no sweep.
std::string to_text(const Combination& combination);

/// The text of a scenario with these values; comments are lost. Keys that are not there are added:
/// whether they mean something, the reader of scenarios knows. The failure: the text is no YAML, or
/// the path leads through something that has no such part.
Result<std::string, Failure> with_values(const std::string& yaml, const Combination& combination);

}  // namespace skein::batch_tool
