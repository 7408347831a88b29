// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/voxel_path_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/deadline.hpp"
#include "common/over_ground.hpp"
#include "common/plain_way.hpp"
#include "common/shared_checks.hpp"
#include "path/approach.hpp"
#include "path/checks.hpp"
#include "path/space.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::Vector3;

/// A way that is longer by as much than a straight one is looked for otherwise too.
constexpr double kDetour = 1.03;
/// So many ways are flown lower, the shortest first.
constexpr std::size_t kLowered = 3;
/// How far aside ways are looked for where one that cannot hover would have to go round.
constexpr std::array<double, 8> kAside = {0.1, -0.1, 0.2, -0.2, 0.35, -0.35, 0.5, -0.5};

Refusal out_of_budget(const std::string& when) {
  return {RefusalKind::kBudgetExhausted, "", "the budget was used up " + when};
}

/// One attempt, with the volumes that count for one length of flight.
class Route {
 public:
  Route(const PathQuery& query, const Setting& setting, const PathSpace& space,
        const Airspace& airspace, WaySearch search)
      : query_(query), setting_(setting), space_(space), airspace_(airspace), search_(search) {}

  /// A way that can be flown.
  Result<Way, Refusal> find() {
    if (setting_.budget.expired()) return tl::unexpected(out_of_budget("before the search"));
    from_ = approach(space_, airspace_, query_.from, query_.to, setting_.budget);
    if (!from_) return tl::unexpected(closed(query_.from, "from"));
    to_ = approach(space_, airspace_, query_.to, query_.from, setting_.budget);
    if (!to_) return tl::unexpected(closed(query_.to, "to"));
    const VoxelWay found = search(airspace_);
    graph_cost_ = found.graph_cost;
    if (!found.found) return tl::unexpected(no_way(found));
    if (query_.vehicle.hovers) return without_repeats(joined(found.way));
    return flown({found.way, found.graph_way}).map(without_repeats);
  }

  double graph_cost() const { return graph_cost_; }
  const Effort& effort() const { return effort_; }

  /// Integral of the crossing cost; that of the approaches is 1.
  double cost(const Way& way) const {
    double sum = 0;
    for (std::size_t i = 1; i < way.size(); ++i)
      sum += airspace_.cost(way[i - 1], way[i]).value_or((way[i] - way[i - 1]).norm());
    return sum;
  }

 private:
  Refusal closed(const Vector3& place, const std::string& field) const {
    if (setting_.budget.expired()) return out_of_budget("before the search");
    return space_.closed(place, field);
  }

  Budget rest_of_budget() const {
    Budget rest = setting_.budget;
    rest.steps -= std::min(rest.steps, effort_.steps);
    return rest;
  }

  VoxelWay search(const Airspace& airspace) {
    VoxelWay found =
        find_way(airspace, from_->way.back(), to_->way.back(), rest_of_budget(), search_);
    effort_.steps += found.effort.steps;
    effort_.cut_short = effort_.cut_short || found.effort.cut_short;
    return found;
  }

  Refusal no_way(const VoxelWay& found) const {
    if (found.out_of_budget) return out_of_budget("before a way was found");
    const Refusal unreachable = {RefusalKind::kUnreachable, "to",
                                 "every way there is closed by the ground or by volumes"};
    if (!query_.contact) return unreachable;
    const auto silent = space_.without_contact().airspace(setting_.world.airspace, setting_.budget);
    if (!silent) return out_of_budget("before a way was found");
    const GraphWay other = search_graph(*silent, from_->voxel, to_->voxel, rest_of_budget());
    if (other.out_of_budget) return out_of_budget("before a way was found");
    if (!other.found) return unreachable;
    return {RefusalKind::kNoContact, "contact", "no way there keeps radio contact all along"};
  }

  bool is_free(const Vector3& a, const Vector3& b) const {
    return airspace_.is_free(a, b) || (from_->near && from_->near->is_free(a, b)) ||
           (to_->near && to_->near->is_free(a, b));
  }

  /// With the ways from the ends to the graph, leaving the joints out or behind where that is free.
  Way joined(Way way) const {
    if (from_->near) {
      way.insert(way.begin(), from_->way.begin(), from_->way.end() - 1);
      straighten_joint(way, from_->way.size() - 1);
    }
    if (to_->near) {
      way.insert(way.end(), to_->way.rbegin() + 1, to_->way.rend());
      std::reverse(way.begin(), way.end());
      straighten_joint(way, to_->way.size() - 1);
      std::reverse(way.begin(), way.end());
    }
    return way;
  }
  void straighten_joint(Way& way, std::size_t joint) const {
    if (joint + 1 >= way.size()) return;
    const Vector3 at = way[joint], next = way[joint + 1];
    for (double part = 1; part > 0.05; part /= 2) {
      const Vector3 place = at + part * (next - at);
      if (!is_free(way[joint - 1], place) || !is_free(place, next)) continue;
      way[joint] = place;
      if (part == 1) way.erase(way.begin() + static_cast<std::ptrdiff_t>(joint));
      return;
    }
  }

  /// For a vehicle that cannot hover: the shortest of the ways that can be made flyable; one with
  /// room for its turns when the others cannot.
  Result<Way, Refusal> flown(const std::vector<Way>& ways) {
    FlyableQuery flyable;
    flyable.heading_from = query_.heading_from;
    flyable.heading_to = query_.heading_to;
    flyable.speed = query_.speed;
    flyable.tolerance = kChordTolerance;
    flyable.is_free = [&](const Vector3& a, const Vector3& b) {
      return is_free(a, b) || space_.is_free(a, b);
    };
    flyable.shortest = true;
    flyable.time_is_up = setting_.budget.time_is_up;
    std::optional<Way> best;
    std::vector<Way> all;
    std::optional<Refusal> refusal;
    const auto attempt = [&](const Way& corners) {
      flyable.corners = corners;
      const auto flown = make_flyable(flyable, query_.vehicle);
      if (!flown && !refusal) refusal = flown.error();
      if (flown && (!best || cost(*flown) < cost(*best))) best = *flown;
      if (flown) all.push_back(*flown);
    };
    // Where the ground leaves the straight way free, though the voxels do not.
    if (flyable.is_free(query_.from, query_.to)) attempt({query_.from, query_.to});
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (i == 0 || ways[i] != ways[i - 1]) attempt(joined(ways[i]));
    // Where it has to climb, by slopes that it can fly from the beginning.
    if (!best || length_of(*best) > kDetour * (query_.to - query_.from).norm()) {
      attempt(sloped({query_.from, query_.to}));
      attempt(sloped(joined(ways.front())));
    }
    if (best && goes_round(*best, ways))
      for (const double aside : kAside) attempt(sloped(bowed(aside)));
    if (const auto wide = best ? std::nullopt : roomy(); wide)
      if (const VoxelWay found = search(*wide); found.found) attempt(joined(found.way));
    if (best && goes_round(*best, ways) && climbs_needlessly(*best))
      best = shortest_lowered(std::move(all), flyable);
    if (best) return *best;
    if (setting_.budget.expired()) return tl::unexpected(out_of_budget("making the way flyable"));
    return tl::unexpected(*refusal);
  }

  /// Longer than the ways that it was made of: there was no room for its turns, or for its climbs.
  bool goes_round(const Way& flown, const std::vector<Way>& ways) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Way& way : ways) least = std::min(least, length_of(joined(way)));
    return length_of(flown) > kDetour * least;
  }

  /// Longer than the straight way, and than its slopes ask for.
  bool climbs_needlessly(const Way& flown) const {
    const Vector3 step = query_.to - query_.from;
    const double speed = query_.speed > 0 ? query_.speed : query_.vehicle.cruise_speed;
    const double least = std::max({step.norm(), step.z() * speed / query_.vehicle.climb_rate,
                                   -step.z() * speed / query_.vehicle.descent_rate});
    return length_of(flown) > kDetour * least;
  }

  /// Of the best few ways, each as low as it can be flown: what climbs least may not be what was
  /// shortest before.
  Way shortest_lowered(std::vector<Way> ways, const FlyableQuery& flyable) const {
    std::stable_sort(ways.begin(), ways.end(),
                     [this](const Way& a, const Way& b) { return cost(a) < cost(b); });
    const double clearance = clearance_over_ground();
    const Floor floor = [&](const world::Vector2& at) {
      return setting_.world.terrain.elevation(at.x(), at.y()) + clearance;
    };
    Way best = ways.front();
    for (std::size_t i = 0; i < std::min(kLowered, ways.size()); ++i) {
      Way lower = lowered(ways[i], flyable, query_.vehicle, floor);
      if (cost(lower) < cost(best)) best = std::move(lower);
    }
    return best;
  }

  /// At which the ground itself leaves the air free, and a little more [m].
  double clearance_over_ground() const {
    return std::max(query_.clearance, 3 * space_.margin()) + 1;
  }

  /// By a place aside of the middle, in parts of the distance: a longer run to climb on.
  Way bowed(double aside) const {
    const Vector3 step = query_.to - query_.from;
    const Vector3 left(-step.y(), step.x(), 0);
    return {query_.from, query_.from + step / 2 + aside * left, query_.to};
  }

  /// Over the same places, as high as the ground asks for and no steeper than the vehicle flies.
  Way sloped(const Way& way) const {
    std::vector<world::Vector2> plane;
    for (const Vector3& at : way) plane.emplace_back(at.x(), at.y());
    const world::VehicleModel& vehicle = query_.vehicle;
    const double speed = query_.speed > 0 ? query_.speed : vehicle.cruise_speed;
    const HeightRule rule{clearance_over_ground(), vehicle.climb_rate / speed,
                          vehicle.descent_rate / speed};
    Deadline deadline(setting_.budget);
    Way sloped = over_ground(plane, setting_.world.terrain, rule, deadline);
    if (sloped.size() < 2) return way;
    sloped.front() = way.front();
    sloped.back() = way.back();
    return sloped;
  }

  /// The airspace without what is close to blocked voxels on the level, but around the ends;
  /// nothing when the time is up before.
  std::optional<Airspace> roomy() const {
    const double radius = query_.vehicle.min_turn_radius, voxel = airspace_.grid().voxel;
    const auto range =
        static_cast<std::int32_t>(std::clamp(std::ceil(radius / 2 / voxel), 1.0, 4.0));
    auto roomy = airspace_.copied(setting_.budget.time_is_up);
    const auto has_room = [&](const world::Voxel& at) {
      const Vector3 centre = airspace_.centre(at);
      if (std::min((centre - query_.from).norm(), (centre - query_.to).norm()) <
          2 * radius + 2 * voxel)
        return true;
      for (std::int32_t y = -range; y <= range; ++y)
        for (std::int32_t x = -range; x <= range; ++x)
          if (!airspace_.is_free(at[0] + x, at[1] + y, at[2])) return false;
      return true;
    };
    if (roomy && !roomy->keep_where(has_room, setting_.budget.time_is_up)) roomy.reset();
    return roomy;
  }

  const PathQuery& query_;
  const Setting& setting_;
  const PathSpace& space_;
  const Airspace& airspace_;
  WaySearch search_;
  std::optional<Approach> from_, to_;
  double graph_cost_ = 0;
  Effort effort_;
};

Outcome<Path> answer(const PathQuery& query, const Route& route, const Way& way,
                     const Flight& flight, const Effort& effort) {
  if (flight.duration.expected == Duration::max())
    return refuse(RefusalKind::kBeyondVehicle, "speed", "the vehicle cannot hold against the wind");
  if (auto problem = check_energy(flight.energy, query.vehicle, "the way"))
    return tl::unexpected(*problem);
  Refined<Path> refined;
  refined.task = {way, flight.length, route.graph_cost(), flight.energy};
  refined.cost = route.cost(way);
  refined.duration = flight.duration;
  refined.effort = effort;
  return refined;
}

/// Through an airspace that is there already.
Outcome<Path> plan_within(const Airspace& airspace, WaySearch search, const PathQuery& query,
                          const Setting& setting) {
  const PathSpace space(query, setting.world, Duration::max());
  Route route(query, setting, space, airspace, search);
  const auto way = route.find();
  if (!way) return tl::unexpected(way.error());
  const Flight flight = estimate_flight(*way, query.vehicle, setting.world.wind, query.speed);
  return answer(query, route, *way, flight, route.effort());
}

}  // namespace

Outcome<Path> VoxelPathPlanner::plan(const PathQuery& query, const Setting& setting) const {
  if (auto problem = check(query, setting.world)) return tl::unexpected(*problem);
  if (setting.budget.expired()) return tl::unexpected(out_of_budget("before the search"));
  if (airspace_ != nullptr) return plan_within(*airspace_, search_, query, setting);
  const auto estimate = [&](const Way& way) {
    return estimate_flight(way, query.vehicle, setting.world.wind, query.speed);
  };
  Duration horizon = estimate({query.from, query.to}).duration.least;
  Effort effort;
  while (true) {
    const PathSpace space(query, setting.world, horizon);
    Setting rest{setting.world, setting.budget, setting.seed, nullptr};
    rest.budget.steps -= std::min(rest.budget.steps, effort.steps);
    const auto airspace = space.airspace(setting.world.airspace, setting.budget);
    if (!airspace) return tl::unexpected(out_of_budget("before the search"));
    Route route(query, rest, space, *airspace, search_);
    const auto way = route.find();
    if (!way) return tl::unexpected(way.error());
    effort.steps += route.effort().steps;
    effort.cut_short = effort.cut_short || route.effort().cut_short;
    const Flight flight = estimate(*way);
    const Duration most = std::max(horizon, flight.duration.most);
    if (PathSpace(query, setting.world, most).counted() == space.counted())
      return answer(query, route, *way, flight, effort);
    horizon = most;
  }
}

}  // namespace skein::refiners
