// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/heights_over.hpp"
#include "common/shared_checks.hpp"
#include "coverage/checks.hpp"
#include "coverage/sweep_headland.hpp"
#include "coverage/sweep_track.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;
constexpr double kLeastTolerance = 1;  // of heights [m]
constexpr double kRounding = 1e-6;     // of heights [m]
/// Than at speed: where the way is too high over steep ground, one that hovers flies slower.
constexpr std::array<double, 4> kSteeper = {1, 2, 4, 1e6};
/// Tried where turns are in the way, and as many edges.
constexpr std::size_t kOtherDirections = 12;
/// Headlands tried for a vehicle that cannot hover, in radii of its turns: in the last there is
/// room for any shortest curve between two lanes.
constexpr std::array<double, 6> kHeadlands = {0.5, 1, 1.5, 2, 2.5, 3};

using Volumes = std::vector<const world::Volume*>;

/// Volumes over the area, by the rectangles around them.
Volumes over(const world::Polygon& area, const Volumes& volumes) {
  const auto box = [](const world::Polygon& polygon) {
    Vector2 low = polygon.front(), high = polygon.front();
    for (const Vector2& corner : polygon) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    return std::pair{low, high};
  };
  const auto [low, high] = box(area);
  Volumes found;
  for (const world::Volume* volume : volumes) {
    if (volume->polygon.empty()) continue;
    const auto [volume_low, volume_high] = box(volume->polygon);
    if ((volume_low.array() < high.array()).all() && (volume_high.array() > low.array()).all())
      found.push_back(volume);
  }
  return found;
}

std::optional<Vector2> level(const std::optional<Vector3>& point) {
  if (!point) return std::nullopt;
  return Vector2(point->head<2>());
}

Duration later(Duration duration, double seconds) {
  return duration == Duration::max() ? duration : duration + Duration::seconds(seconds);
}

bool is_over(const Vector3& point, const Vector2& place) {
  return (point.head<2>() - place).norm() < kRounding;
}

/// Of the first point over a place.
std::size_t index_of(const Way& way, const Vector2& place) {
  const auto found = std::find_if(way.begin(), way.end(),
                                  [&](const Vector3& point) { return is_over(point, place); });
  return static_cast<std::size_t>(found - way.begin());
}

/// Of the last one.
std::size_t last_index_of(const Way& way, const Vector2& place) {
  const auto found = std::find_if(way.rbegin(), way.rend(),
                                  [&](const Vector3& point) { return is_over(point, place); });
  return static_cast<std::size_t>(way.rend() - found) - 1;
}

class CoverageRefiner {
 public:
  CoverageRefiner(const CoverageQuery& query, const Setting& setting)
      : query_(query),
        setting_(setting),
        model_(query.vehicle, query.speed > 0 ? query.speed : query.vehicle.cruise_speed),
        volumes_(volumes_from(setting.world, query.depart)) {}

  Outcome<Coverage> refine() {
    Countdown countdown(setting_.budget, 1);
    SweepTask task = sweep_task();
    if (!(task.wind.norm() < model_.speed()))
      return refuse(RefusalKind::kBeyondVehicle, "speed",
                    "a wind that moves it by " + rounded(task.wind.norm()) +
                        " m/s cannot be flown against at " + rounded(model_.speed()) + " m/s");
    return query_.turns_inside ? within(std::move(task), countdown)
                               : swept(std::move(task), countdown);
  }

 private:
  Outcome<Coverage> swept(SweepTask task, Countdown& countdown) const {
    const Volumes above = over(query_.area, volumes_);
    if (!above.empty())
      task.is_free = [&](const Vector2& from, const Vector2& to) {
        return entered(lifted(from), lifted(to), above) == nullptr;
      };
    Outcome<Coverage> refined = flown(task, countdown, above);
    if (refined || refined.error().kind != RefusalKind::kBlocked ||
        query_.mode != SweepMode::kLeastTime)
      return refined;
    return in_other_directions(task, countdown, std::move(refined));
  }

  /// With the narrowest of the headlands tried that holds all turns.
  Outcome<Coverage> within(SweepTask task, Countdown& countdown) const {
    const world::Polygon area = convex_hull(query_.area);
    Refusal refusal = too_narrow();
    for (const double radii : kHeadlands) {
      const double width =
          model_.hovers() ? query_.swath : query_.swath / 2 + radii * model_.radius();
      task.region.outer = without_headland(area, width);
      if (task.region.outer.size() < 3) break;
      if (auto problem = holes_in_headland(task.region.outer, width)) {
        refusal = *problem;
        break;
      }
      auto refined = swept(task, countdown);
      if (!refined) refusal = refined.error();
      if (refined && sweeps_within(area, refined->task)) {
        refined->task.headland = width;
        if (!model_.hovers())
          refined->task.left_out = 1 - world::area(task.region.outer) / world::area(area);
        return refined;
      }
      if (model_.hovers() || countdown.over()) break;
    }
    return tl::unexpected<Refusal>(refusal);
  }

  Refusal too_narrow() const {
    return {RefusalKind::kBeyondVehicle, "turns_inside",
            "the area is too narrow to be swept with all turns inside: " +
                (model_.hovers() ? "a lap along the border is " + rounded(query_.swath)
                                 : "turns are " + rounded(model_.radius())) +
                " m wide"};
  }

  std::optional<Refusal> holes_in_headland(const world::Polygon& inner, double width) const {
    for (std::size_t i = 0; i < query_.holes.size(); ++i)
      for (const Vector2& corner : query_.holes[i])
        if (!world::contains(inner, corner))
          return Refusal{RefusalKind::kBeyondVehicle, "holes." + std::to_string(i),
                         "it reaches into the headland of " + rounded(width) +
                             " m that turns inside of the area take"};
    return std::nullopt;
  }

  /// What a vehicle that hovers sweeps of the headland, after the lanes.
  void add_lap(Sweep& sweep) const {
    for (const Pass& pass :
         border_lap(convex_hull(query_.area), query_.swath, sweep.passes.back().to)) {
      const Pass& before = sweep.passes.back();
      const double turn = std::abs(world::wrapped(pass.heading - before.heading));
      sweep.seconds +=
          std::max(model_.along((pass.from - before.to).norm()), turn / query_.vehicle.yaw_rate) +
          model_.along((pass.to - pass.from).norm());
      sweep.passes.push_back(pass);
    }
  }

  Outcome<Coverage> flown(const SweepTask& task, Countdown& countdown, const Volumes& above) const {
    auto sweep = plan_sweep(task, model_, countdown);
    if (!sweep && setting_.budget.expired())
      return refuse(RefusalKind::kBudgetExhausted, "area",
                    "the time was up before lanes that enter no volume were found");
    if (!sweep)
      return refuse(RefusalKind::kBlocked, "area",
                    "every set of lanes found enters a volume" +
                        (above.empty() ? std::string() : " (" + above.front()->name + ")") +
                        "; cut it out of the area, with half a swath around it");
    if (query_.turns_inside && model_.hovers()) add_lap(*sweep);
    Refined<Coverage> refined;
    refined.effort = {countdown.steps(), countdown.cut_short()};
    std::optional<Refusal> problem;
    for (const double steeper : kSteeper) {
      refined.task = {};
      problem = fly(*sweep, task.ends, steeper, refined);
      if (!problem) return refined;
      // One that hovers can follow the ground more closely, slower.
      if (!model_.hovers() || problem->kind != RefusalKind::kBeyondVehicle) break;
    }
    return tl::unexpected<Refusal>(*problem);
  }

  /// The quickest lanes have turns in a volume: the quickest of those in some other directions that
  /// have none, or what was `refused`.
  Outcome<Coverage> in_other_directions(SweepTask task, Countdown& countdown,
                                        Outcome<Coverage> refused) const {
    task.mode = SweepMode::kGiven;
    Outcome<Coverage> best = std::move(refused);
    std::vector<double> directions;
    for (std::size_t i = 0; i < query_.area.size() && i < kOtherDirections; ++i) {
      const Vector2 edge = query_.area[(i + 1) % query_.area.size()] - query_.area[i];
      directions.push_back(std::atan2(edge.y(), edge.x()));
    }
    for (std::size_t i = 0; i < kOtherDirections; ++i)
      directions.push_back(std::numbers::pi * static_cast<double>(i) / kOtherDirections);
    for (const double direction : directions) {
      if (countdown.over() || setting_.budget.expired()) break;
      task.direction = direction;
      Outcome<Coverage> other = flown(task, countdown, {});
      if (other && (!best || other->cost < best->cost)) best = std::move(other);
    }
    return best;
  }

  SweepTask sweep_task() const {
    SweepTask task;
    task.region = {query_.area, query_.holes};
    task.swath = query_.swath;
    task.mode = query_.mode;
    task.time_is_up = setting_.budget.time_is_up;
    task.direction = query_.direction;
    task.ends = {level(query_.start), level(query_.end)};
    task.wind = query_.vehicle.wind_drift * world::mean_velocity(setting_.world.wind).head<2>();
    return task;
  }

  Vector3 lifted(const Vector2& at) const {
    return {at.x(), at.y(), setting_.world.terrain.elevation(at.x(), at.y()) + query_.altitude};
  }

  static const world::Volume* entered(const Vector3& from, const Vector3& to,
                                      const Volumes& volumes) {
    for (const world::Volume* volume : volumes)
      if (enters(from, to, *volume)) return volume;
    return nullptr;
  }

  /// Fills in what the sweep gives; or says why it cannot be flown.
  std::optional<Refusal> fly(const Sweep& sweep, const SweepEnds& ends, double steeper,
                             Refined<Coverage>& refined) const {
    Obstacles obstacles;
    obstacles.is_free = [&](const Vector2& from, const Vector2& to) {
      return entered(lifted(from), lifted(to), volumes_) == nullptr;
    };
    for (const world::Volume* volume : volumes_) obstacles.outlines.push_back(volume->polygon);
    const Track track = track_of(sweep, ends, model_, obstacles);
    const auto z_of = [](const std::optional<Vector3>& place) {
      return place ? std::optional(place->z()) : std::nullopt;
    };
    Coverage& task = refined.task;
    const Profile profile{query_.altitude,  tolerance(),    z_of(query_.start),
                          z_of(query_.end), model_.speed(), steeper};
    task.way = raised(track, profile, query_.vehicle, setting_.world.terrain);
    task.direction = sweep.direction;
    task.parts = sweep.blocks;
    task.turns = sweep.passes.size() - 1;
    task.length = length_of(task.way);
    for (const Pass& pass : sweep.passes) task.lanes.push_back({pass.from, pass.to});
    double run = 0;
    for (std::size_t i = 1; i < track.points.size(); ++i)
      run += (track.points[i] - track.points[i - 1]).norm();
    estimate(std::max(0.0, track.seconds - run / model_.speed()), refined);
    return check_flown(refined);
  }

  /// A quarter of the altitude, or what is left up to the ceiling, but for a metre.
  double tolerance() const {
    return std::min(query_.altitude / 4,
                    std::max(kLeastTolerance, query_.vehicle.ceiling - query_.altitude));
  }

  /// `standing`: what stops and turns add to flying on at speed [s].
  void estimate(double standing, Refined<Coverage>& refined) const {
    const Flight flight =
        estimate_flight(refined.task.way, query_.vehicle, setting_.world.wind, query_.speed);
    refined.duration = {later(flight.duration.least, standing),
                        later(flight.duration.expected, standing),
                        later(flight.duration.most, standing)};
    refined.cost = refined.duration.expected.to_seconds();
    const double power = model_.hovers() ? world::flight_power(query_.vehicle, 0, 0)
                                         : world::flight_power(query_.vehicle, model_.speed(), 0);
    refined.task.energy = flight.energy + standing * power / query_.vehicle.energy.capacity;
  }

  std::optional<Refusal> check_flown(const Refined<Coverage>& refined) const {
    const Way& way = refined.task.way;
    for (std::size_t i = 1; i < way.size(); ++i) {
      const double height = heights_over(setting_.world.terrain, way[i - 1], way[i]).greatest;
      if (height > query_.vehicle.ceiling + kLeastTolerance)
        return Refusal{RefusalKind::kBeyondVehicle, "altitude",
                       "over ground this steep the way is " + rounded(height) +
                           " m high somewhere, above the vehicle's ceiling of " +
                           rounded(query_.vehicle.ceiling) + " m"};
    }
    if (auto problem = check_inside(refined.task)) return problem;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      if (const world::Volume* volume = entered(way[i], way[i + 1], volumes_))
        return Refusal{RefusalKind::kBlocked, "area",
                       "the way enters the volume " + volume->name + " near (" +
                           rounded(way[i].x()) + ", " + rounded(way[i].y()) + ")"};
    if (auto problem = check_ground(refined.task)) return problem;
    const double most = 1 - query_.vehicle.energy.reserve;
    if (!(refined.task.energy <= most))
      return Refusal{RefusalKind::kBeyondVehicle, "area",
                     "sweeping it takes " + rounded(100 * refined.task.energy) +
                         " % of the energy held when full; " + rounded(100 * most) +
                         " % may be used"};
    return std::nullopt;
  }

  /// Vehicles are sent to no way-point outside the terrain, but where they start or end there. An
  /// area that itself is outside in part is swept all the same.
  std::optional<Refusal> check_inside(const Coverage& task) const {
    const auto is_outside = [&](const auto& at) {
      return !setting_.world.terrain.contains(at.x(), at.y());
    };
    if (std::any_of(query_.area.begin(), query_.area.end(), is_outside)) return std::nullopt;
    const Way& way = task.way;
    const std::size_t last = last_index_of(way, task.lanes.back().to);
    for (std::size_t i = index_of(way, task.lanes.front().from); i < last && i < way.size(); ++i)
      if (is_outside(way[i]))
        return Refusal{RefusalKind::kBlocked, "area",
                       "a turn leads out of the terrain near (" + rounded(way[i].x()) + ", " +
                           rounded(way[i].y()) + ")"};
    return std::nullopt;
  }

  /// Lanes are above it; the way up to them, or down to the end, may come too near.
  std::optional<Refusal> check_ground(const Coverage& task) const {
    const world::Terrain& terrain = setting_.world.terrain;
    const Way& way = task.way;
    const auto over = [&](const Vector3& at) { return at.z() - terrain.elevation(at.x(), at.y()); };
    const double begin = over(way.front()), end = over(way.back());
    const double least = std::min({0.0, begin, end});
    const std::size_t first = query_.start ? index_of(way, task.lanes.front().from) : 0;
    const std::size_t last = query_.end ? last_index_of(way, task.lanes.back().to) : way.size();
    for (std::size_t i = 1; i < way.size(); ++i) {
      const bool starts = i <= first, leads = starts || i > last;
      const double kept = leads ? least_lead(query_.altitude, starts ? begin : end) : 0;
      const auto hit = terrain.first_hit(way[i - 1], way[i], std::max(kept, least) - kRounding);
      if (!hit) continue;
      const Vector3 at = way[i - 1] + *hit * (way[i] - way[i - 1]);
      const bool is_first = leads ? starts : 2 * i < way.size();
      return Refusal{RefusalKind::kBlocked, is_first ? "start" : "end",
                     std::string(is_first ? "the way up from it" : "the way to it") +
                         (kept > 0 ? " comes within " + rounded(kept) + " m of the ground near ("
                                   : " runs into the ground near (") +
                         rounded(at.x()) + ", " + rounded(at.y()) + ")"};
    }
    return std::nullopt;
  }

  const CoverageQuery& query_;
  const Setting& setting_;
  TurnModel model_;
  Volumes volumes_;
};

}  // namespace

Outcome<Coverage> refine(const CoverageQuery& query, const Setting& setting) {
  if (auto problem = check_coverage(query, setting.world)) return tl::unexpected<Refusal>(*problem);
  return CoverageRefiner(query, setting).refine();
}

}  // namespace skein::refiners
