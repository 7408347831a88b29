// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/view_of.hpp"

#include <cmath>

namespace skein::elementary {

using world::Vector3;

world::View view_of(const world::SensorModel& sensor, const world::VehicleState& state,
                    const std::optional<Vector3>& target, double pointing_error) {
  world::View view{state.position, world::direction_of(state.heading, sensor.boresight_pitch),
                   sensor.range, sensor.aperture};
  if (!sensor.gimballed || !target) return view;
  const Vector3 offset = *target - state.position;
  const double distance = offset.norm();
  if (distance < 1e-6) return view;
  const double heading = std::atan2(offset.y(), offset.x()) + pointing_error;
  view.direction = world::direction_of(heading, std::asin(offset.z() / distance));
  return view;
}

}  // namespace skein::elementary
