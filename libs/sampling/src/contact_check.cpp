// SPDX-License-Identifier: Apache-2.0
#include "contact_check.hpp"

#include <algorithm>
#include <cmath>

namespace skein::sampling {

using world::Vector3;

ContactCheck::ContactCheck(const refiners::Contact& contact, const world::World& world)
    : world_(world), stations_{contact.with} {
  std::vector<Vector3> apart = contact.relays;
  for (std::size_t i = 0; i < stations_.size(); ++i)
    for (auto relay = apart.begin(); relay != apart.end();) {
      if (linked(stations_[i], *relay)) {
        stations_.push_back(*relay);
        relay = apart.erase(relay);
      } else {
        ++relay;
      }
    }
}

bool ContactCheck::linked(const Vector3& a, const Vector3& b) const {
  return world_.radio.link(a, b, world_.terrain, false).up;
}

bool ContactCheck::has_link(const Vector3& point) const {
  return std::any_of(stations_.begin(), stations_.end(),
                     [&](const Vector3& station) { return linked(station, point); });
}

/// Widely spaced samples first: where contact is lost, it is lost over more than a metre as a rule.
bool ContactCheck::has_link(const Vector3& from, const Vector3& to) const {
  if (!has_link(from) || !has_link(to)) return false;
  const double wanted = std::max(1.0, std::ceil((to - from).norm() / kContactSpacing));
  std::size_t samples = 1;
  while (static_cast<double>(samples) < wanted) samples *= 2;
  for (std::size_t stride = samples / 2; stride > 0; stride /= 2)
    for (std::size_t i = stride; i < samples; i += 2 * stride) {
      const double part = static_cast<double>(i) / static_cast<double>(samples);
      if (!has_link(from + part * (to - from))) return false;
    }
  return true;
}

}  // namespace skein::sampling
