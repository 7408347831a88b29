// SPDX-License-Identifier: Apache-2.0
#include "voxel_boxes.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <Eigen/Geometry>
#include <vector>

namespace skein::sampling {

using world::Vector3;
using world::Voxel;

class VoxelBoxes::Parts {
 public:
  explicit Parts(const world::Airspace& airspace) : grid_(airspace.grid()) {
    const auto box = std::make_shared<fcl::Boxd>(
        Vector3::Constant(grid_.voxel * (1 - 2 * kHair) - 2 * radius()));
    for (std::int32_t z = 0; z < grid_.size[2]; ++z)
      for (std::int32_t y = 0; y < grid_.size[1]; ++y)
        for (std::int32_t x = 0; x < grid_.size[0]; ++x)
          if (!airspace.is_free(x, y, z)) add(box, airspace.centre(Voxel{x, y, z}));
    manager_.setup();
  }

  bool meets(const Vector3& from, const Vector3& to) const {
    if (!is_within(from) || !is_within(to)) return true;
    const Vector3 step = to - from;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), step);
    fcl::CollisionObjectd body(std::make_shared<fcl::Capsuled>(radius(), step.norm()),
                               turn.toRotationMatrix(), (from + to) / 2);
    body.computeAABB();
    bool met = false;
    manager_.collide(&body, &met,
                     [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* met_) {
                       fcl::CollisionResultd result;
                       if (fcl::collide(a, b, fcl::CollisionRequestd(), result) > 0)
                         *static_cast<bool*>(met_) = true;
                       return *static_cast<bool*>(met_);
                     });
    return met;
  }

 private:
  double radius() const { return grid_.voxel * kHair / 10; }

  void add(const std::shared_ptr<fcl::Boxd>& box, const Vector3& centre) {
    boxes_.push_back(
        std::make_unique<fcl::CollisionObjectd>(box, fcl::Matrix3d::Identity(), centre));
    boxes_.back()->computeAABB();
    manager_.registerObject(boxes_.back().get());
  }

  bool is_within(const Vector3& point) const {
    const Vector3 high =
        grid_.origin + grid_.voxel * Vector3(grid_.size[0], grid_.size[1], grid_.size[2]);
    return (point.array() >= grid_.origin.array()).all() && (point.array() <= high.array()).all();
  }

  world::AirspaceGrid grid_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> boxes_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

VoxelBoxes::VoxelBoxes(const world::Airspace& airspace)
    : parts_(std::make_unique<Parts>(airspace)) {}
VoxelBoxes::~VoxelBoxes() = default;

bool VoxelBoxes::meets(const refiners::Way& way) const {
  for (std::size_t i = 1; i < way.size(); ++i)
    if (parts_->meets(way[i - 1], way[i])) return true;
  return false;
}

}  // namespace skein::sampling
