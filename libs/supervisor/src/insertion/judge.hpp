// SPDX-License-Identifier: Apache-2.0
// Plans an order of high-level tasks and says whether the plan serves.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/supervisor/insertion.hpp"

namespace skein::supervisor {

/// What gives the plans of plan_tasks, or takes its place in tests.
using Planner =
    std::function<Result<mission::ElementaryPlan, PlanningFailure>(const PlanningRequest&)>;
/// With what its plans have in common kept (planning/plans.hpp): for one job.
Planner real_planner();

using Goals = std::vector<mission::HighLevelTask>;
std::vector<mission::GoalId> ids_of(const Goals& goals);

/// With semicolons between.
std::string in_one_line(const std::vector<std::string>& reasons);

/// What is to be said of one order.
struct Verdict {
  bool serves = false;
  std::optional<mission::ElementaryPlan> plan;  ///< may be there though it does not serve
  Schedule schedule;                            ///< of what stands and the plan; without plan empty
  double missing_energy = 0;                    ///< what the plan needs beyond what may be used
  std::optional<mission::GoalId> culprit;       ///< that could not be refined, or comes too late
  std::vector<Shortened> shortened;             ///< what it takes to serve
  std::vector<std::string> reasons;             ///< why it does not serve, durations least
};

/// A plan serves when it can be made, is dynamically controllable together with what stands, and
/// needs no more energy, the way home from its end and something to spare with it (retreat.hpp),
/// than is left above the vehicle's reserve. No order is planned twice; one that does not serve is
/// with shorter durations (slack.hpp), as long as can be, where they may be.
class Judge {
 public:
  /// Lifetime: `base` and `standing` must outlive it.
  Judge(const PlanningRequest& base, const Standing& standing, Planner planner)
      : base_(base), standing_(standing), planner_(std::move(planner)) {}

  /// As that one, of other things that stand. Lifetime: as its base, and `standing`.
  Judge(const Judge& other, const Standing& standing)
      : base_(other.base_), standing_(standing), planner_(other.planner_) {}

  /// Valid as long as the judge. Of no tasks the plan is empty.
  const Verdict& of(const Goals& order);
  /// What the planner makes of it, with all the energy there could be.
  Result<mission::ElementaryPlan, PlanningFailure> plan_of(const Goals& order) const;
  /// A plan for estimates only, without time constraints and with all the energy there could be.
  std::optional<mission::ElementaryPlan> sketch(const Goals& order) const;
  /// As sketch, of one task from the air, whatever is broken; `aside` of where it is [m].
  std::optional<mission::ElementaryPlan> sketch_in_the_air(
      const mission::HighLevelTask& goal,
      const world::Vector3& aside = world::Vector3::Zero()) const;

  const PlanningRequest& base() const { return base_; }
  const Standing& standing() const { return standing_; }
  const Knowledge& knowledge() const { return *base_.knowledge; }
  /// Fraction of what is held when full that a plan may use.
  double usable_energy() const;

 private:
  Verdict consider(const Goals& order) const;
  Verdict consider_as_it_is(const Goals& order) const;
  void check_dates(Verdict& verdict) const;
  void check_order(const Goals& order, Verdict& verdict) const;
  void check_energy(Verdict& verdict) const;

  const PlanningRequest& base_;
  const Standing& standing_;
  Planner planner_;
  std::map<std::pair<std::vector<mission::GoalId>, double>, Verdict> known_;
};

}  // namespace skein::supervisor
