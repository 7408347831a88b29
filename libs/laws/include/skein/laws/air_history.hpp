// SPDX-License-Identifier: Apache-2.0
// What UAVs told of the air that they wait for.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::journal {
struct Written;
namespace lines {
struct Air;
}
}  // namespace skein::journal

namespace skein::laws {

/// From then on a UAV waits until these others leave the air that it wants; none: it waits for
/// nobody, as it has air, gave its motion up, or waits for answers.
struct AirWait {
  double at = 0;
  std::string uav;
  std::set<std::string> for_others;
};

/// In the order of time.
struct AirHistory {
  std::vector<AirWait> waits;

  /// False: a line of its kind that cannot be read.
  bool see(const journal::Record& record);
  void hear(const journal::lines::Air& line, const journal::Written& when);
};

}  // namespace skein::laws
