// SPDX-License-Identifier: Apache-2.0
#include "testing/mapping_ends.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace skein::testing {

double MappingEnds::latest() const {
  double last = 0;
  for (const auto& [uav, end] : ends) last = std::max(last, end);
  return last;
}

double MappingEnds::spread(const std::vector<std::string>& uavs) const {
  double first = std::numeric_limits<double>::infinity(), last = 0;
  for (const auto& [uav, end] : ends) {
    if (!uavs.empty() && std::find(uavs.begin(), uavs.end(), uav) == uavs.end()) continue;
    first = std::min(first, end);
    last = std::max(last, end);
  }
  return (last - first) / (last - begin);
}

MappingEnds mapping_ends(const std::vector<journal::Record>& records) {
  MappingEnds all;
  all.begin = std::numeric_limits<double>::infinity();
  for (const journal::Record& record : records) {
    if (record.kind() != "functional") continue;
    const double at = record.at().to_seconds();
    if (record.text("type") == "goto" && record.text("state") == "running")
      all.begin = std::min(all.begin, at);
    // A look along a way is stopped when the way ends: then it is aborted, by the vehicle's word.
    if (record.text("type") == "takeshot" && record.text("state") != "running")
      all.ends[std::string(record.text("uav"))] = at;
  }
  return all;
}

}  // namespace skein::testing
