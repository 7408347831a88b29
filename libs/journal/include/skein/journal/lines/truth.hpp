// SPDX-License-Identifier: Apache-2.0
// What is so in the simulated world. docs/journal.md says when each is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// A vehicle; energy in [0, 1].
struct Telemetry {
  static constexpr std::string_view kKind = "telemetry";
  Text uav = {};
  std::vector<double> position = {};
  std::vector<double> velocity = {};
  double heading = 0;
  double energy = 0;
  bool airborne = false;

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("position", it.position);
    each("velocity", it.velocity);
    each("heading", it.heading);
    each("energy", it.energy);
    each("airborne", it.airborne);
  }
};

/// A thing of the world; of a fire that spreads also half its breadth [m] and its ignition.
struct Object {
  static constexpr std::string_view kKind = "object";
  Text name = {};
  Text type = {};
  std::vector<double> position = {};
  double radius = 0;
  bool active = false;
  std::optional<double> breadth = {};
  OptionalNumbers ignition = {};

  static void fields(auto& it, auto&& each) {
    each("name", it.name);
    each("type", it.type);
    each("position", it.position);
    each("radius", it.radius);
    each("active", it.active);
    each("breadth", it.breadth);
    each("ignition", it.ignition);
  }
};

/// A fault of the scenario.
struct Fault {
  static constexpr std::string_view kKind = "fault";
  Text what = {};
  Text target = {};

  static void fields(auto& it, auto&& each) {
    each("what", it.what);
    each("target", it.target);
  }
};

}  // namespace skein::journal::lines
