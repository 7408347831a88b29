// SPDX-License-Identifier: Apache-2.0
// Names in lists.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace skein::merging {

inline bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace skein::merging
