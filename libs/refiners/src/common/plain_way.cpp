// SPDX-License-Identifier: Apache-2.0
#include "common/plain_way.hpp"

namespace skein::refiners {

Way without_repeats(const Way& way) {
  Way plain;
  for (const world::Vector3& point : way)
    if (plain.empty() || (point - plain.back()).norm() > kSamePoint) plain.push_back(point);
  if (plain.size() > 1) plain.back() = way.back();
  return plain;
}

}  // namespace skein::refiners
