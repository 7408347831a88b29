// SPDX-License-Identifier: Apache-2.0
// Ways of vehicles that keep to the ground.
#include "refinery/ways.hpp"
#include "skein/refiners/driving.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

/// Where partners wait is no concern: who drives keeps clear of others by sight.
Answer<Motion> Ways::drive(const world::Airspace& map, const Volumes& volumes, const Vector3& from,
                           const Vector3& to) const {
  const Vector3 begin = gazetteer().above(from), end = gazetteer().above(to);
  if (begin == end) return driven({begin});
  if (const auto* volume = air_.taking_room(end, volumes); volume != nullptr)
    return no("volume '" + volume->name + "' is nearer to its end than the vehicle strays");
  const refiners::DrivingPlanner planner(map);
  auto refined = planner.plan(air_.query(begin, end), air_.setting());
  if (!refined) return no(refined.error().why);
  return driven(std::move(refined->task.way));
}

Motion Ways::driven(Way way) const {
  const Way track = refiners::draped(way, world().terrain);
  const refiners::Flight drive = refiners::estimate_flight(track, vehicle(), world().wind);
  Motion motion{std::move(way), {}, 0, {}};
  motion.times = driving_times(motion.way, vehicle());
  const double estimate = drive.duration.expected.to_seconds();
  motion.energy = drive.energy + energy_of_stay(std::max(0.0, motion.times.expected - estimate));
  return motion;
}

}  // namespace skein::supervisor
