// SPDX-License-Identifier: Apache-2.0
// Operator 1: where new high-level tasks go among those already planned.
#include "skein/supervisor/insertion.hpp"

#include "insertion_trials.hpp"
#include "insertion_with.hpp"
#include "placement_orders.hpp"

namespace skein::supervisor {
namespace {

using mission::Placement;

class Insertion {
 public:
  Insertion(const InsertionRequest& request, const Planner& planner)
      : request_(request), judge_(request.base, request.standing, planner), trials_(judge_) {}

  InsertionOutcome run() {
    // A mission by itself is planned as it was asked for, unless a placement is asked for, too.
    const bool alone = request_.planned.empty() || request_.added.empty();
    const Placement wanted = request_.placement;
    if (alone && wanted != Placement::kTour) {
      trials_.run(wanted == Placement::kBest ? Placement::kLast : wanted, as_asked());
    } else {
      Roles roles(judge_);
      movable_ = movable_of(request_.planned, request_.added, roles, request_.base);
      try_placements();
    }
    return outcome();
  }

 private:
  Goals as_asked() const {
    Goals order = request_.planned;
    order.insert(order.end(), request_.added.begin(), request_.added.end());
    return order;
  }

  void try_placements() {
    const bool best = request_.placement == Placement::kBest;
    const auto wanted = [&](Placement placement) {
      return best ? placement != Placement::kFirst : placement == request_.placement;
    };
    const Goals last = order_of(movable_, all_blocks(movable_));
    if (wanted(Placement::kLast)) trials_.run(Placement::kLast, last);
    if (enough()) return;
    if (wanted(Placement::kInTime) && (!best || bounded_in_time(last))) in_time(last);
    if (enough()) return;
    if (wanted(Placement::kTour))
      trials_.run(Placement::kTour, order_of(movable_, tour_over(movable_, request_.base)));
    if (wanted(Placement::kFirst)) first();
  }

  // An answer at any time: what was found when the budget is spent.
  bool enough() const { return trials_.best() && request_.base.budget.over(); }

  void in_time(const Goals& last) {
    const Sketch sketch = sketch_of(judge_, last);
    const Blocks merged = merge_in_time(movable_, sketch, request_.base);
    trials_.run(Placement::kInTime, order_of(movable_, merged));
  }

  void first() {
    Blocks blocks = movable_.added;
    blocks.insert(blocks.end(), movable_.planned.begin(), movable_.planned.end());
    trials_.run(Placement::kFirst, order_of(movable_, blocks));
  }

  InsertionOutcome outcome() {
    InsertionOutcome outcome;
    if (const auto& best = trials_.best()) {
      outcome.plan = best->verdict->plan;
      outcome.schedule = best->verdict->schedule;
      outcome.order = best->order;
      outcome.chosen = best->placement;
    } else {
      outcome.reasons = trials_.reasons();
    }
    outcome.trials = trials_.take();
    return outcome;
  }

  const InsertionRequest& request_;
  Judge judge_;
  Trials trials_;
  Movable movable_;
};

}  // namespace

InsertionOutcome insert_tasks(const InsertionRequest& request, const Planner& planner) {
  return Insertion(request, planner).run();
}

InsertionOutcome insert_tasks(const InsertionRequest& request) {
  return insert_tasks(request, real_planner());
}

}  // namespace skein::supervisor
