// SPDX-License-Identifier: Apache-2.0
// Operator 6: what is left of a plan after something happened to it.
#include "skein/supervisor/repair.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "flight/landing_place.hpp"
#include "flight/retreat.hpp"
#include "insertion/places.hpp"
#include "insertion/with.hpp"
#include "repair/replan.hpp"

namespace skein::supervisor {
namespace {

constexpr std::array<std::string_view, 7> kSteps{"absorb", "shift",           "re-refine", "drop",
                                                 "replan", "return and land", "fail"};

/// Landings end where the energy lasts to.
PlanningRequest with_landing_in_reach(PlanningRequest base) {
  const Situation& from = base.situation;
  if (!from.airborne) return base;
  const double left = from.energy - base.knowledge->vehicle.energy.reserve;
  const Retreat retreat(*base.knowledge, *base.world, from.origin);
  base.situation.land_at = retreat.instead_of_home(from.position, left);
  return base;
}

class Repair {
 public:
  Repair(const RepairRequest& request, const Planner& planner)
      : request_(request),
        base_(with_landing_in_reach(request.base)),
        planner_(planner),
        judge_(base_, request.standing, planner),
        roles_(judge_) {}

  RepairOutcome run() {
    if (request_.failed) {
      if (refine() || drop()) return std::move(outcome_);
    }
    if (!replan() && !go_home()) fail();
    return std::move(outcome_);
  }

 private:
  bool refine() {
    if (!request_.refine_failed) {
      outcome_.before.emplace_back("re-refine: it was refined often enough");
      return false;
    }
    if (request_.failed_goes_behind) {
      const std::size_t behind = position_behind_the_free();
      if (behind > position_of_failed() && try_order(RepairStep::kRefine, with_failed(behind)))
        return true;
    }
    return try_order(RepairStep::kRefine, with_failed());
  }

  /// Of what follows the one that failed: it waits for its turn, and another is done meanwhile.
  std::size_t position_behind_the_free() {
    std::size_t at = position_of_failed();
    if (roles_.of(*request_.failed) != Role::kFree) return at;
    while (at < request_.remaining.size() && roles_.of(request_.remaining[at]) == Role::kFree) ++at;
    return at;
  }

  bool drop() {
    outcome_.dropped.push_back({request_.failed->id, why_failed()});
    Goals order;
    const std::set<mission::GoalId> dependents = dependents_of_failed();
    for (const mission::HighLevelTask& goal : request_.remaining) {
      if (!dependents.contains(goal.id))
        order.push_back(goal);
      else
        outcome_.dropped.push_back({goal.id, "depends on what failed"});
    }
    if (!can_stand_alone(order)) {
      outcome_.before.emplace_back("drop: nothing is left");
    } else if (try_order(RepairStep::kDrop, order)) {
      return true;
    }
    outcome_.dropped.clear();
    return false;
  }

  bool replan() {
    Goals goals = request_.remaining;
    if (request_.failed && request_.refine_failed) goals = with_failed();
    if (request_.failed && !request_.refine_failed)
      outcome_.dropped.push_back({request_.failed->id, why_failed()});
    Replan::Outcome result = Replan(judge_, roles_).run(goals);
    outcome_.dropped.insert(outcome_.dropped.end(), result.dropped.begin(), result.dropped.end());
    if (result.verdict != nullptr) {
      serve(RepairStep::kReplan, result.order, *result.verdict);
      return true;
    }
    if (can_stand_alone({}) && try_order(RepairStep::kReplan, {})) return true;
    if (!result.reasons.empty())
      add_before(RepairStep::kReplan, result.reasons);
    else if (outcome_.before.empty())
      outcome_.before.emplace_back("replan: nothing is left");
    return false;
  }

  bool go_home() {
    if (!request_.retreat || !base_.situation.airborne) return false;
    const Goals order = {*request_.retreat};
    outcome_.dropped.clear();
    if (!try_order(RepairStep::kReturn, order) && !land_near(order)) return false;
    for (const mission::HighLevelTask& goal : everything())
      outcome_.dropped.push_back(
          {goal.id, "the UAV returns and lands: " + in_one_line(outcome_.before)});
    return true;
  }

  /// Where it cannot come home for other reasons than energy.
  bool land_near(const Goals& order) {
    const world::Vector3& from = base_.situation.position;
    PlanningRequest base = base_;
    base.situation.land_at =
        landing_place(*base.knowledge, *base.world, {base.situation.origin}, from, from);
    if (!base.situation.land_at) return false;
    Judge judge(base, request_.standing, planner_);
    const Verdict& verdict = judge.of(order);
    if (!verdict.serves) {
      add_before(RepairStep::kReturn, verdict.reasons);
      return false;
    }
    serve(RepairStep::kReturn, order, verdict);
    return true;
  }

  void fail() {
    outcome_.served = RepairStep::kFail;
    outcome_.plan.reset();
    outcome_.order.clear();
  }

  bool try_order(RepairStep step, const Goals& order) {
    const Verdict& verdict = judge_.of(order);
    if (!verdict.serves) {
      add_before(step, verdict.reasons);
      return false;
    }
    serve(step, order, verdict);
    return true;
  }

  void serve(RepairStep step, const Goals& order, const Verdict& verdict) {
    outcome_.served = step;
    outcome_.plan = verdict.plan;
    outcome_.schedule = verdict.schedule;
    outcome_.shortened = verdict.shortened;
    outcome_.order = order;
  }

  void add_before(RepairStep step, const std::vector<std::string>& reasons) {
    outcome_.before.push_back(std::string(to_text(step)) + ": " + in_one_line(reasons));
  }

  std::size_t position_of_failed() const {
    return std::min(request_.failed_at, request_.remaining.size());
  }

  Goals with_failed() const { return with_failed(position_of_failed()); }

  Goals with_failed(std::size_t at) const {
    Goals goals = request_.remaining;
    goals.insert(goals.begin() + static_cast<std::ptrdiff_t>(at), *request_.failed);
    return goals;
  }

  std::string why_failed() {
    if (!request_.refine_failed) return "failed, and was refined often enough";
    return "failed, and cannot be refined from here: " +
           in_one_line(judge_.of(with_failed()).reasons);
  }

  /// What was to be done at the place of the one that failed: those of its mission without a place
  /// that follow it. On the ground all depend on the only takeoff.
  std::set<mission::GoalId> dependents_of_failed() {
    const std::size_t from = position_of_failed();
    std::set<mission::GoalId> dependents;
    const bool takes_off = roles_.of(*request_.failed) == Role::kTakesOff;
    const bool placed = !takes_off && !gates_of(*request_.failed, base_).empty();
    const std::size_t end = takes_off ? end_without_takeoff(from)
                            : placed  ? end_without_place(from)
                                      : from;
    for (std::size_t i = from; i < end; ++i) {
      const mission::GoalId id = request_.remaining[i].id;
      if (takes_off || request_.given_with_failed.contains(id)) dependents.insert(id);
    }
    return dependents;
  }

  std::size_t end_without_place(std::size_t from) {
    const Goals& goals = request_.remaining;
    std::size_t end = from;
    while (end < goals.size() && roles_.of(goals[end]) == Role::kFree &&
           gates_of(goals[end], base_).empty())
      ++end;
    return end;
  }

  std::size_t end_without_takeoff(std::size_t from) {
    if (base_.situation.airborne) return from;
    std::size_t end = from;
    while (end < request_.remaining.size() && roles_.of(request_.remaining[end]) != Role::kTakesOff)
      ++end;
    return end;
  }

  /// Nothing more than what the executive has is enough as long as it has something to do.
  bool can_stand_alone(const Goals& order) {
    if (!order.empty()) return !is_futile(order, roles_, base_) || was_futile();
    if (everything().empty()) return true;
    return std::any_of(request_.standing.tasks.begin(), request_.standing.tasks.end(),
                       [&](const mission::ElementaryTask& task) {
                         const auto seen = request_.standing.seen.find(task.id);
                         return seen == request_.standing.seen.end() || !seen->second.over;
                       });
  }

  Goals everything() const { return request_.failed ? with_failed() : request_.remaining; }
  bool was_futile() { return is_futile(everything(), roles_, base_); }

  const RepairRequest& request_;
  PlanningRequest base_;
  const Planner& planner_;
  Judge judge_;
  Roles roles_;
  RepairOutcome outcome_;
};

}  // namespace

std::string_view to_text(RepairStep step) { return kSteps.at(static_cast<std::size_t>(step)); }

RepairOutcome repair_plan(const RepairRequest& request, const Planner& planner) {
  return Repair(request, planner).run();
}

RepairOutcome repair_plan(const RepairRequest& request) {
  return repair_plan(request, real_planner());
}

}  // namespace skein::supervisor
