// SPDX-License-Identifier: Apache-2.0
#include "skein/world/sensor_model.hpp"

#include <algorithm>
#include <cmath>

namespace skein::world {

bool in_view(const View& view, const Vector3& centre, double radius) {
  const Vector3 offset = centre - view.viewpoint;
  const double distance = offset.norm();
  if (distance <= radius) return true;
  if (distance - radius > view.range) return false;
  const double off_axis = std::acos(std::clamp(offset.dot(view.direction) / distance, -1.0, 1.0));
  return off_axis - std::asin(radius / distance) <= view.aperture;
}

double distance_quality(const SensorModel& sensor, double distance) {
  if (!(distance <= sensor.range)) return 0;
  const QualityModel& quality = sensor.quality;
  if (distance <= quality.best_distance) return 1;
  const double part = (distance - quality.best_distance) / (sensor.range - quality.best_distance);
  return 1 - (1 - quality.at_range) * part;
}

double incidence_quality(const SensorModel& sensor, double cosine) {
  const double power = sensor.quality.incidence_power;
  if (power == 0) return 1;
  return cosine > 0 ? std::pow(std::min(cosine, 1.0), power) : 0;
}

double perceived_quality(const SensorModel& sensor, const Vector3& viewpoint, const Vector3& target,
                         const Vector3& normal) {
  const Vector3 offset = viewpoint - target;
  const double distance = offset.norm();
  const double cosine = distance > 0 ? offset.dot(normal) / distance : 1;
  return distance_quality(sensor, distance) * incidence_quality(sensor, cosine);
}

}  // namespace skein::world
