// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/deadline.hpp"
#include "common/heights_over.hpp"
#include "common/shared_checks.hpp"
#include "evaluate/volumes.hpp"
#include "skein/refiners/flyable.hpp"
#include "tour/checks.hpp"

namespace skein::refiners {
namespace {

/// Of the chords that a curve in a way was made of [m].
constexpr double kChordTolerance = 0.5;
/// About what a leg over the ground takes, and a volume beside it [ns].
constexpr std::uint32_t kLeg = 5000, kVolume = 300;

class WayEvaluator {
 public:
  WayEvaluator(const EvaluateQuery& query, const Setting& setting)
      : query_(query),
        world_(setting.world),
        deadline_(setting.budget),
        speed_(query.speed > 0 ? query.speed : query.vehicle.cruise_speed) {}

  Outcome<Evaluation> run() {
    const Flight flight = fly(query_.way);
    evaluation_.length = flight.length;
    evaluation_.energy = flight.energy;
    evaluation_.least_height = std::numeric_limits<double>::infinity();
    for (std::size_t leg = 0; leg + 1 < query_.way.size(); ++leg) {
      if (!deadline_.passed_after(kLeg)) evaluate_leg(leg);
      // What stands beside the leg may not have been looked at.
      if (deadline_.is_over()) return late_at(leg);
    }
    check_limits(flight);
    Refined<Evaluation> refined;
    refined.cost = flight.duration.expected == Duration::max()
                       ? std::numeric_limits<double>::infinity()
                       : flight.duration.expected.to_seconds();
    refined.duration = flight.duration;
    refined.effort.steps = query_.way.size() - 1;
    refined.task = std::move(evaluation_);
    return refined;
  }

 private:
  tl::unexpected<Refusal> late_at(std::size_t leg) const {
    return refuse(RefusalKind::kBudgetExhausted, "way",
                  "the time was up at leg " + std::to_string(leg + 1) + " of " +
                      std::to_string(query_.way.size() - 1));
  }
  Flight fly(const Way& way) const {
    return estimate_flight(way, query_.vehicle, world_.wind, query_.speed);
  }

  void evaluate_leg(std::size_t leg) {
    const world::Vector3 &from = query_.way[leg], &to = query_.way[leg + 1];
    evaluation_.climb += std::max(0.0, to.z() - from.z());
    const HeightRange heights = heights_over(world_.terrain, from, to);
    evaluation_.least_height = std::min(evaluation_.least_height, heights.least);
    greatest_height_ = std::max(greatest_height_, heights.greatest);
    check_steepness(leg);

    if (const auto hit = world_.terrain.first_hit(from, to, query_.clearance))
      evaluation_.obstructions.push_back({leg, from + *hit * (to - from), "ground"});
    const DurationInterval takes = fly({from, to}).duration;
    const LegTimes times{query_.depart + flown_.least, query_.depart + flown_.most, takes.least,
                         takes.most};
    for (const auto* volumes : {&world_.volumes, &query_.reserved})
      for (const world::Volume& volume : *volumes)
        if (!deadline_.passed_after(kVolume)) check_volume(leg, times, volume);
    flown_ = {flown_.least + takes.least, {}, flown_.most + takes.most};
  }

  void check_volume(std::size_t leg, const LegTimes& times, const world::Volume& volume) {
    const world::Vector3 &from = query_.way[leg], &to = query_.way[leg + 1];
    for (const LegPart& part : parts_inside(volume, from, to))
      if (const auto first = first_within(part, times, volume.when)) {
        evaluation_.obstructions.push_back({leg, from + *first * (to - from), volume.name});
        return;
      }
  }

  /// Only a vehicle that cannot slow down on its climb minds.
  void check_steepness(std::size_t leg) {
    if (query_.vehicle.hovers) return;
    const world::Vector3 step = query_.way[leg + 1] - query_.way[leg];
    const double rate = step.z() > 0 ? query_.vehicle.climb_rate : query_.vehicle.descent_rate;
    const double needed = std::abs(step.z()) * speed_ / step.head<2>().norm();
    if (step.z() != 0 && needed > rate * (1 + 1e-9))
      limit("leg " + std::to_string(leg + 1) + (step.z() > 0 ? " climbs" : " descends") + " at " +
            rounded(needed) + " m/s at that speed; at most " + rounded(rate) + " m/s is possible");
  }

  void check_limits(const Flight& flight) {
    const world::VehicleModel& vehicle = query_.vehicle;
    if (query_.speed > vehicle.max_speed)
      limit("the speed, " + rounded(query_.speed) + " m/s, is above the greatest, " +
            rounded(vehicle.max_speed) + " m/s");
    if (query_.speed > 0 && query_.speed < vehicle.min_speed)
      limit("the speed, " + rounded(query_.speed) + " m/s, is below the least, " +
            rounded(vehicle.min_speed) + " m/s");
    if (greatest_height_ > vehicle.ceiling)
      limit("the way goes " + rounded(greatest_height_) + " m above the ground; the ceiling is " +
            rounded(vehicle.ceiling) + " m");
    if (!vehicle.hovers && evaluation_.limits.empty() &&
        !is_flyable(query_.way, vehicle, speed_, kChordTolerance))
      limit("a turn is sharper than the least radius, " + rounded(vehicle.min_turn_radius) + " m");
    if (flight.duration.expected == Duration::max())
      limit("the wind is too strong for a leg");
    else if (const auto too_much = check_energy(flight.energy, vehicle, "the way"))
      limit(too_much->why);
  }

  void limit(std::string sentence) { evaluation_.limits.push_back(std::move(sentence)); }

  const EvaluateQuery& query_;
  const world::World& world_;
  Deadline deadline_;
  double speed_;
  Evaluation evaluation_;
  DurationInterval flown_;  // before the present leg
  double greatest_height_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Outcome<Evaluation> refine(const EvaluateQuery& query, const Setting& setting) {
  if (auto problem = check(query)) return tl::unexpected(*problem);
  return WayEvaluator(query, setting).run();
}

}  // namespace skein::refiners
