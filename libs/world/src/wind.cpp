// SPDX-License-Identifier: Apache-2.0
#include "skein/world/wind.hpp"

namespace skein::world {

Vector3 mean_velocity(const Wind& wind) { return wind.speed * direction_of(wind.toward, 0); }

}  // namespace skein::world
