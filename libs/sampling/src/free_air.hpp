// SPDX-License-Identifier: Apache-2.0
// All that a way must keep to, for one query.
#pragma once

#include <optional>

#include "contact_check.hpp"
#include "skein/foundation/random.hpp"
#include "skein/refiners/path.hpp"
#include "skein/sampling/collision_scene.hpp"

namespace skein::sampling {

/// Clear of ground and volumes, within the airspace, not higher over the ground than the vehicle
/// may be, in radio contact if asked. Lifetime: world and query must outlive this.
class FreeAir {
 public:
  /// Volumes count that are there at some time from the departure until `until`.
  FreeAir(const refiners::PathQuery& query, const world::World& world, MissionTime until,
          const refiners::Budget& budget);

  /// False: the time was up before the scene was built. Then nothing else may be asked.
  bool is_whole() const { return scene_.is_whole(); }

  /// `margin` is added to the body [m].
  bool is_free(const world::Vector3& point, double margin) const;
  bool is_free(const world::Vector3& from, const world::Vector3& to, double margin) const;
  /// Why nobody can be at a point: `field` names it in the query.
  std::optional<refiners::Refusal> refusal_at(const world::Vector3& point,
                                              const std::string& field) const;

  world::Vector3 low() const;
  world::Vector3 high() const;
  /// Uniform over the map, and in height between the ground and as high as it may be there.
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
