// SPDX-License-Identifier: Apache-2.0
// Small domains and problems at random, small enough that all their plans can be listed.
#pragma once

#include <cstdint>
#include <string>

namespace skein::htn::oracle {

/// The text of a file with one domain `d` and one problem `p`. The same seed gives the same text.
/// All parts of the language that bear on the search occur; axioms and methods recurse, axioms
/// only along a fact that nothing changes.
std::string random_domain(std::uint64_t seed);

}  // namespace skein::htn::oracle
