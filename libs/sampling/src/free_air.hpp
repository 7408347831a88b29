// SPDX-License-Identifier: Apache-2.0
// Free space of one path query.
#pragma once

#include <optional>

#include "contact_check.hpp"
#include "skein/foundation/random.hpp"
#include "skein/refiners/path.hpp"
#include "skein/sampling/collision_scene.hpp"

namespace skein::sampling {

/// Free: clear of ground and volumes, within the airspace, below the vehicle's ceiling over the
/// ground, and in radio contact if the query requires it. Lifetime: world and query must outlive
/// this object.
class FreeAir {
 public:
  /// Volumes count if their window overlaps the time from the departure to `until`.
  FreeAir(const refiners::PathQuery& query, const world::World& world, MissionTime until,
          const refiners::Budget& budget);

  /// False: the time was up before the scene was built; then no other method may be called.
  bool is_whole() const { return scene_.is_whole(); }

  /// `margin` is added to the body [m].
  bool is_free(const world::Vector3& point, double margin) const;
  bool is_free(const world::Vector3& from, const world::Vector3& to, double margin) const;
  /// The refusal of a point that is not free; `field` names it in the query.
  std::optional<refiners::Refusal> refusal_at(const world::Vector3& point,
                                              const std::string& field) const;

  world::Vector3 low() const;
  world::Vector3 high() const;
  /// A random point: uniform over the map, and in height between the ground and the upper limit.
  world::Vector3 any_point(Random& random) const;

 private:
  double height(const world::Vector3& point) const;
  bool is_low_enough(const world::Vector3& from, const world::Vector3& to) const;

  const refiners::PathQuery& query_;
  const world::World& world_;
  CollisionScene scene_;
  std::optional<ContactCheck> contact_;
};

}  // namespace skein::sampling
