// SPDX-License-Identifier: Apache-2.0
// When the UAVs of a mission were done with what they mapped, by the simulator's word.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::testing {

struct MappingEnds {
  double begin = 0;                    ///< [s] when the first of them set out
  std::map<std::string, double> ends;  ///< [s] of the last look of each with its mapping camera

  double latest() const;
  /// [s] from the first setting out to the last end.
  double makespan() const { return latest() - begin; }
  /// (latest - earliest) / makespan of those named; of all without names.
  double spread(const std::vector<std::string>& uavs = {}) const;
};

/// Of a log in the order of time.
MappingEnds mapping_ends(const std::vector<journal::Record>& records);

}  // namespace skein::testing
