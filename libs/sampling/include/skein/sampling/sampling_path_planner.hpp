// SPDX-License-Identifier: Apache-2.0
// path, by random trees in the continuous air: for spaces where voxels are the wrong tool.
#pragma once

#include <cstdint>

#include "skein/refiners/path.hpp"

namespace skein::sampling {

struct SamplingOptions {
  /// Samples drawn for a first way where the budget sets no bound, neither of time nor of steps.
  std::uint64_t first_samples = 20'000;
  /// Samples drawn at most to shorten it, whatever the budget allows.
  std::uint64_t shortening_samples = 2'000;
};

/// A first way by RRT-Connect, made shorter by shortcuts, then a shorter one by RRT* on samples of
/// the ellipsoid that can hold one (both by OMPL), each edge checked against the ground, the
/// volumes and the limits of the airspace by FCL (CollisionScene), against the vehicle's ceiling
/// and, every metre, for radio contact. For a vehicle that cannot hover the way is then made
/// flyable. Crossing costs 1 everywhere: the cost is the length [m]. Steps of the budget: states
/// sampled.
///
/// The same seed gives the same way, whatever OMPL was used for before in the process. Refused as
/// by the voxels, but for two things. Sampling cannot prove that every way is closed: what was not
/// found is kBudgetExhausted. And the way may pass where no whole voxel is free. Source: spec 4.2
/// (OMPL and FCL, same interface).
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
