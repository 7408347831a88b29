// SPDX-License-Identifier: Apache-2.0
#include "gusts.hpp"

#include <cmath>
#include <utility>

namespace skein::sim {
namespace {
constexpr double kCorrelationTime = 5;  // [s]
}

Gusts::Gusts(const world::Wind& wind, Random random)
    : mean_(world::mean_velocity(wind)), deviation_(wind.gusts), random_(std::move(random)) {}

world::Vector3 Gusts::next(double dt) {
  if (deviation_ <= 0) return mean_;
  const double kept = std::exp(-dt / kCorrelationTime);
  const double fresh = deviation_ * std::sqrt(1 - kept * kept);
  const double east = random_.normal(), north = random_.normal();
  gust_ = gust_ * kept + world::Vector2(east, north) * fresh;
  return mean_ + world::Vector3(gust_.x(), gust_.y(), 0);
}

}  // namespace skein::sim
