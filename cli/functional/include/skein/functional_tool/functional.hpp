// SPDX-License-Identifier: Apache-2.0
// `skein functional`: checks a functional layer against its contract (docs/functional-layer.md).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "skein/blackboard/network.hpp"

namespace skein::functional_tool {

struct FunctionalOptions {
  std::string scenario;
  std::string uav;            ///< empty: the scenario's only one
  bool virtual_time = false;  ///< against the simulator of this process
  std::uint32_t domain = 0;   ///< DDS domain
  blackboard::NetworkConfig network;
  double rate = 1;     ///< mission seconds per second, over DDS
  double height = 30;  ///< of the flight over the ground [m]
  double reach = 60;   ///< of the flight from the start [m]
  double near = 10;    ///< of a way-point that counts as reached [m]
  /// Over DDS: also what holds after a restart; it says when somebody is to kill the layer and
  /// start it again. In virtual time that is always checked.
  bool restarts = false;
  bool json = false;  ///< one JSON document instead of lines
};

/// Plays the UAV's decision node, and over DDS leads the clock, until every point is decided.
/// Returns the exit code (docs/exit-codes.md): 1 when a point is not kept.
int check(const FunctionalOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::functional_tool
