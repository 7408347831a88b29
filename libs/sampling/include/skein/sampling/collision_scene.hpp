// SPDX-License-Identifier: Apache-2.0
// Collision checks by FCL, independent of the voxels.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/world/world.hpp"

namespace skein::sampling {

struct SceneSpec {
  double clearance = 0;  ///< least height of a body's centre over the ground [m], >= 0
  std::vector<world::Volume> reserved = {};  ///< beside those of the world
  world::TimeWindow when = {};               ///< only volumes whose window overlaps this one count
  /// Accuracy of the ground's triangles [m], > 0: never below the true (bilinear) surface, and at
  /// most this much above it; but see kMostTriangles.
  double ground_accuracy = 0.25;
  /// Polled while the scene is built (may be empty); after it has returned true the scene is
  /// incomplete.
  std::function<bool()> time_is_up = {};
};

/// Most triangles of the ground. If rough ground would need more, the accuracy is reduced, and at
/// last cells are merged (to the highest of them), so that the ground stays conservative and memory
/// bounded (some 200 MB).
inline constexpr std::size_t kMostTriangles = 400'000;

/// The first obstacle on a segment.
struct Conflict {
  std::string with;  ///< "the ground", "the volume 'power line'", "the limits of the airspace"
  double along = 0;  ///< fraction of the segment at which contact begins, to 0.1 m
  bool operator==(const Conflict&) const = default;
};

/// The ground, the volumes (upright prisms, also concave) and the limits of the airspace, as
/// obstacles for a spherical body. Every query takes the radius of the body [m], >= 0; less than 1
/// mm counts as 1 mm. The centre of the body keeps the clearance over the ground, and its surface
/// does not touch it; the limits of the airspace apply to the centre. Built from terrain and
/// polygons by FCL alone, without voxels, in some microseconds per triangle, in pieces of some
/// milliseconds. Queries are const and safe from any thread. Source: spec 4.2 (FCL collision
/// checks).
class CollisionScene {
 public:
  /// Preconditions: problems_of(world.airspace) is empty; volumes have simple polygons with at
  /// least three corners, and floors below their ceilings.
  CollisionScene(const world::World& world, const SceneSpec& spec);
  CollisionScene(CollisionScene&&) noexcept;
  CollisionScene& operator=(CollisionScene&&) noexcept;
  ~CollisionScene();

  /// False: the time was up before the scene was built; then no other method may be called.
  bool is_whole() const;

  bool collides(const world::Vector3& point, double radius) const;
  /// Whether the body touches anything on the straight segment; exact (a capsule, no sampling).
  bool collides(const world::Vector3& from, const world::Vector3& to, double radius) const;

  std::optional<Conflict> first_conflict(const world::Vector3& point, double radius) const;
  std::optional<Conflict> first_conflict(const world::Vector3& from, const world::Vector3& to,
                                         double radius) const;

  std::size_t ground_triangles() const;

 private:
  class Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace skein::sampling
