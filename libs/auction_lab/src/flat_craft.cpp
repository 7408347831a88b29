// SPDX-License-Identifier: Apache-2.0
#include "skein/auction_lab/flat_craft.hpp"

#include <cmath>

namespace skein::auction {

Place FlatCraft::place(Stopover of) const {
  if (of.is_begin()) return vehicle_.begin;
  return of.is_end() ? *vehicle_.end : catalogue_->task(of.task()).at;
}

std::optional<Leg> FlatCraft::leg(Stopover from, Stopover to) const {
  if (to.is_end() && !vehicle_.end) return Leg{};
  const Place a = place(from), b = place(to);
  const double metres = std::hypot(a.x - b.x, a.y - b.y);
  return Leg{metres / vehicle_.speed, metres, metres};
}

}  // namespace skein::auction
