// SPDX-License-Identifier: Apache-2.0
// The volumes that were closed during the mission.
#pragma once

#include <map>
#include <string>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Those that requests closed and that none has opened again since. A value; not safe to share
/// between threads.
class ClosedAir {
 public:
  /// No effect unless the request closes or opens a volume.
  void note(const Request& request);
  /// By name.
  const std::map<std::string, world::Volume>& volumes() const { return volumes_; }

 private:
  std::map<std::string, world::Volume> volumes_;
};

}  // namespace skein::ground_station
