// SPDX-License-Identifier: Apache-2.0
#include "refinery/vehicle_start.hpp"

#include <array>
#include <cmath>

namespace skein::supervisor {

namespace {

using world::Vector3;

constexpr std::array<double, 3> kUntilBegun = {0, 1, 2};  // [s] in which it goes on as it was
constexpr double kSamePlace = 0.5;                        // [m]

}  // namespace

void VehicleStart::flies_on(const Vector3& from, double heading) {
  const double speed = vehicle_.cruise_speed;
  const auto after = [&](double seconds, double turn) {
    const double mean = heading + turn / 2;  // of the arc's chord
    const Vector3 there = from + seconds * speed * Vector3(std::cos(mean), std::sin(mean), 0);
    passing_.push_back({there, heading + turn, speed});
  };
  passing_.clear();
  for (const double seconds : kUntilBegun) after(seconds, 0);
  // It may have begun with a circle.
  const double turned = kUntilBegun.back() * speed / vehicle_.min_turn_radius;
  for (const double side : {-1.0, 1.0}) after(kUntilBegun.back(), side * turned);
}

bool VehicleStart::in_flight(const Departure& when) const {
  return !passing_.empty() && when.least <= kUntilBegun.back();
}

std::vector<Pose> VehicleStart::poses(const Vector3& from, bool in_flight, int headings) const {
  const bool flies =
      in_flight && !passing_.empty() && (from - passing_.front().at).norm() < kSamePlace;
  return flies ? passing_ : poses_at(from, vehicle_, headings);
}

}  // namespace skein::supervisor
