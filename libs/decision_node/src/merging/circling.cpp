// SPDX-License-Identifier: Apache-2.0
#include "merging/circling.hpp"

#include <numbers>

namespace skein::decision_node {

namespace {

constexpr double kTurn = 1.25 * 2 * std::numbers::pi;  // radii that a turn is long, and some more
/// Radii that all places of a turn are apart at the most, as they are measured. Who flies on is
/// beyond that long before a turn's length.
constexpr double kWide = 3;

}  // namespace

void Circling::see(const world::VehicleState& state, MissionTime now) {
  if (!around_.isEmpty()) flown_ += state.velocity.head<2>().norm() * (now - last_).to_seconds();
  last_ = now;
  around_.extend(state.position);
  if (around_.sizes().head<2>().maxCoeff() <= kWide * radius_) return;
  around_ = Eigen::AlignedBox3d(state.position);
  flown_ = 0;
}

std::optional<Circle> Circling::seen() const {
  if (flown_ < kTurn * radius_) return std::nullopt;
  return Circle{around_.center().head<2>(), around_.diagonal().head<2>().norm() / 2,
                around_.min().z(), around_.max().z()};
}

}  // namespace skein::decision_node
