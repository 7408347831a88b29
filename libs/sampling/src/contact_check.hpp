// SPDX-License-Identifier: Apache-2.0
// Radio contact along a path.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/world.hpp"

namespace skein::sampling {

/// Distance between two samples of a segment [m].
inline constexpr double kContactSpacing = 1;

/// Checks contact with a node, directly or via relays that have a chain of links to it. Lifetime:
/// the world must outlive this object.
class ContactCheck {
 public:
  ContactCheck(const refiners::Contact& contact, const world::World& world);

  bool has_link(const world::Vector3& point) const;
  /// Whether there is a link at both ends and at samples in between.
  bool has_link(const world::Vector3& from, const world::Vector3& to) const;

 private:
  bool linked(const world::Vector3& a, const world::Vector3& b) const;

  const world::World& world_;
  std::vector<world::Vector3> stations_;
};

}  // namespace skein::sampling
