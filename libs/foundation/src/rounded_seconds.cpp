// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/rounded_seconds.hpp"

#include <cmath>
#include <cstdint>

namespace skein {

std::string in_seconds(Duration d) {
  if (d == Duration::max()) return "for ever";
  const std::int64_t tenths = std::llround(d.to_seconds() * 10);
  return to_text(Duration::milliseconds(100 * tenths)) + " s";
}

std::string in_seconds(MissionTime t) {
  return t == MissionTime::max() ? "for ever" : in_seconds(t - MissionTime());
}

}  // namespace skein
