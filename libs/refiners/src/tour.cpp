// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour.hpp"

#include "shared_checks.hpp"
#include "tour_checks.hpp"
#include "tour_legs.hpp"
#include "tour_rounds.hpp"

namespace skein::refiners {

Outcome<Tour> refine(const TourQuery& query, const Setting& setting) {
  if (auto problem = check(query)) return tl::unexpected(*problem);
  const Traveller who{query.vehicle, query.clearance, query.speed, query.depart};
  auto travel = Travel::over(who, setting, query.start, query.stops.front().gates.front().entry);
  if (!travel) return tl::unexpected(travel.error());

  TourLegs legs(query, *travel);
  if (auto problem = legs.find_closed()) return tl::unexpected(*problem);
  const auto order = TourRounds(legs, setting).run();
  if (!order) return tl::unexpected(legs.why_impossible());

  Refined<Tour> tour = legs.tour(*order);
  tour.effort.cut_short = tour.effort.cut_short || travel->cut_short();
  if (auto too_much = check_energy(tour.task.energy, query.vehicle, "the best tour found"))
    return tl::unexpected(*too_much);
  return tour;
}

}  // namespace skein::refiners
