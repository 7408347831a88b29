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

/// The text with one part less, in every way there is: faults and cuts first, then what is
/// expected, then steps, tasks, objects, UAVs and whatever else is listed. Some of them make no
/// sense. Precondition: it is YAML.
std::vector<std::string> smaller(const std::string& yaml);

}  // namespace skein::storm_tool
