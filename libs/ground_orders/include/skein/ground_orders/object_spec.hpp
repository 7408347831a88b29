// SPDX-License-Identifier: Apache-2.0
// Objects that the ground station is to track.
#pragma once

#include <string>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::ground_station {

/// A moving object that missions may name: a fire front, a vehicle.
struct ObjectSpec {
  std::string name;
  std::string kind;                                 ///< as sensors report it
  world::Vector3 thought = world::Vector3::Zero();  ///< assumed position before a sighting [m] ENU
  double reach = 100;  ///< greatest distance of the first sighting from there [m], > 0
  double drift = 1;    ///< of the random walk: standard deviation per axis [m/√s], > 0
};

/// Why the objects cannot be tracked, in sentences, all at once; empty when the list is fine.
std::vector<std::string> problems_of(const std::vector<ObjectSpec>& objects);

}  // namespace skein::ground_station
