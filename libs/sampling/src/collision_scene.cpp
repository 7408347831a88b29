// SPDX-License-Identifier: Apache-2.0
// The only file with FCL headers.
#include "skein/sampling/collision_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ground_mesh.hpp"
#include "polygon_triangles.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::sampling {
namespace {

using world::Vector2;
using world::Vector3;
using Ground = fcl::BVHModel<fcl::OBBd>;

constexpr double kLeastRadius = 1e-3;
/// How far beyond the airspace prisms without floor or ceiling reach, and the ground [m].
constexpr double kBeyond = 50;
/// To which the begin of a conflict is found [m].
constexpr double kPlaceOfConflict = 0.1;

/// A ball on its way along a segment.
struct Sweep {
  Vector3 from, to;
  double radius;
};

Vector3 lowest_corner(const world::AirspaceGrid& grid) { return grid.origin; }
Vector3 highest_corner(const world::AirspaceGrid& grid) {
  return grid.origin + grid.voxel * Vector3(grid.size[0], grid.size[1], grid.size[2]);
}

/// The capsule, or ball, that a sweep covers.
fcl::CollisionObjectd body_of(const Sweep& sweep) {
  const Vector3 step = sweep.to - sweep.from;
  const double length = step.norm();
  if (length < 1e-9)
    return {std::make_shared<fcl::Sphered>(sweep.radius), fcl::Matrix3d::Identity(), sweep.from};
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), step);
  return {std::make_shared<fcl::Capsuled>(sweep.radius, length), turn.toRotationMatrix(),
          (sweep.from + sweep.to) / 2};
}

bool touch(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  const fcl::CollisionRequestd any_contact;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, any_contact, result) > 0;
}

std::shared_ptr<fcl::Convexd> prism_of(const std::array<Vector2, 3>& base, double floor,
                                       double ceiling) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z : {floor, ceiling})
    for (const Vector2& corner : base) vertices->emplace_back(corner.x(), corner.y(), z);
  // Counter-clockwise from outside: bottom, top, sides.
  const auto faces = std::make_shared<const std::vector<int>>(
      std::vector<int>{3, 0, 2, 1, 3, 3, 4, 5, 4, 0, 1, 4, 3, 4, 1, 2, 5, 4, 4, 2, 0, 3, 5});
  return std::make_shared<fcl::Convexd>(vertices, 5, faces);
}

}  // namespace

class CollisionScene::Parts {
 public:
  Parts(const world::World& world, const SceneSpec& spec)
      : low_(lowest_corner(world.airspace)),
        high_(highest_corner(world.airspace)),
        clearance_(spec.clearance),
        mesh_(world.terrain,
              {low_.x() - kBeyond, low_.y() - kBeyond, high_.x() + kBeyond, high_.y() + kBeyond},
              spec.ground_accuracy, kMostTriangles, spec.time_is_up) {
    whole_ = mesh_.is_whole() && build_ground(spec.time_is_up);
    if (!whole_) return;
    steepness_ = steepness();
    for (const auto* volumes : {&world.volumes, &spec.reserved})
      for (const world::Volume& volume : *volumes)
        if (volume.when.overlaps(spec.when)) add(volume);
    manager_.setup();
  }

  /// What it touches first in the order ground, volumes, limits; empty: nothing.
  std::string touched(const Sweep& sweep) const {
    const fcl::CollisionObjectd body = body_of(sweep);
    if (in_ground(sweep, body)) return "the ground";
    if (const std::string* name = volume_touched(body)) return "the volume '" + *name + "'";
    if (!within_limits(sweep.from) || !within_limits(sweep.to)) return "the limits of the airspace";
    return {};
  }
  bool touches(const Sweep& sweep) const {
    if (!within_limits(sweep.from) || !within_limits(sweep.to)) return true;
    const fcl::CollisionObjectd body = body_of(sweep);
    return volume_touched(body) || in_ground(sweep, body);
  }
  bool is_whole() const { return whole_; }
  std::size_t triangles() const { return mesh_.triangles().size(); }

 private:
  /// False when the time is up before. One model for each tile: no more is looked at than what is
  /// near, and the clock can be asked in between.
  bool build_ground(const std::function<bool()>& is_late) {
    for (const GroundMesh::Tile& tile : mesh_.tiles()) {
      if (is_late && is_late()) return false;
      ground_.push_back(model_of(tile));
    }
    return true;
  }

  std::shared_ptr<Ground> model_of(const GroundMesh::Tile& tile) const {
    const auto vertices = [&](std::size_t index) {
      return mesh_.vertices().begin() + static_cast<std::ptrdiff_t>(index);
    };
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(tile.end - tile.first);
    for (std::size_t i = tile.first; i < tile.end; ++i) {
      const auto& [a, b, c] = mesh_.triangles()[i];
      triangles.emplace_back(a - tile.first_vertex, b - tile.first_vertex, c - tile.first_vertex);
    }
    auto model = std::make_shared<Ground>();
    model->beginModel(static_cast<int>(triangles.size()),
                      static_cast<int>(tile.end_vertex - tile.first_vertex));
    model->addSubModel(std::vector<Vector3>(vertices(tile.first_vertex), vertices(tile.end_vertex)),
                       triangles);
    model->endModel();
    model->computeLocalAABB();
    return model;
  }

  void add(const world::Volume& volume) {
    const double floor = std::max(volume.floor, low_.z() - kBeyond);
    const double ceiling = std::min(volume.ceiling, high_.z() + kBeyond);
    if (floor >= ceiling) return;  // far above or below all that may be flown
    for (const auto& triangle : triangles_of(volume.polygon)) {
      prisms_.push_back(
          std::make_unique<fcl::CollisionObjectd>(prism_of(triangle, floor, ceiling)));
      prisms_.back()->computeAABB();
      names_.push_back(volume.name);
      manager_.registerObject(prisms_.back().get());
    }
  }

  bool within_limits(const Vector3& point) const {
    return (point.array() >= low_.array()).all() && (point.array() <= high_.array()).all();
  }

  /// By the centre over the ground lifted by the clearance, and by the body over the ground itself.
  /// One of them says the other: the body keeps as much height as its radius; and a height h over
  /// ground whose steepest slope is s is a distance of h cos(s) at least.
  bool in_ground(const Sweep& sweep, const fcl::CollisionObjectd& body) const {
    const double lowest = std::min(sweep.from.z(), sweep.to.z());
    if (lowest > mesh_.highest() + std::max(clearance_, sweep.radius)) return false;
    for (const Vector3& end : {sweep.from, sweep.to})
      if (end.z() < mesh_.height(end.x(), end.y()) + std::max(clearance_, sweep.radius))
        return true;
    if (clearance_ > sweep.radius &&
        meets_ground(body_of({sweep.from, sweep.to, kLeastRadius}), clearance_ - kLeastRadius))
      return true;
    return clearance_ < sweep.radius * steepness_ && meets_ground(body, 0);
  }

  /// By the geometries: an object for the ground would look at every vertex to find its box anew.
  bool meets_ground(const fcl::CollisionObjectd& body, double lift) const {
    const fcl::CollisionRequestd any_contact;
    const fcl::Transform3d lifted(Eigen::Translation3d(0, 0, lift));
    fcl::AABBd box = box_of(body);
    box.min_.z() -= lift;
    box.max_.z() -= lift;
    return std::any_of(ground_.begin(), ground_.end(), [&](const std::shared_ptr<Ground>& tile) {
      fcl::CollisionResultd result;
      return box.overlap(tile->aabb_local) &&
             fcl::collide(tile.get(), lifted, body.collisionGeometry().get(), body.getTransform(),
                          any_contact, result) > 0;
    });
  }

  static fcl::AABBd box_of(const fcl::CollisionObjectd& body) {
    fcl::CollisionObjectd boxed = body;
    boxed.computeAABB();
    return boxed.getAABB();
  }

  /// 1 / cos of the steepest slope.
  double steepness() const {
    double steepest = 1;
    const auto& at = mesh_.vertices();
    for (const auto& [a, b, c] : mesh_.triangles()) {
      const Vector3 normal = (at[b] - at[a]).cross(at[c] - at[a]);
      steepest = std::max(steepest, normal.norm() / std::abs(normal.z()));
    }
    return steepest;
  }

  struct Search {
    const fcl::CollisionObjectd* hit = nullptr;
  };
  static bool meet(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    auto* search = static_cast<Search*>(data);
    if (touch(*a, *b))
      search->hit = a->collisionGeometry()->getNodeType() == fcl::GEOM_CONVEX ? a : b;
    return search->hit != nullptr;
  }
  /// Of the first prism found, of any.
  const std::string* volume_touched(const fcl::CollisionObjectd& body) const {
    if (prisms_.empty()) return nullptr;
    fcl::CollisionObjectd moved = body;
    moved.computeAABB();
    Search search;
    manager_.collide(&moved, &search, meet);
    for (std::size_t i = 0; search.hit && i < prisms_.size(); ++i)
      if (prisms_[i].get() == search.hit) return &names_[i];
    return nullptr;
  }

  Vector3 low_, high_;
  double clearance_;
  GroundMesh mesh_;
  double steepness_ = 1;
  std::vector<std::shared_ptr<Ground>> ground_;  // of each tile
  bool whole_ = true;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> prisms_;
  std::vector<std::string> names_;  // of the volume each prism is part of
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

CollisionScene::CollisionScene(const world::World& world, const SceneSpec& spec) {
  SKEIN_EXPECTS(world::problems_of(world.airspace).empty());
  SKEIN_EXPECTS(spec.clearance >= 0 && spec.ground_accuracy > 0);
  parts_ = std::make_unique<const Parts>(world, spec);
}
CollisionScene::CollisionScene(CollisionScene&&) noexcept = default;
CollisionScene& CollisionScene::operator=(CollisionScene&&) noexcept = default;
CollisionScene::~CollisionScene() = default;

bool CollisionScene::is_whole() const { return parts_->is_whole(); }

bool CollisionScene::collides(const Vector3& point, double radius) const {
  return collides(point, point, radius);
}

bool CollisionScene::collides(const Vector3& from, const Vector3& to, double radius) const {
  return parts_->touches({from, to, std::max(radius, kLeastRadius)});
}

std::optional<Conflict> CollisionScene::first_conflict(const Vector3& point, double radius) const {
  return first_conflict(point, point, radius);
}

std::optional<Conflict> CollisionScene::first_conflict(const Vector3& from, const Vector3& to,
                                                       double radius) const {
  const double ball = std::max(radius, kLeastRadius);
  if (!parts_->touches({from, to, ball})) return std::nullopt;
  double free = 0, hit = 1;
  if (parts_->touches({from, from, ball})) hit = 0;
  while ((hit - free) * (to - from).norm() > kPlaceOfConflict) {
    const double middle = (free + hit) / 2;
    (parts_->touches({from, from + middle * (to - from), ball}) ? hit : free) = middle;
  }
  return Conflict{parts_->touched({from, from + hit * (to - from), ball}), hit};
}

std::size_t CollisionScene::ground_triangles() const { return parts_->triangles(); }

}  // namespace skein::sampling
