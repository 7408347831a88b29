// SPDX-License-Identifier: Apache-2.0
// What is believed of the wind.
#include <algorithm>
#include <cmath>

#include "core.hpp"

namespace skein::supervisor {

namespace {

// The wind is believed to be another when it is known well and differs by much [m/s].
constexpr double kWindKnown = 0.6, kOtherWind = 0.75;
constexpr double kSure = 2.5;  // deviations

}  // namespace

// Plans from now on reckon with the wind that is felt, once it is known to be another. What is
// planned keeps its dates: what takes longer shows by itself.
void Supervisor::Core::feel_wind() {
  const world::Wind felt = wind_.wind();
  const double off = (world::mean_velocity(felt) - world::mean_velocity(world_->wind)).norm();
  if (wind_.spread() > kWindKnown || off < std::max(kOtherWind, kSure * wind_.spread())) return;
  auto changed = std::make_shared<world::World>(*world_);
  changed->wind = felt;
  world_ = std::move(changed);
  ++world_revision_;
  const auto figure = [](double value) {
    return to_text(Duration::seconds(std::round(10 * value) / 10));
  };
  notice("the wind is felt to be " + figure(felt.speed) + " m/s towards " +
         figure(felt.toward * 180 / M_PI) + " degrees north of east");
}

}  // namespace skein::supervisor
