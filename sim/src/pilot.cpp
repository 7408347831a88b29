// SPDX-License-Identifier: Apache-2.0
#include "pilot.hpp"

#include <algorithm>
#include <utility>

namespace skein::sim {
namespace {
constexpr double kAutopilotPeriod = 5;  // [s]
/// Heights are held better than places: barometer and eye both tell them apart more easily.
constexpr double kVerticalShare = 0.5;
}  // namespace

Pilot::Pilot(const world::VehicleModel& model, Random random)
    : model_(model),
      period_(model.pilot ? model.pilot->attention_period : Duration::seconds(kAutopilotPeriod)),
      random_(std::move(random)) {}

Duration Pilot::reaction() {
  if (!model_.pilot) return {};
  const double mean = model_.pilot->reaction.to_seconds();
  const double spread = model_.pilot->reaction_spread.to_seconds();
  return Duration::seconds(std::max(mean / 5, mean + spread * random_.normal()));
}

void Pilot::attend(MissionTime now) {
  if (now < next_) return;
  next_ = now + period_;
  const double spread = world::tracking_spread(model_);
  const double east = bounded_normal(), north = bounded_normal(), up = bounded_normal();
  position_error_ = spread * world::Vector3(east, north, kVerticalShare * up);
  if (model_.pilot) heading_error_ = model_.pilot->heading_imprecision * bounded_normal();
}

double Pilot::bounded_normal() { return std::clamp(random_.normal(), -2.0, 2.0); }

}  // namespace skein::sim
