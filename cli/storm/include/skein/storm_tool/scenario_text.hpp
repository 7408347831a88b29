// SPDX-License-Identifier: Apache-2.0
// The text of a scenario file, changed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/mission_lab/troubles.hpp"

namespace skein::storm_tool {

/// With these troubles beside its own, and this seed; comments are lost. The failure: it is no YAML
/// document with keys.
Result<std::string, Failure> with_troubles(const std::string& yaml, std::uint64_t seed,
                                           const mission_lab::Troubles& troubles);

/// All texts with one part less: faults and cuts first, then expectations, then steps, tasks,
/// objects, UAVs and other list items. Some are not meaningful. Precondition: `yaml` is valid YAML.
std::vector<std::string> smaller(const std::string& yaml);

}  // namespace skein::storm_tool
