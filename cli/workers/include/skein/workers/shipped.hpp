// SPDX-License-Identifier: Apache-2.0
// Files shipped with this program.
#pragma once

#include <string>

namespace skein::workers {

/// The folder scenarios/ of Skein: beside an installed program, or in the tree that it was built
/// from; empty when there is none.
std::string shipped_scenarios();

}  // namespace skein::workers
