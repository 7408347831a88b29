// SPDX-License-Identifier: Apache-2.0
// The Dubins curves of refiners against OMPL's.
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

#include <numbers>

#include "skein/foundation/random.hpp"
#include "skein/refiners/dubins.hpp"

namespace skein::sampling {
namespace {

using refiners::Pose;

double length_by_ompl(const Pose& from, const Pose& to, double radius) {
  const auto space = std::make_shared<ompl::base::DubinsStateSpace>(radius);
  ompl::base::ScopedState<ompl::base::SE2StateSpace> a(space), b(space);
  a->setXY(from.at.x(), from.at.y());
  a->setYaw(from.heading);
  b->setXY(to.at.x(), to.at.y());
  b->setYaw(to.heading);
  return space->distance(a.get(), b.get());
}

TEST(DubinsCurve, IsAsLongAsOmplSays) {
  Random random(1);
  const auto pose = [&](double extent) {
    return Pose{{random.uniform(-extent, extent), random.uniform(-extent, extent)},
                random.uniform(-std::numbers::pi, std::numbers::pi)};
  };
  for (int i = 0; i < 10'000; ++i) {
    const double radius = random.uniform(1, 100), extent = random.uniform(1, 500);
    const Pose from = pose(extent), to = pose(extent);

    const double length = refiners::DubinsCurve::shortest(from, to, radius).length();

    const double by_ompl = length_by_ompl(from, to, radius);
    ASSERT_NEAR(length, by_ompl, 1e-9 * by_ompl) << i;
  }
}

}  // namespace
}  // namespace skein::sampling
