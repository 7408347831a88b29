// SPDX-License-Identifier: Apache-2.0
// What a vehicle may run into, as FCL sees it: an opinion of its own on whether a way is free.
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
  world::TimeWindow when = {};               ///< only volumes whose window overlaps it are there
  /// The ground is made of triangles that are never below the true, bilinear, surface, and nowhere
  /// above it by more than this [m], > 0; but see kMostTriangles.
  double ground_accuracy = 0.25;
  /// Asked now and then while the scene is built, if it is not empty; once it says so the scene is
  /// not whole.
  std::function<bool()> time_is_up = {};
};

/// Where the airspace holds so much rough ground that more triangles would be needed, the accuracy
/// is lessened, and at last the cells are merged (to the highest of them), so that the ground stays
/// conservative and memory bounded (some 200 MB).
inline constexpr std::size_t kMostTriangles = 400'000;

/// What is hit first.
struct Conflict {
  std::string with;  ///< "the ground", "the volume 'power line'", "the limits of the airspace"
  double along = 0;  ///< fraction of the segment at which it begins, found to 0.1 m
  bool operator==(const Conflict&) const = default;
};

/// The ground, the volumes (upright prisms, concave ones too) and the limits of the airspace, for
/// bodies that are balls. Every question takes the radius of the ball [m], >= 0; less than a
/// millimetre counts as one. The ground is kept away from by the clearance at the centre of the
/// body, and by the body itself. The limits are those of the centre. Built apart from the voxels:
/// by FCL alone, from the terrain and polygons themselves. Building takes time by the ground: some
/// microseconds a triangle, in pieces of some milliseconds. Reading is const and safe from any
/// thread. Source: spec 4.2 (FCL collision checks).
class CollisionScene {
 public:
  /// Preconditions: problems_of(world.airspace) is empty; volumes have simple polygons with at
  /// least three corners, and floors below their ceilings.
  CollisionScene(const world::World& world, const SceneSpec& spec);
  CollisionScene(CollisionScene&&) noexcept;
  CollisionScene& operator=(CollisionScene&&) noexcept;
  ~CollisionScene();

  /// False: the time was up before it was built. Then nothing else may be asked.
  bool is_whole() const;

  bool collides(const world::Vector3& point, double radius) const;
  /// Everything that the ball touches on its straight way: no steps, a capsule.
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
