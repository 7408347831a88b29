// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour.hpp"

#include "common/shared_checks.hpp"
#include "tour/checks.hpp"
#include "tour/legs.hpp"
#include "tour/rounds.hpp"

namespace skein::refiners {

namespace {

/// With more gates the time may be up before anything is known of all the ways between them.
constexpr std::size_t kManyGates = 1000;

Outcome<Tour> toured(const TourQuery& query, const Setting& setting, Travel& travel) {
  TourLegs legs(query, travel);
  if (auto problem = legs.find_closed()) return tl::unexpected(*problem);
  const auto order = TourRounds(legs, setting).run();
  if (!order) return tl::unexpected(legs.why_impossible());
  Refined<Tour> tour = legs.tour(*order);
  tour.effort.cut_short = tour.effort.cut_short || travel.cut_short();
  if (auto too_much = check_energy(tour.task.energy, query.vehicle, "the best tour found"))
    return tl::unexpected(*too_much);
  return tour;
}

std::size_t gates_of(const TourQuery& query) {
  std::size_t gates = 0;
  for (const Stop& stop : query.stops) gates += stop.gates.size();
  return gates;
}

/// By the first gate of each stop only.
Outcome<Tour> roughly_toured(TourQuery query, const Setting& setting, Travel& travel) {
  for (Stop& stop : query.stops) stop.gates.resize(1);
  Setting rough{setting.world, setting.budget, setting.seed, setting.paths};
  rough.budget.steps = query.stops.size();
  Outcome<Tour> tour = toured(query, rough, travel);
  if (tour) tour->task.exact = false;
  if (tour) tour->effort.cut_short = true;
  return tour;
}

}  // namespace

Outcome<Tour> refine(const TourQuery& query, const Setting& setting) {
  if (auto problem = check(query)) return tl::unexpected(*problem);
  const Traveller who{query.vehicle, query.clearance, query.speed, query.depart};
  auto travel = Travel::over(who, setting, query.start, query.stops.front().gates.front().entry);
  if (!travel) return tl::unexpected(travel.error());
  if (!setting.budget.time_is_up || gates_of(query) <= kManyGates)
    return toured(query, setting, *travel);
  Outcome<Tour> rough = roughly_toured(query, setting, *travel);
  if (rough && setting.budget.expired()) return rough;
  Outcome<Tour> tour = toured(query, setting, *travel);
  const bool late =
      tour ? tour->effort.cut_short : tour.error().kind == RefusalKind::kBudgetExhausted;
  return rough && late && (!tour || rough->cost < tour->cost) ? rough : tour;
}

}  // namespace skein::refiners
