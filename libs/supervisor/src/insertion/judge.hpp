// SPDX-License-Identifier: Apache-2.0
// Plans an order of high-level tasks and judges whether the plan is feasible.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/supervisor/insertion.hpp"

namespace skein::supervisor {

/// plan_tasks(), or its replacement in tests.
using Planner =
    std::function<Result<mission::ElementaryPlan, PlanningFailure>(const PlanningRequest&)>;
/// A planner for one job that caches what its plans have in common (planning/plans.hpp).
Planner real_planner();

using Goals = std::vector<mission::HighLevelTask>;
std::vector<mission::GoalId> ids_of(const Goals& goals);

/// Joined with semicolons.
std::string in_one_line(const std::vector<std::string>& reasons);

/// The judgement of one order.
struct Verdict {
  bool serves = false;                          ///< the plan is feasible
  std::optional<mission::ElementaryPlan> plan;  ///< may be present though it is not feasible
  Schedule schedule;                            ///< of the standing tasks and the plan; else empty
  double missing_energy = 0;                    ///< beyond usable_energy() [fraction of capacity]
  std::optional<mission::GoalId> culprit;       ///< the goal that has no plan, or is too late
  std::vector<Shortened> shortened;             ///< durations shortened to make it feasible
  std::vector<std::string> reasons;             ///< why it is infeasible, with least durations
};

/// A plan is feasible ("serves") if it exists, is dynamically controllable together with the
/// standing tasks, and its energy, including the way home from its end and a margin (retreat.hpp),
/// is at most what is left above the vehicle's reserve. Verdicts are cached. An infeasible order is
/// tried with shorter durations (slack.hpp) where these are ranges, and keeps the longest feasible
/// ones.
class Judge {
 public:
  /// Lifetime: `base` and `standing` must outlive it.
  Judge(const PlanningRequest& base, const Standing& standing, Planner planner)
      : base_(base), standing_(standing), planner_(std::move(planner)) {}

  /// A copy with other standing tasks. Lifetime: as for `other`, and `standing` must outlive it.
  Judge(const Judge& other, const Standing& standing)
      : base_(other.base_), standing_(standing), planner_(other.planner_) {}

  /// The verdict on an order; valid as long as the judge. The plan of an empty order is empty.
  const Verdict& of(const Goals& order);
  /// The plan of an order as if energy were unlimited.
  Result<mission::ElementaryPlan, PlanningFailure> plan_of(const Goals& order) const;
  /// A plan for estimates only: without time constraints, and as if energy were unlimited.
  std::optional<mission::ElementaryPlan> sketch(const Goals& order) const;
  /// The same for one task, begun in the air at `aside` [m] from the UAV's position, as if all
  /// devices worked.
  std::optional<mission::ElementaryPlan> sketch_in_the_air(
      const mission::HighLevelTask& goal,
      const world::Vector3& aside = world::Vector3::Zero()) const;

  const PlanningRequest& base() const { return base_; }
  const Standing& standing() const { return standing_; }
  const Knowledge& knowledge() const { return *base_.knowledge; }
  /// Energy that a plan may use, as a fraction of the full capacity.
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
