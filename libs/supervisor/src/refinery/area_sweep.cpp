// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/area_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "refinery/refinery.hpp"
#include "refinery/sweeps.hpp"
#include "refinery/zone_shapes.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr std::uint64_t kSeed = 1;
/// Of a device that sees as far as its lanes ask for.
constexpr double kFar = 10;
/// What a sweep may begin late, in air that it is given late [s].
constexpr double kLate = 60;
constexpr Duration kLooks = Duration::milliseconds(500);

Answer<const world::SensorModel*> device_of(const Knowledge& knowledge, const std::string& name) {
  const world::SensorModel* device = world::find_sensor(knowledge.vehicle, name);
  if (device == nullptr) return no(knowledge.uav + " has no device '" + name + "'");
  return device;
}

double height_of(const Knowledge& knowledge) {
  return std::min(knowledge.altitude, knowledge.vehicle.ceiling);
}

Answer<AreaSweep> sweep_in(Refinery& refinery, const Vector3& from, const world::Zone& zone,
                           const world::SensorModel& device, const Departure& when) {
  const auto lanes = refinery.sweeps.over(from, zone, device, when);
  if (!lanes) return no(lanes.error());
  const auto there = refinery.ways.path(from, lanes->way.front(), when);
  if (!there) return no(there.error());
  AreaSweep sweep;
  sweep.way = there->way;
  sweep.lanes = sweep.way.empty() ? 0 : sweep.way.size() - 1;
  if (!sweep.way.empty()) sweep.way.pop_back();
  sweep.way.insert(sweep.way.end(), lanes->way.begin(), lanes->way.end());
  sweep.seconds = there->times.expected + lanes->times.expected;
  sweep.shortest = there->times.least + lanes->times.least;
  sweep.longest = there->times.most + lanes->times.most;
  sweep.energy = there->energy + lanes->energy;
  return sweep;
}

}  // namespace

namespace {

using Air = std::shared_ptr<const world::World>;
using Sweep = std::function<Answer<AreaSweep>(const Air&, const Departure&)>;

/// The world with those of its volumes.
Air only(const world::World& world, const auto& counts) {
  auto some = std::make_shared<world::World>(world);
  std::erase_if(some->volumes, [&](const world::Volume& volume) { return !counts(volume); });
  return some;
}

bool is_for_a_time(const world::Volume& volume) { return volume.when.until != MissionTime::max(); }

/// Some volumes are closed for a time.
Result<AreaSweep, NoSweep> sweep_in_time(const Air& world, MissionTime now, const SweepStart& start,
                                         const Sweep& sweep) {
  const auto any_time = sweep(world, {});
  if (any_time) return *any_time;
  const Departure in_time{start.earliest, start.latest + kLate};
  if (auto meanwhile = sweep(world, in_time)) return std::move(*meanwhile);
  const world::TimeWindow beginning{now + Duration::seconds(in_time.least),
                                    now + Duration::seconds(in_time.most)};
  const auto is_in_its_way = [&](const auto& volume) { return volume.when.overlaps(beginning); };
  if (auto at_first = sweep(only(*world, is_in_its_way), {})) return std::move(*at_first);
  NoSweep refused{any_time.error()};
  if (!sweep(only(*world, std::not_fn(is_for_a_time)), {})) return tl::unexpected(refused);
  for (const world::Volume& volume : world->volumes)
    if (is_in_its_way(volume) && is_for_a_time(volume))
      refused.opens = earliest(refused.opens, volume.when.until);
  return tl::unexpected(refused);
}

}  // namespace

Result<AreaSweep, NoSweep> sweep_of(const std::shared_ptr<const Knowledge>& knowledge,
                                    const std::shared_ptr<const world::World>& world,
                                    MissionTime now, const SweepStart& start,
                                    const world::Polygon& area, const std::string& device) {
  const auto sensor = device_of(*knowledge, device);
  if (!sensor) return tl::unexpected(NoSweep{sensor.error()});
  const auto reach = footprint(**sensor, height_of(*knowledge));
  if (!reach) return tl::unexpected(NoSweep{reach.error()});
  const Sweep sweep = [&](const Air& air, const Departure& when) {
    Refinery refinery(Gazetteer(knowledge, air), now, kSeed);
    refinery.sweeps.let_swing();
    auto found = sweep_in(refinery, start.from, {"", area}, **sensor, when);
    if (found) found->reach = *reach;
    return found;
  };
  if (std::ranges::any_of(world->volumes, [&](const world::Volume& volume) {
        return is_for_a_time(volume) || volume.when.from > now;
      }))
    return sweep_in_time(world, now, start, sweep);
  return sweep(world, {}).map_error([](const std::string& why) { return NoSweep{why}; });
}

namespace {

Result<double, std::string> swath_with(double overlap, const Knowledge& knowledge,
                                       const std::string& device) {
  const auto sensor = device_of(knowledge, device);
  if (!sensor) return no(sensor.error());
  const auto reach = footprint(**sensor, height_of(knowledge));
  if (!reach) return no(reach.error());
  return swath_of(*reach, knowledge.vehicle, overlap);
}

}  // namespace

Result<double, std::string> swath_of(const Knowledge& knowledge, const std::string& device) {
  return swath_with(1, knowledge, device);
}

Result<double, std::string> shared_swath_of(const Knowledge& knowledge, const std::string& device) {
  return swath_with(kSharedOverlap, knowledge, device);
}

std::optional<double> seconds_of_sweep(const PartSweeper& sweeper, const world::Polygon& part,
                                       const std::shared_ptr<const world::World>& world,
                                       Sweeping sweeping) {
  const bool shared = sweeping == Sweeping::kShared;
  const auto& [vehicle, altitude, swath, start] = sweeper;
  auto knowledge = std::make_shared<Knowledge>();
  knowledge->vehicle = vehicle;
  knowledge->altitude = altitude;
  world::SensorModel device;
  device.device = "mapping";
  device.aperture = std::atan(footprint_of(swath, vehicle, shared ? kSharedOverlap : 1) / altitude);
  device.range = kFar * std::hypot(altitude, swath);
  device.period = kLooks;
  Refinery refinery(Gazetteer(knowledge, world), MissionTime(), kSeed);
  if (shared) refinery.sweeps.let_swing();
  const Vector3 from(start.x(), start.y(),
                     world->terrain.elevation(start.x(), start.y()) + altitude);
  const auto lanes = refinery.sweeps.over(from, {"", part}, device);
  if (!lanes) return std::nullopt;
  const Motion there = refinery.ways.flown({from, lanes->way.front()});
  return there.times.expected + lanes->times.expected;
}

}  // namespace skein::supervisor
