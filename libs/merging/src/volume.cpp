// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/volume.hpp"

#include <algorithm>

#include "skein/world/segment.hpp"

namespace skein::merging {

bool overlap(const Volume& one, const Volume& other) {
  if (one.ceiling <= other.floor || other.ceiling <= one.floor) return false;
  return world::between_segments(one.from, one.to, other.from, other.to) <
         one.radius + other.radius;
}

bool overlap(const Volumes& some, const Volumes& others) {
  return std::any_of(some.begin(), some.end(), [&](const Volume& one) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Volume& other) { return overlap(one, other); });
  });
}

}  // namespace skein::merging
