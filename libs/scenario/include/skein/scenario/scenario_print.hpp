// SPDX-License-Identifier: Apache-2.0
// The fingerprint of what a scenario says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/section_prints.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario {

/// The fingerprint of all that nodes must agree on to fly together, by section: "mission" (epoch,
/// limit of time, seed), "vehicles", "world" (origin, terrain, wind), "zones", "closed air",
/// "places", "objects", "radio" (with the table of slots), "planning" (with its domain and
/// separation), "team", "ground station" (with its script).
///
/// Of the content, not of the files: comments, layout, the order of keys, where a part is written
/// and whether a default is written say nothing. Left out is what may differ between machines or
/// only one program reads: the scenario's name and file, rate (that of the clock's leader counts),
/// DDS vendors, faults (drawn cuts are in the radio), expectations, and interaction models, whose
/// versions are compared for each joint task (spec 7.3). Names of files are left
/// out; what is in them counts. A new field of these structs counts by itself. Precondition: faults
/// and variations were drawn, as the program flies it. Cost: linear in the content; 40 ms for the
/// largest terrain. Source: docs/decisions/0130-one-scenario.md.
SectionPrints print_of(const Scenario& scenario);

/// Of what is left out there and yet decides what a node does: faults and interaction models.
std::uint64_t print_of_own(const Scenario& scenario);

/// In which sections two scenarios differ, each as print_of().text(). Nothing: they cannot be
/// compared, as those of two versions of Skein.
std::optional<std::vector<std::string>> differing_sections(std::string_view one,
                                                           std::string_view other);

}  // namespace skein::scenario
