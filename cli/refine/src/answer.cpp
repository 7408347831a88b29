// SPDX-License-Identifier: Apache-2.0
#include "answer.hpp"

#include "skein/foundation/overloaded.hpp"
#include "skein/refiners/area_gates.hpp"
#include "skein/sampling/sampling_path_planner.hpp"

namespace skein::refine_tool {
namespace {

template <class Question>
Answer ask(const Question& question, const refiners::Setting& setting) {
  auto outcome = refiners::refine(question, setting);
  if (!outcome) return tl::make_unexpected(std::move(outcome.error()));
  return Solution(std::move(*outcome));
}

Answer ask_tour(TourWithAreas& question, const refiners::Setting& setting) {
  for (const AreaStop& area : question.areas) {
    refiners::Stop& stop = question.tour.stops[area.stop];
    auto gates = refiners::gates_of(area.coverage, setting);
    if (!gates) {
      refiners::Refusal refusal = std::move(gates.error());
      refusal.field = "stops." + stop.name + (refusal.field.empty() ? "" : "." + refusal.field);
      return tl::make_unexpected(std::move(refusal));
    }
    stop.gates = std::move(*gates);
  }
  return ask(question.tour, setting);
}

}  // namespace

Answer answer(Query& query, std::function<bool()> time_is_up) {
  const sampling::SamplingPathPlanner sampling;
  refiners::Setting setting{
      .world = query.world, .budget = {}, .seed = query.seed, .paths = nullptr};
  setting.budget.time_is_up = std::move(time_is_up);
  if (query.steps) setting.budget.steps = *query.steps;
  if (query.planner == Planner::kSampling) setting.paths = &sampling;
  return std::visit(Overloaded{[&](TourWithAreas& tour) { return ask_tour(tour, setting); },
                               [&](const auto& question) { return ask(question, setting); }},
                    query.question);
}

}  // namespace skein::refine_tool
