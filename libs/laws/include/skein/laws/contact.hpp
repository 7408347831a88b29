// SPDX-License-Identifier: Apache-2.0
// Law on contacts between nodes.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// Breaches, with their instants, of the law that nobody is in contact whom the radio does not
/// connect: when a node says that it reaches another (`reach` lines), then by the `link` lines, the
/// truth, that one's link to it, or one after another past relays of the scenario, was up at that
/// instant or half a second before (more on narrow links: by the airtime of a few events). For
/// missions in virtual time: over DDS nodes hear each other
/// before the mission begins. No breaches are reported if the simulator died, or tells nothing.
/// Cost: the log, and for each contact the changes of the links concerned.
std::vector<std::string> broken_contacts(const scenario::Scenario& scenario,
                                         const std::vector<journal::Record>& records);

}  // namespace skein::laws
