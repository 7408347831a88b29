// SPDX-License-Identifier: Apache-2.0
// Objects that a ground station is to follow.
#pragma once

#include <string>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::ground_station {

/// An object that missions name and that does not stay where it is: a fire front, a vehicle.
struct ObjectSpec {
  std::string name;
  std::string kind;                                 ///< as sensors report it
  world::Vector3 thought = world::Vector3::Zero();  ///< where it is before it is seen [m] ENU
  double reach = 100;  ///< how far from there it may be when it is seen first [m], > 0
  double drift = 1;  ///< standard deviation of how far it gets in a second, per axis [m/√s], > 0
};

/// Why they cannot be followed, in sentences, all at once.
std::vector<std::string> problems_of(const std::vector<ObjectSpec>& objects);

}  // namespace skein::ground_station
