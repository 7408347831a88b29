// SPDX-License-Identifier: Apache-2.0
#include "circle.hpp"

#include <set>

namespace skein::merging {

Names circle_from(const std::string& start, const Names& its,
                  const std::function<const Names*(const std::string&)>& waits_for) {
  Names way;
  std::set<std::string> seen;
  const auto walk = [&](const auto& self, const std::string& name, const Names& next) -> bool {
    way.push_back(name);
    for (const std::string& one : next) {
      if (one == start) return true;
      const Names* further = waits_for(one);
      if (further == nullptr || !seen.insert(one).second) continue;
      if (self(self, one, *further)) return true;
    }
    way.pop_back();
    return false;
  };
  walk(walk, start, its);
  return way;
}

}  // namespace skein::merging
