// SPDX-License-Identifier: Apache-2.0
// A ground station by itself, and what operators tell it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station::testing {

inline GroundControl control(std::vector<GroundUav> uavs, Script script = {}) {
  GroundConfig config;
  config.uavs = std::move(uavs);
  config.script = std::move(script);
  return {config, flat_terrain()};
}

inline OperatorCommand command(Request request, const std::string& uav = "marvin") {
  return {uav, std::move(request), Duration::seconds(60)};
}

}  // namespace skein::ground_station::testing
