// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/refiners/checks.hpp"
#include "viewpoint/checks.hpp"
#include "viewpoint/choice.hpp"
#include "viewpoint/search.hpp"

namespace skein::refiners {
namespace {

/// How often a budget's clock is asked, in places judged.
constexpr std::uint32_t kStride = 64;

Refined<Viewpoints> answer(const ViewpointField& field, const std::vector<Found>& chosen,
                           const Countdown& countdown, const world::Wind& wind) {
  Refined<Viewpoints> refined;
  for (const Found& found : chosen) refined.task.points.push_back(field.view_point(found.bearing));
  refined.task.sight_checks = field.sight_checks();
  const ViewPoint& best = refined.task.points.front();
  refined.cost = 1 - best.utility;
  const ViewpointQuery& query = field.query();
  if (query.from)
    refined.duration = estimate_flight({*query.from, best.position}, query.vehicle, wind).duration;
  refined.effort = {countdown.steps(), countdown.cut_short()};
  return refined;
}

}  // namespace

Outcome<Viewpoints> refine(const ViewpointQuery& query, const Setting& setting) {
  const auto sensor = sensor_of(query.vehicle, query.device);
  if (!sensor) return tl::make_unexpected(sensor.error());
  if (auto problem = check(query, setting.world, **sensor))
    return tl::make_unexpected(std::move(*problem));

  ViewpointField field(query, setting, **sensor);
  Countdown countdown(setting.budget, kStride);
  ViewpointSearch search(field, countdown);
  std::vector<Found> chosen = choose(search, field, countdown);
  const auto none_in_time = [&] {
    return refuse(RefusalKind::kBudgetExhausted, "",
                  "no place to look from was found among the first " +
                      std::to_string(countdown.steps()) + " looked at");
  };
  if (chosen.empty() && countdown.over()) return none_in_time();
  if (chosen.empty()) {
    Deadline deadline(setting.budget);
    const ViewpointSearch::Survey survey = search.survey(deadline);
    if (!survey.best && deadline.is_over()) return none_in_time();
    if (!survey.best) return tl::make_unexpected(explain(field, survey));
    chosen.push_back(*survey.best);
  }
  return answer(field, chosen, countdown, setting.world.wind);
}

}  // namespace skein::refiners
