// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/patrol.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/circles.hpp"
#include "common/heights_over.hpp"
#include "common/shared_checks.hpp"
#include "patrol/plan.hpp"
#include "patrol/ring.hpp"
#include "patrol/setup.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// The clock is asked every as many visits: one takes some microseconds.
constexpr std::uint32_t kStride = 16;
/// About what it takes to judge a leg over the ground [ns].
constexpr std::uint32_t kLeg = 5000;
/// To shorten a round over more blocks may take longer than there is time: a patrol first.
constexpr std::size_t kManyBlocks = 400;
/// Than at speed: where the way is too high over steep ground, one that hovers flies slower.
constexpr std::array<double, 4> kSteeper = {1, 2, 4, 1e6};

/// As steeply as the vehicle can from the height of the start to those of the way. The least height
/// over the ground until there [m].
double lead_from_start(Way& way, const PatrolQuery& query, const world::Terrain& terrain) {
  const HeightRule rule = height_rule(query);
  double along = 0, least = std::numeric_limits<double>::infinity();
  Vector2 before = way.front().head<2>();
  for (Vector3& point : way) {
    along += (point.head<2>() - before).norm();
    before = point.head<2>();
    const double wanted = point.z();
    point.z() = std::clamp(wanted, query.start.z() - rule.descent * along,
                           query.start.z() + rule.climb * along);
    if (&point != &way.front())
      least = std::min(least, heights_over(terrain, *(&point - 1), point).least);
    if (along > 0 && point.z() == wanted) break;
  }
  return least;
}

/// Half of the altitude, or of the start's height where that is less [m].
double least_lead(const PatrolQuery& query, const world::Terrain& terrain) {
  const double ground = terrain.elevation(query.start.x(), query.start.y());
  return std::min(query.altitude, query.start.z() - ground) / 2;
}

/// Leads from the height of the start to those of the way: on the spot where the vehicle hovers;
/// else on the way, and in circles over the start where that would come nearer to the ground than
/// half of the altitude, or of the start's height where that is less.
void join_start(Way& way, const PatrolQuery& query, const world::Terrain& terrain) {
  if (query.vehicle.hovers) {
    if (way.front() != query.start) way.insert(way.begin(), query.start);
    return;
  }
  Way lead = way;
  const double least = lead_from_start(lead, query, terrain);
  if (way.size() < 2 || way.front().z() <= query.start.z() || least >= least_lead(query, terrain)) {
    way = std::move(lead);
    return;
  }
  const Vector2 ahead = (way[1] - way[0]).head<2>().normalized();
  Way circles = {query.start};
  const CircleRule rule{height_rule(query).climb, query.vehicle.min_turn_radius,
                        least_lead(query, terrain)};
  add_circles(circles, way.front().z(), ahead, rule, terrain);
  way.insert(way.begin(), circles.begin(), circles.end() - 1);
}

/// What is after the end of the patrol; at least a leg stays.
void cut_after(Way& way, double length) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    length -= (way[i] - way[i - 1]).head<2>().norm();
    if (length < 0 && i > 1) {
      way.resize(i);
      return;
    }
  }
}

double leg_time(const Vector3& from, const Vector3& to, const PatrolQuery& query) {
  const double rise = to.z() - from.z();
  const double vertical =
      rise > 0 ? rise / query.vehicle.climb_rate : -rise / query.vehicle.descent_rate;
  return std::max((to - from).head<2>().norm() / patrol_speed(query), vertical);
}

/// Where the ground is steeper than the vehicle climbs at speed its legs take longer.
void cut_at(Way& way, double seconds, const PatrolQuery& query) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double leg = leg_time(way[i - 1], way[i], query);
    if (leg > seconds) {
      way[i] = way[i - 1] + seconds / leg * (way[i] - way[i - 1]);
      way.resize(i + 1);
      return;
    }
    seconds -= leg;
  }
}

/// The way as long as the patrol lasts: a start on the spot takes its time too. `steeper`: than the
/// vehicle climbs and descends at speed.
Way flown(const PatrolQuery& query, const world::Terrain& terrain, const PlanePatrol& plane,
          double steeper, Deadline& deadline) {
  const double speed = patrol_speed(query);
  HeightRule rule = height_rule(query);
  rule.climb *= steeper;
  rule.descent *= steeper;
  const double wanted = terrain.elevation(query.start.x(), query.start.y()) + query.altitude;
  const double rise = wanted - query.start.z();
  const double on_the_spot = query.vehicle.hovers ? std::max(rise / query.vehicle.climb_rate,
                                                             -rise / query.vehicle.descent_rate)
                                                  : 0;
  const double left = std::max(0.0, query.duration.to_seconds() - on_the_spot);
  std::vector<Vector2> part = first_part(plane.way, left * speed);
  // Part of a chord of an arc would be a sharper turn than the arc.
  const bool cuts_arc =
      !query.vehicle.hovers && part.size() > 2 &&
      (part.back() - part[part.size() - 2]).norm() < query.vehicle.min_turn_radius;
  if (cuts_arc) part.pop_back();
  Way way = over_ground(part, terrain, rule, deadline);
  if (way.empty()) return way;
  const std::size_t points = way.size();
  join_start(way, query, terrain);
  if (query.vehicle.hovers)
    cut_at(way, query.duration.to_seconds(), query);
  else if (way.size() > points)
    cut_after(way, query.duration.to_seconds() * speed);
  return way;
}

std::optional<Refusal> check_heights(const Way& way, const PatrolQuery& query,
                                     const world::Terrain& terrain, Deadline& deadline) {
  const double kept = least_lead(query, terrain);
  for (std::size_t i = 1; i < way.size() && !deadline.passed_after(kLeg); ++i) {
    const HeightRange heights = heights_over(terrain, way[i - 1], way[i]);
    const double over = heights.greatest;
    const bool leads = i == 1 && query.start.z() > way[i].z();
    if (!leads && over > query.vehicle.ceiling + 1e-6 &&
        over > query.altitude * (1 + kHeightTolerance))
      return Refusal{RefusalKind::kBeyondVehicle, "altitude",
                     "the ground is too steep to follow at that speed: it would be " +
                         std::to_string(static_cast<int>(over)) + " m below; the ceiling is " +
                         std::to_string(static_cast<int>(query.vehicle.ceiling)) + " m"};
    if (!terrain.line_of_sight(way[i - 1], way[i]))
      return Refusal{RefusalKind::kBlocked, "start", "the way up from it runs into the ground"};
    if (!query.vehicle.hovers && heights.least < kept - 1e-6)
      return Refusal{RefusalKind::kBlocked, "start",
                     "the circles up from it come within " + rounded(std::max(0.0, kept)) +
                         " m of the ground: let it begin higher, or elsewhere"};
  }
  return std::nullopt;
}

std::optional<Refusal> check_energy(const Flight& flight, const world::VehicleModel& vehicle) {
  const double usable = 1 - vehicle.energy.reserve;
  if (flight.energy <= usable) return std::nullopt;
  const double seconds = flight.duration.expected.to_seconds();
  return Refusal{RefusalKind::kBeyondVehicle, "duration",
                 std::to_string(static_cast<long>(seconds)) + " s draw " +
                     std::to_string(static_cast<long>(100 * flight.energy)) +
                     " % of the energy held when full, of which " +
                     std::to_string(static_cast<int>(100 * usable)) +
                     " % may be used: enough for about " +
                     std::to_string(static_cast<long>(seconds * usable / flight.energy)) + " s"};
}

PatrolFigures predicted(const Way& way, const PatrolQuery& query, const PatrolGround& ground) {
  double total = 0;
  for (std::size_t i = 1; i < way.size(); ++i) total += leg_time(way[i - 1], way[i], query);
  IdlenessLog log(ground.field, ground.sight, total / 2);
  for (std::size_t i = 1; i < way.size() && !ground.sight.deadline().passed_after(kLeg); ++i)
    log.fly(way[i - 1].head<2>(), way[i].head<2>(),
            log.now() + leg_time(way[i - 1], way[i], query));
  PatrolFigures figures = log.figures();
  const PatrolFigures bounds =
      make_bounds(ground.field, ground.sight, patrol_speed(query), total, total / 2);
  figures.worst_idleness_bound = bounds.worst_idleness_bound;
  figures.worst_risk_idleness_bound = bounds.worst_risk_idleness_bound;
  figures.mean_idleness_bound = bounds.mean_idleness_bound;
  return figures;
}

std::vector<double> potentials(const Way& way, const PatrolQuery& query,
                               const PatrolGround& ground) {
  std::vector<Vector2> plane;
  for (const Vector3& point : way) plane.emplace_back(point.head<2>());
  const std::vector<double> idleness =
      fading_idleness(ground.field, ground.sight, plane, patrol_speed(query));
  if (idleness.empty()) return {};
  std::vector<double> all(ground.sight.grid().size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < idleness.size(); ++i)
    all[ground.field.cells[i]] =
        potential(ground.field.risk[i], idleness[i], query.time_scale.to_seconds());
  return all;
}

/// Plans, and makes of what is planned what is flown: at once while the time runs, so that there is
/// an answer when it is up; else only of the last.
class PatrolRefiner {
 public:
  PatrolRefiner(const PatrolQuery& query, const Setting& setting, const PatrolGround& ground,
                Deadline& deadline)
      : query_(query),
        world_(setting.world),
        ground_(ground),
        deadline_(deadline),
        seed_(setting.seed),
        countdown_(setting.budget, kStride) {}

  Outcome<Patrol> refine() {
    plan();
    for (auto plane = waiting_.rbegin(); plane != waiting_.rend() && !(best_ && *best_); ++plane)
      best_ = answer(*plane);
    if (!best_)
      return countdown_.over() || deadline_.is_over()
                 ? refuse(RefusalKind::kBudgetExhausted, "", "nothing was planned in time")
                 : refuse(RefusalKind::kUnreachable, "start", "no way leads to the zone");
    if (!*best_) return std::move(*best_);
    Refined<Patrol>& refined = **best_;
    refined.task.potential = potentials(refined.task.way, query_, ground_);
    refined.effort = {countdown_.steps(), countdown_.cut_short() || deadline_.is_over()};
    return std::move(*best_);
  }

 private:
  void plan() {
    const PatrolTask task{query_.start.head<2>(), query_.heading, patrol_speed(query_),
                          query_.duration.to_seconds(), seed_};
    const TakePatrol taken = [this](const PlanePatrol& plane) { take(plane); };
    if (query_.mode == PatrolMode::kGradient)
      return fly_gradient({ground_.field, ground_.space, ground_.sight}, task,
                          {query_.time_scale.to_seconds()}, countdown_, taken);
    const auto over = [&](const std::vector<Visit>& whole) {
      return LapGround{ground_.field,  ground_.blocks,
                       *ground_.links, whole,
                       task.speed,     query_.vehicle.hovers ? &ground_.space : nullptr};
    };
    if (deadline_.is_set() && ground_.blocks.size() > kManyBlocks)
      fly_in_turn(over(lanes_in_turn(ground_.blocks, *ground_.links)), ground_.sight, task,
                  countdown_, taken);
    const std::vector<Visit> whole = round_over_all(ground_.blocks, *ground_.links, deadline_);
    plan_patrol(over(whole), ground_.sight, task, countdown_, taken);
  }

  void take(const PlanePatrol& plane) {
    if (plane.way.size() < 2 || (best_is_whole_ && !plane.complete)) return;
    if (!deadline_.is_set()) {
      waiting_.push_back(plane);
      return;
    }
    Outcome<Patrol> made = answer(plane);
    if (deadline_.passed()) return;  // it may not be whole
    // What has more time to fly may take more than the vehicle has: then a part is no answer.
    if (!made && best_is_whole_ && *best_) return;
    best_ = std::move(made);
    best_is_whole_ = plane.complete;
  }

  Outcome<Patrol> answer(const PlanePatrol& plane) const {
    Refined<Patrol> refined;
    Patrol& patrol = refined.task;
    std::optional<Refusal> problem;
    for (const double steeper : kSteeper) {
      patrol.way = flown(query_, world_.terrain, plane, steeper, deadline_);
      problem = check_heights(patrol.way, query_, world_.terrain, deadline_);
      // One that hovers can follow the ground more closely, slower.
      if (!problem || !query_.vehicle.hovers) break;
    }
    if (problem) return tl::unexpected(*problem);
    const Flight flight =
        estimate_flight(patrol.way, query_.vehicle, world_.wind, patrol_speed(query_));
    problem = check_energy(flight, query_.vehicle);
    if (problem) return tl::unexpected(*problem);
    patrol.energy = flight.energy;
    patrol.predicted = predicted(patrol.way, query_, ground_);
    refined.cost = patrol.predicted.mean_idleness;
    refined.duration = flight.duration;
    return refined;
  }

  const PatrolQuery& query_;
  const world::World& world_;
  const PatrolGround& ground_;
  Deadline& deadline_;
  std::uint64_t seed_;
  Countdown countdown_;
  std::vector<PlanePatrol> waiting_;     // without a clock
  std::optional<Outcome<Patrol>> best_;  // made of the best so far
  bool best_is_whole_ = false;
};

}  // namespace

double potential(double risk, double idleness, double time_scale) {
  SKEIN_EXPECTS(time_scale > 0);
  return std::exp(-risk * idleness / time_scale);
}

double updated_idleness(double idleness, double dt, double distance, double sigma) {
  SKEIN_EXPECTS(sigma > 0);
  return -std::expm1(-distance * distance / (sigma * sigma)) * (idleness + dt);
}

Outcome<Patrol> refine(const PatrolQuery& query, const Setting& setting) {
  if (auto problem = check_patrol(query, setting.world)) return tl::unexpected(*problem);
  Deadline deadline(setting.budget);
  const auto ground = make_patrol_ground(query, setting.world, deadline);
  if (!ground) return tl::unexpected(ground.error());
  return PatrolRefiner(query, setting, **ground, deadline).refine();
}

}  // namespace skein::refiners
