// SPDX-License-Identifier: Apache-2.0
// Operator 1: where new high-level tasks go among those already planned.
#include "skein/supervisor/insertion.hpp"

#include <algorithm>

#include "insertion/orders.hpp"
#include "insertion/parts.hpp"
#include "insertion/relaxations.hpp"
#include "insertion/trials.hpp"
#include "insertion/with.hpp"
#include "repair/replan.hpp"

namespace skein::supervisor {
namespace {

using mission::Placement;

class Insertion {
 public:
  Insertion(const InsertionRequest& request, const Planner& planner)
      : request_(request),
        judge_(request.base, request.standing, planner),
        roles_(judge_),
        trials_(judge_),
        added_(request.added) {}

  InsertionOutcome run() {
    try_all();
    while (request_.any && !trials_.best() && !added_.empty()) {
      leave_one_out();
      if (!added_.empty()) try_all();
    }
    return outcome();
  }

 private:
  static constexpr int kShares = 8;  ///< that lanes are parted by

  void try_all() {
    from_ = trials_.all().size();
    // A mission by itself is planned as it was asked for, unless a placement is asked for, too.
    const bool alone = request_.planned.empty() || added_.empty();
    const Placement wanted = request_.placement;
    if (alone && wanted != Placement::kTour) {
      trials_.run(wanted == Placement::kBest ? Placement::kLast : wanted, as_asked());
      if (may_part()) movable_ = movable_of(request_.planned, added_, roles_, request_.base);
    } else {
      movable_ = movable_of(request_.planned, added_, roles_, request_.base);
      try_placements();
    }
    if (may_part()) try_parts();
  }

  // ---- in parts ----

  bool may_part() const {
    const Placement wanted = request_.placement;
    return request_.part && !trials_.best() && !request_.base.budget.over() &&
           (wanted == Placement::kBest || wanted == Placement::kInTime) &&
           bounded_in_time(as_asked());
  }

  void try_parts() {
    for (const mission::HighLevelTask& mapping : whole_mappings(movable_)) {
      int share = kShares / 2;
      for (int step = share; step > 0 && !request_.base.budget.over();) {
        const bool more = try_part(part_of(mapping, *request_.part, double(share) / kShares));
        step /= 2;
        share += more ? step : -step;
      }
      if (trials_.best()) return;
    }
  }

  // What has dates where it is least late, else where it was asked for. True when more of the lanes
  // may be before it: when that serves, or it is the mapping that is too late.
  bool try_part(const mission::HighLevelTask& part) {
    const Movable parted = with_part(movable_, part);
    const Blocks asked = all_blocks(parted);
    const Sketch sketch = sketch_of(judge_, order_of(parted, asked));
    Goals order = order_of(parted, urgent_in_time(parted, sketch, request_.base));
    if (!parts_stand_apart(order, part)) order = order_of(parted, rest_behind_dates(asked, part));
    if (!parts_stand_apart(order, part)) return false;
    const Verdict& verdict = trials_.run(Placement::kInTime, order);
    return verdict.serves || verdict.culprit == whole_of(part);
  }

  // The first added task that a trial failed for, else the last that is free; then what is left may
  // be nothing to fly for.
  void leave_one_out() {
    auto out = added_.end();
    std::string why;
    for (std::size_t i = from_; i < trials_.all().size() && out == added_.end(); ++i) {
      const Trial& trial = trials_.all()[i];
      out = find(trial.culprit);
      why = in_one_line(trial.reasons);
    }
    if (out == added_.end()) out = last_free();
    dropped_.push_back({out->id, why});
    added_.erase(out);
    Goals left = request_.planned;
    left.insert(left.end(), added_.begin(), added_.end());
    if (!is_futile(left, roles_, request_.base)) return;
    for (const mission::HighLevelTask& goal : added_)
      dropped_.push_back({goal.id, "nothing is left to fly for"});
    added_.clear();
  }

  Goals::iterator find(const std::optional<mission::GoalId>& id) {
    return std::find_if(added_.begin(), added_.end(),
                        [&](const mission::HighLevelTask& goal) { return goal.id == id; });
  }

  Goals::iterator last_free() {
    for (auto goal = added_.end(); goal != added_.begin();)
      if (roles_.of(*--goal) == Role::kFree) return goal;
    return added_.end() - 1;
  }

  // Without a plan: whose fault that is.
  std::vector<Dropped> culprits() {
    std::vector<Dropped> result;
    for (const Trial& trial : trials_.all()) {
      const bool known = std::any_of(result.begin(), result.end(),
                                     [&](const Dropped& one) { return one.goal == trial.culprit; });
      if (trial.culprit && !known) result.push_back({*trial.culprit, in_one_line(trial.reasons)});
    }
    return result;
  }

  Goals as_asked() const {
    Goals order = request_.planned;
    order.insert(order.end(), added_.begin(), added_.end());
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
      outcome.shortened = best->verdict->shortened;
    } else {
      outcome.reasons = trials_.reasons();
      if (!request_.any) outcome.relaxations = relaxations_for(judge_, as_asked());
      if (dropped_.empty()) dropped_ = culprits();
    }
    outcome.dropped = std::move(dropped_);
    outcome.trials = trials_.take();
    return outcome;
  }

  const InsertionRequest& request_;
  Judge judge_;
  Roles roles_;
  Trials trials_;
  std::size_t from_ = 0;  ///< the first trial of what is tried now
  Goals added_;           ///< without what was left out
  std::vector<Dropped> dropped_;
  Movable movable_;
};

}  // namespace

// What keeps whatever others do is best; else what can be kept to if they do their best.
InsertionOutcome insert_tasks(const InsertionRequest& request, const Planner& planner) {
  InsertionOutcome outcome = Insertion(request, planner).run();
  const Meetings& meetings = request.standing.bounds.meetings;
  const bool complete = outcome.plan && outcome.dropped.empty();
  if (complete || meetings.of.empty() || meetings.reliance != Meetings::Reliance::kOnNothing)
    return outcome;
  InsertionRequest hopeful = request;
  hopeful.standing.bounds.meetings.reliance = Meetings::Reliance::kOnTheirBest;
  InsertionOutcome other = Insertion(hopeful, planner).run();
  const bool better =
      other.plan && (!outcome.plan || other.dropped.size() < outcome.dropped.size());
  return better || !outcome.plan ? other : outcome;
}

InsertionOutcome insert_tasks(const InsertionRequest& request) {
  return insert_tasks(request, real_planner());
}

}  // namespace skein::supervisor
