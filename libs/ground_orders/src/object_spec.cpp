// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_orders/object_spec.hpp"

#include <cmath>
#include <set>

namespace skein::ground_station {

std::vector<std::string> problems_of(const std::vector<ObjectSpec>& objects) {
  std::vector<std::string> problems;
  std::set<std::string> names;
  for (const ObjectSpec& one : objects) {
    const std::string which = "object '" + one.name + "': ";
    if (one.name.empty()) problems.emplace_back("an object has a name");
    if (!names.insert(one.name).second) problems.push_back(which + "the name is taken");
    if (one.kind.empty()) problems.push_back(which + "no kind");
    if (!one.thought.allFinite()) problems.push_back(which + "its place is not finite");
    if (!(one.reach > 0) || !std::isfinite(one.reach))
      problems.push_back(which + "reach must be positive");
    if (!(one.drift > 0) || !std::isfinite(one.drift))
      problems.push_back(which + "drift must be positive");
  }
  return problems;
}

}  // namespace skein::ground_station
