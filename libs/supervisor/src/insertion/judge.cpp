// SPDX-License-Identifier: Apache-2.0
// Plans an order of high-level tasks and says whether the plan serves.
#include "insertion/judge.hpp"

#include <algorithm>

#include "book/wording.hpp"
#include "flight/retreat.hpp"
#include "insertion/places.hpp"
#include "insertion/slack.hpp"
#include "planning/plans.hpp"

namespace skein::supervisor {
namespace {

/// Sums of fractions are exact to this.
constexpr double kEnergyRounding = 1e-9;

/// The planner refuses what needs too much energy without the plan; here it is wanted all the same,
/// since it says how much is missing.
constexpr double kPlenty = 1e6;

PlanningRequest with_tasks(const PlanningRequest& base, Goals goals) {
  PlanningRequest request;
  request.knowledge = base.knowledge;
  request.world = base.world;
  request.situation = base.situation;
  request.situation.energy = kPlenty;
  request.seed = base.seed;
  request.budget = base.budget;
  request.tasks = std::move(goals);
  return request;
}

/// Nothing but a landing, and the way to it.
bool comes_down(const std::vector<mission::ElementaryTask>& tasks) {
  const bool lands = !tasks.empty() && tasks.back().type == "land";
  return lands && std::all_of(tasks.begin(), tasks.end(), [&](const mission::ElementaryTask& task) {
           return task.origin == tasks.back().origin;
         });
}

Goals without_bounds(Goals goals) {
  for (mission::HighLevelTask& goal : goals) goal.time = {};
  return goals;
}

}  // namespace

Planner real_planner() {
  return [plans = std::make_shared<Plans>()](const PlanningRequest& request) {
    return plans->plan(request);
  };
}

std::vector<mission::GoalId> ids_of(const Goals& goals) {
  std::vector<mission::GoalId> ids;
  ids.reserve(goals.size());
  for (const mission::HighLevelTask& goal : goals) ids.push_back(goal.id);
  return ids;
}

std::string in_one_line(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text;
}

double Judge::usable_energy() const {
  return base_.situation.energy - knowledge().vehicle.energy.reserve;
}

// Parts of one mapping have one number, whatever their share.
const Verdict& Judge::of(const Goals& order) {
  auto key = std::make_pair(ids_of(order), 0.0);
  for (const mission::HighLevelTask& goal : order) key.second += share_of(goal).value_or(0);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_.emplace(std::move(key), consider(order)).first->second;
}

// The least part that all have to give, by halves: the more they give the sooner all is over. Then
// some more, if they have it.
Verdict Judge::consider(const Goals& order) const {
  Verdict verdict = consider_as_it_is(order);
  const Slack slack(order, knowledge().vocabulary);
  if (verdict.serves || slack.none() || base_.budget.over()) return verdict;
  verdict = consider_as_it_is(slack.goals(Slack::kAll));
  if (!verdict.serves) return verdict;
  int enough = Slack::kAll;
  for (int few = 0; enough - few > 1 && !base_.budget.over();) {
    const int share = (enough + few) / 2;
    Verdict with = consider_as_it_is(slack.goals(share));
    (with.serves ? enough : few) = share;
    if (with.serves) verdict = std::move(with);
  }
  const int spare = slack.with_some_to_spare(enough);
  if (Verdict with = consider_as_it_is(slack.goals(spare)); with.serves) {
    verdict = std::move(with);
    enough = spare;
  }
  verdict.shortened = slack.shortened(enough);
  return verdict;
}

Result<mission::ElementaryPlan, PlanningFailure> Judge::plan_of(const Goals& order) const {
  return planner_(with_tasks(base_, order));
}

Verdict Judge::consider_as_it_is(const Goals& order) const {
  Verdict verdict;
  if (order.empty()) {
    verdict.plan.emplace().origin = base_.situation.origin;
  } else if (auto plan = plan_of(order)) {
    verdict.plan = *std::move(plan);
  } else {
    verdict.culprit = plan.error().culprit;
    verdict.reasons = std::move(plan.error().reasons);
    if (verdict.reasons.empty()) verdict.reasons.emplace_back("no plan was found");
    return verdict;
  }
  check_dates(verdict);
  check_order(order, verdict);
  check_energy(verdict);
  verdict.serves = verdict.reasons.empty();
  return verdict;
}

void Judge::check_dates(Verdict& verdict) const {
  std::vector<mission::ElementaryTask> all = standing_.tasks;
  all.insert(all.end(), verdict.plan->tasks.begin(), verdict.plan->tasks.end());
  verdict.schedule = schedule(all, standing_.seen, base_.situation.origin, standing_.bounds);
  if (verdict.schedule.controllable) return;
  const auto name = [&](std::uint64_t number) {
    const auto task = std::find_if(all.begin(), all.end(),
                                   [&](const auto& one) { return one.id.value() == number; });
    return task == all.end() ? std::string() : in_words(*task);
  };
  for (const Conflict& conflict : verdict.schedule.conflicts) {
    verdict.reasons.push_back(
        with_names("task " + to_text(conflict.task) + " " + conflict.why, "task", name));
    const auto task = std::find_if(
        verdict.plan->tasks.begin(), verdict.plan->tasks.end(),
        [&](const mission::ElementaryTask& candidate) { return candidate.id == conflict.task; });
    if (task != verdict.plan->tasks.end() && !verdict.culprit) verdict.culprit = task->origin;
  }
  if (verdict.reasons.empty()) verdict.reasons.emplace_back("its dates cannot be kept to");
}

// What comes true without a task of its own has no place in the network.
void Judge::check_order(const Goals& order, Verdict& verdict) const {
  const auto& tasks = verdict.plan->tasks;
  for (auto one = order.begin(); one != order.end(); ++one) {
    const auto bounds = standing_.bounds.of.find(one->id);
    if (bounds == standing_.bounds.of.end()) continue;
    for (const mission::GoalBound& bound : bounds->second) {
      const auto behind =
          std::find_if(one, order.end(), [&](const auto& other) { return other.id == bound.goal; });
      const bool flown = std::any_of(tasks.begin(), tasks.end(),
                                     [&](const auto& task) { return task.origin == bound.goal; });
      if (behind == order.end() || flown) continue;
      verdict.reasons.push_back("goal " + to_text(one->id) + " is to come after goal " +
                                to_text(bound.goal) + ", which comes true behind it");
      if (!verdict.culprit) verdict.culprit = one->id;
    }
  }
}

// What is left of a flight at its end is least there: from each point before, the plan itself is a
// way on to it. A UAV that only comes down does so whatever is left.
void Judge::check_energy(Verdict& verdict) const {
  const Situation& from = base_.situation;
  const auto& tasks = verdict.plan->tasks;
  const Retreat retreat(knowledge(), *base_.world, from.origin);
  const Whereabouts end = after({from.position, from.airborne}, tasks);
  const double home = retreat.after(end);
  const double needed = verdict.plan->energy + home;
  if (needed <= 0 || (from.airborne && comes_down(tasks))) return;
  const double missing = needed + kSpareEnergy - usable_energy();
  if (missing <= kEnergyRounding) return;
  verdict.missing_energy = missing;
  const std::string back =
      home > 0 ? ", " + percent(home) + " to come home from its end and land" : "";
  verdict.reasons.push_back("needs " + percent(verdict.plan->energy) + " of the energy" + back +
                            ", " + percent(kSpareEnergy) + " to spare, and " +
                            percent(std::max(usable_energy(), 0.0)) + " is left above the reserve");
}

std::optional<mission::ElementaryPlan> Judge::sketch(const Goals& order) const {
  PlanningRequest request = with_tasks(base_, without_bounds(order));
  auto plan = planner_(request);
  return plan ? std::optional(*std::move(plan)) : std::nullopt;
}

std::optional<mission::ElementaryPlan> Judge::sketch_in_the_air(const mission::HighLevelTask& goal,
                                                                const world::Vector3& aside) const {
  PlanningRequest request = with_tasks(base_, without_bounds({goal}));
  request.situation.position = in_the_air(base_) + aside;
  request.situation.airborne = true;
  request.situation.broken.clear();
  auto plan = planner_(request);
  return plan ? std::optional(*std::move(plan)) : std::nullopt;
}

}  // namespace skein::supervisor
