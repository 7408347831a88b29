// SPDX-License-Identifier: Apache-2.0
// The path service by random trees in continuous space, for airspaces unsuited to voxels.
#pragma once

#include <cstdint>

#include "skein/refiners/path.hpp"

namespace skein::sampling {

struct SamplingOptions {
  /// Samples for a first path if the budget has no bound, neither of time nor of steps.
  std::uint64_t first_samples = 20'000;
  /// Most samples for shortening the path, whatever the budget allows.
  std::uint64_t shortening_samples = 2'000;
};

/// A first way by RRT-Connect, made shorter by shortcuts, then a shorter one by RRT* on samples of
/// the ellipsoid that can hold one (both by OMPL), each edge checked against the ground, the
/// volumes and the limits of the airspace by FCL (CollisionScene), against the vehicle's ceiling
/// and, every metre, for radio contact. For a vehicle that cannot hover the way is then made
/// flyable. Crossing costs 1 everywhere: the cost is the length [m]. Steps of the budget: states
/// sampled.
///
/// The same seed gives the same path, whatever OMPL was used for before in the process. Refusals
/// are those of VoxelPathPlanner with two differences: sampling cannot prove that no path exists,
/// so a path that was not found is kBudgetExhausted; and paths may pass where no whole voxel is
/// free. Source: spec 4.2 (OMPL and FCL, same interface).
class SamplingPathPlanner final : public refiners::PathPlanner {
 public:
  SamplingPathPlanner() = default;
  explicit SamplingPathPlanner(const SamplingOptions& options) : options_(options) {}

  refiners::Outcome<refiners::Path> plan(const refiners::PathQuery& query,
                                         const refiners::Setting& setting) const override;

 private:
  SamplingOptions options_;
};

}  // namespace skein::sampling
