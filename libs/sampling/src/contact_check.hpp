// SPDX-License-Identifier: Apache-2.0
// Radio contact along a way.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/world.hpp"

namespace skein::sampling {

/// Between two samples of a segment [m].
inline constexpr double kContactSpacing = 1;

/// Who can be talked to: the entity itself and the relays that have a link to it, directly or
/// through others. Lifetime: the world must outlive this.
class ContactCheck {
 public:
  ContactCheck(const refiners::Contact& contact, const world::World& world);

  bool has_link(const world::Vector3& point) const;
  /// At both ends and at samples in between.
  bool has_link(const world::Vector3& from, const world::Vector3& to) const;

 private:
  bool linked(const world::Vector3& a, const world::Vector3& b) const;

  const world::World& world_;
  std::vector<world::Vector3> stations_;
};

}  // namespace skein::sampling
