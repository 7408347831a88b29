// SPDX-License-Identifier: Apache-2.0
// Who waits for whom, in a circle.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace skein::merging {

using Names = std::vector<std::string>;

/// From `start`, which waits for `its`, along who waits for whom, back to `start`: `start` first;
/// empty: there is no way back. `waits_for` of one that is not known: null. Cost: of each once.
Names circle_from(const std::string& start, const Names& its,
                  const std::function<const Names*(const std::string&)>& waits_for);

}  // namespace skein::merging
