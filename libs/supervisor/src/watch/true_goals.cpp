// SPDX-License-Identifier: Apache-2.0
#include "watch/true_goals.hpp"

#include <algorithm>

#include "flight/flight_times.hpp"

namespace skein::supervisor {

namespace {

/// A goal without tasks is true as near as this to where the plan has it [m]; no nearer than a plan
/// may begin away from where it was made for.
constexpr double kThere = 25;

}  // namespace

void TrueGoals::foresee() {
  Situation at = situations_.place_after(book_.standing());
  for (const GoalId id : book_.free_goals()) {
    Goal& goal = book_.goals.at(id);
    goal.true_at.reset();
    const auto tasks = book_.of(id);
    for (const Entry* entry : tasks) move(entry->task, at);
    if (tasks.empty()) goal.true_at = Whereabouts{at.position, at.airborne};
  }
}

bool TrueGoals::is_there(const Whereabouts& expected) const {
  const world::VehicleModel& vehicle = beliefs_.model();
  const double wavers = 2 + arrival_distance(vehicle, beliefs_.world().wind) +
                        (vehicle.hovers ? 0 : vehicle.orbit_radius);
  return beliefs_.vehicle().airborne == expected.airborne &&
         (beliefs_.vehicle().position - expected.position).norm() <= std::max(kThere, wavers);
}

void TrueGoals::settle() {
  if (agenda_.repairing()) return;
  for (const GoalId id : std::vector<GoalId>(book_.order)) {
    Goal& goal = book_.goals.at(id);
    if (!goal.open() || goal.queued) continue;
    if (!goal.true_at || !book_.of(id).empty()) return;
    if (!is_there(*goal.true_at)) {
      goal.true_at.reset();
      return contingencies_.fail_goal(
          id, "goal " + to_text(id) + " was to be true without tasks, and is not");
    }
    out_.set_state(goal, GoalState::kAchieved);
    contingencies_.check_network("goal " + to_text(id) + " is true");
    if (agenda_.repairing()) return;
  }
}

}  // namespace skein::supervisor
