// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/detours.hpp"

#include <algorithm>

#include "flight/flight_times.hpp"
#include "refinery/timed_air.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/world/crossing.hpp"

namespace skein::supervisor {

namespace {

constexpr std::uint64_t kDetourSeed = 1;
constexpr double kLeastHeight = 5;  // [m]

bool is_closed_now(const world::Volume& volume, MissionTime now) {
  return volume.when.from <= now && now < volume.when.until;
}

/// One vehicle in the air that is closed at one time.
class Surroundings {
 public:
  Surroundings(const DetourRequest& request, const std::function<bool()>& time_is_up)
      : request_(request),
        air_(Gazetteer(request.knowledge, request.world), request.now, kDetourSeed, {time_is_up}) {
    for (const world::Volume& volume : request.world->volumes) {
      closed_.push_back(is_closed_now(volume, request.now));
      opens_ = opens_ || (closed_.back() && volume.when.until != MissionTime::max());
    }
  }

  Detour detour(const StraightLeg& leg) {
    const auto airspace = air_.airspace(closed_);
    if (!airspace) return {};
    const refiners::VoxelPathPlanner planner(**airspace, refiners::WaySearch::kQuick);
    const auto path = planner.plan(air_.query(leg.from, leg.to), air_.setting());
    if (path) return against_straight(leg, path->task.way);
    return {opens_ || !is_closed_off(leg, path.error()), {}, 0};
  }

 private:
  bool is_closed_off(const StraightLeg& leg, const refiners::Refusal& refusal) const {
    if (refusal.kind == refiners::RefusalKind::kUnreachable) return true;
    return refusal.kind == refiners::RefusalKind::kBlocked && refusal.field == "to" &&
           !air_.has_room(leg.to, air_.closed(closed_));
  }

  Detour against_straight(const StraightLeg& leg, const refiners::Way& way) const {
    const world::VehicleModel& vehicle = request_.knowledge->vehicle;
    const world::Wind& wind = request_.world->wind;
    const refiners::Flight around = refiners::estimate_flight(way, vehicle, wind);
    const refiners::Flight straight = refiners::estimate_flight({leg.from, leg.to}, vehicle, wind);
    if (around.duration.expected == Duration::max() ||
        straight.duration.expected == Duration::max())
      return {};
    const Duration longer = around.duration.expected - straight.duration.expected;
    const double energy = (around.energy - straight.energy) * vehicle.energy.capacity;
    return {true, std::max(longer, Duration()), std::max(energy, 0.0)};
  }

  const DetourRequest& request_;
  TimedAir air_;
  TimedAir::Counted closed_;
  bool opens_ = false;
};

}  // namespace

bool goes_through(const Knowledge& knowledge, const world::World& world, MissionTime now,
                  const StraightLeg& leg) {
  const world::VehicleModel& vehicle = knowledge.vehicle;
  if (vehicle.ground) return false;
  const double margin = vehicle.body_radius + arrival_distance(vehicle, world.wind);
  const bool closed =
      std::any_of(world.volumes.begin(), world.volumes.end(), [&](const world::Volume& volume) {
        return is_closed_now(volume, now) && crosses(volume, margin, leg.from, leg.to);
      });
  if (closed) return true;
  const double clearance = std::max(kLeastHeight, 4 * world::tracking_spread(vehicle));
  return world.terrain.first_hit(leg.from, leg.to, clearance).has_value();
}

std::vector<Detour> plan_detours(const DetourRequest& request,
                                 const std::function<bool()>& time_is_up) {
  Surroundings surroundings(request, time_is_up);
  std::vector<Detour> detours;
  for (const StraightLeg& leg : request.legs) {
    Detour detour = surroundings.detour(leg);
    const bool cut_short = time_is_up && time_is_up();
    if (cut_short && !detours.empty()) break;
    detours.push_back(cut_short ? Detour() : detour);
    if (cut_short) break;
  }
  return detours;
}

}  // namespace skein::supervisor
