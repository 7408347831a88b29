// SPDX-License-Identifier: Apache-2.0
// The whole that remains, planned anew without what cannot be.
#include "repair/replan.hpp"

#include <algorithm>

#include "insertion/orders.hpp"
#include "insertion/places.hpp"

namespace skein::supervisor {
namespace {

using mission::GoalId;
using mission::HighLevelTask;

/// What leaving out saves is counted as so much more than estimated: rather one plan more than a
/// task less.
constexpr double kHopeful = 1.1;

/// A part of a mapping that is left out is nothing by itself.
void add_parts(const Goals& goals, std::vector<Dropped>& dropped) {
  for (const HighLevelTask& goal : goals) {
    const auto whole = whole_of(goal);
    const auto with = std::find_if(dropped.begin(), dropped.end(),
                                   [&](const Dropped& one) { return whole && one.goal == *whole; });
    if (with == dropped.end()) continue;
    Dropped part{goal.id, "a part of goal " + to_text(*whole) + ", which is left out"};
    dropped.push_back(std::move(part));
  }
}

bool has(const std::vector<Dropped>& dropped, GoalId goal) {
  return std::any_of(dropped.begin(), dropped.end(),
                     [&](const Dropped& each) { return each.goal == goal; });
}

void remove(Goals& goals, const std::vector<Dropped>& dropped) {
  std::erase_if(goals, [&](const HighLevelTask& goal) { return has(dropped, goal.id); });
}

}  // namespace

bool is_futile(const Goals& order, Roles& roles, const PlanningRequest& base) {
  if (base.situation.airborne) return false;
  return std::none_of(order.begin(), order.end(), [&](const HighLevelTask& goal) {
    const Role role = roles.of(goal);
    return role == Role::kFree || role == Role::kWaits;
  });
}

Replan::Outcome Replan::run(Goals goals) {
  Outcome outcome;
  bool well_ordered = false;
  while (!goals.empty()) {
    Attempt attempt = best_of(goals, well_ordered);
    if (attempt.verdict->serves) {
      outcome.verdict = attempt.verdict;
      outcome.order = std::move(attempt.order);
      return outcome;
    }
    outcome.reasons = attempt.verdict->reasons;
    const bool futile = is_futile(goals, roles_, judge_.base());
    std::vector<Dropped> out = leave_out(goals, attempt);
    add_parts(goals, out);
    // What is left of a good order is in a good order: no other is tried to save energy.
    well_ordered = attempt.verdict->missing_energy > 0;
    if (well_ordered) goals = attempt.order;
    remove(goals, out);
    if (!futile && is_futile(goals, roles_, judge_.base()))
      for (const HighLevelTask& goal : goals)
        out.push_back({goal.id, "nothing is left to fly for"});
    remove(goals, out);
    outcome.dropped.insert(outcome.dropped.end(), out.begin(), out.end());
  }
  return outcome;
}

Replan::Attempt Replan::best_of(const Goals& goals, bool well_ordered) {
  Trials trials(judge_);
  const Verdict& as_it_is = trials.run(mission::Placement::kLast, goals);
  Attempt nearest{goals, &as_it_is};
  if (well_ordered && (as_it_is.serves || as_it_is.missing_energy > 0)) return nearest;
  // What cannot be planned at all cannot be in another order.
  if (!as_it_is.plan && as_it_is.culprit) {
    const auto culprit = std::find_if(goals.begin(), goals.end(), [&](const HighLevelTask& goal) {
      return goal.id == *as_it_is.culprit;
    });
    if (culprit != goals.end() && hopeless(goals, *culprit)) return nearest;
  }
  const Movable movable = movable_of(goals, {}, roles_, judge_.base());
  const auto attempt = [&](mission::Placement placement, const Blocks& blocks) {
    Goals order = order_of(movable, blocks);
    const Verdict& verdict = trials.run(placement, order);
    if (verdict.plan &&
        (!nearest.verdict->plan || verdict.missing_energy < nearest.verdict->missing_energy))
      nearest = {std::move(order), &verdict};
  };
  attempt(mission::Placement::kLast, all_blocks(movable));
  if (bounded_in_time(goals))
    attempt(mission::Placement::kInTime,
            urgent_in_time(movable, sketch_of(judge_, goals), judge_.base()));
  attempt(mission::Placement::kTour, tour_over(movable, judge_.base()));
  if (const auto& best = trials.best()) return {best->order, best->verdict};
  return nearest;
}

std::optional<std::string> Replan::hopeless(const Goals& goals, const HighLevelTask& goal) {
  const Role role = roles_.of(goal);
  Goals frame, alone;
  for (const HighLevelTask& each : goals) {
    const Role its = roles_.of(each);
    if (its == Role::kTakesOff && role != Role::kTakesOff) frame.push_back(each);
  }
  alone = frame;
  alone.push_back(goal);
  if (role == Role::kFree || role == Role::kWaits) {
    Goals landing;
    for (const HighLevelTask& each : goals)
      if (roles_.of(each) == Role::kLands) landing.push_back(each);
    frame.insert(frame.end(), landing.begin(), landing.end());
    if (judge_.of(frame).serves) alone.insert(alone.end(), landing.begin(), landing.end());
  }
  const Verdict& verdict = judge_.of(alone);
  // A UAV with too little energy must land all the same, as long as there is a way.
  const bool ends = role == Role::kLands && verdict.plan;
  if (verdict.serves || ends) return std::nullopt;
  return "cannot be planned: " + in_one_line(verdict.reasons);
}

std::vector<Dropped> Replan::leave_out(const Goals& goals, const Attempt& attempt) {
  if (attempt.verdict->culprit) {
    for (const HighLevelTask& goal : goals)
      if (goal.id == *attempt.verdict->culprit)
        if (auto why = hopeless(goals, goal)) return {{goal.id, *std::move(why)}};
  }
  if (!attempt.verdict->culprit && attempt.verdict->missing_energy <= 0) {
    std::vector<Dropped> out;
    for (const HighLevelTask& goal : goals)
      if (auto why = hopeless(goals, goal)) out.push_back({goal.id, *std::move(why)});
    if (!out.empty()) return out;
  }
  return leave_out_most(goals, attempt);
}

std::vector<std::size_t> Replan::candidates(const Attempt& attempt) {
  const Goals& order = attempt.order;
  std::size_t end = order.size();
  if (attempt.verdict->culprit && attempt.verdict->missing_energy <= 0) {
    const auto ids = ids_of(order);
    const auto culprit = std::find(ids.begin(), ids.end(), *attempt.verdict->culprit);
    if (culprit != ids.end()) end = static_cast<std::size_t>(culprit - ids.begin()) + 1;
  }
  for (const std::size_t bound : {end, order.size()}) {
    for (const Role role : {Role::kFree, Role::kWaits, Role::kLands, Role::kTakesOff}) {
      std::vector<std::size_t> found;
      for (std::size_t i = 0; i < bound; ++i)
        if (roles_.of(order[i]) == role) found.push_back(i);
      // Only what is free may be left out for the sake of one in particular.
      if (!found.empty() && (bound == order.size() || role == Role::kFree)) return found;
    }
  }
  return {};
}

std::vector<Dropped> Replan::leave_out_most(const Goals& goals, const Attempt& attempt) {
  const Sketch sketch = attempt.verdict->plan ? Sketch(*attempt.verdict->plan,
                                                       judge_.knowledge().vehicle.cruise_speed)
                                              : sketch_of(judge_, goals);
  if (attempt.verdict->missing_energy > 0) return save_energy(attempt, sketch);
  const auto among = candidates(attempt);
  const world::Vector3 start = in_the_air(judge_.base());
  const auto most = *std::max_element(among.begin(), among.end(), [&](auto a, auto b) {
    return sketch.saving(attempt.order, a, start).seconds <
           sketch.saving(attempt.order, b, start).seconds;
  });
  return {{attempt.order[most].id, "left out, so that the others can be done in time: " +
                                       in_one_line(attempt.verdict->reasons)}};
}

std::vector<Dropped> Replan::save_energy(const Attempt& attempt, const Sketch& sketch) {
  std::vector<Dropped> out;
  Attempt left = attempt;
  const world::Vector3 start = in_the_air(judge_.base());
  double missing = attempt.verdict->missing_energy;
  do {
    const auto among = candidates(left);
    const auto most = *std::max_element(among.begin(), among.end(), [&](auto a, auto b) {
      return sketch.saving(left.order, a, start).energy <
             sketch.saving(left.order, b, start).energy;
    });
    missing -= sketch.saving(left.order, most, start).energy * kHopeful;
    const bool free = roles_.of(left.order[most]) == Role::kFree;
    out.push_back({left.order[most].id,
                   "left out to save energy: all " + in_one_line(attempt.verdict->reasons)});
    left.order.erase(left.order.begin() + static_cast<std::ptrdiff_t>(most));
    if (!free) break;
  } while (missing > 0 && !left.order.empty());
  return out;
}

}  // namespace skein::supervisor
