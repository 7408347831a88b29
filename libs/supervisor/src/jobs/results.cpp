// SPDX-License-Identifier: Apache-2.0
#include "jobs/results.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "book/progress.hpp"
#include "flight/landing_place.hpp"
#include "flight/retreat.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

namespace {

// "; weighed: last 512.3 s, tour 480 s, in-time not possible (…)": when there was a choice.
std::string weighed(const InsertionOutcome& outcome) {
  if (outcome.trials.size() < 2) return {};
  std::string text;
  for (const Trial& trial : outcome.trials) {
    text += (text.empty() ? "; weighed: " : ", ") + std::string(mission::to_text(trial.placement));
    if (trial.part > 0) text += " in parts from " + percent(trial.part) + " on";
    if (trial.feasible) {
      text += " " + to_text(Duration::seconds(std::round(10 * trial.cost) / 10)) + " s";
      if (trial.shortened > Duration())
        text += " and " + in_seconds(trial.shortened) + " less of what is asked";
    } else {
      text += " not possible (" + joined(trial.reasons) + ")";
    }
  }
  return text;
}

std::string mended(const std::vector<Shortened>& shortened) {
  return shortened.empty() ? "" : "; mended by slack: " + to_text(shortened);
}

// Bounds with which there would have been a plan; empty: none help.
std::string proposed(const std::vector<Relaxation>& relaxations) {
  std::string text;
  for (const Relaxation& one : relaxations)
    text += (text.empty() ? "it could be planned with " : " and ") + to_text(one);
  return text;
}

// "; goal 701 in parts: 50 % of its lanes before goals 710": of the part that is not known yet.
std::string parted(const std::vector<mission::HighLevelTask>& order, const Book& book) {
  const auto part = std::find_if(order.begin(), order.end(), [&](const auto& goal) {
    return whole_of(goal) && !book.knows(goal.id);
  });
  if (part == order.end()) return {};
  std::vector<GoalId> between;
  for (auto goal = part + 1; goal != order.end() && goal->id != *whole_of(*part); ++goal)
    between.push_back(goal->id);
  return list_of("; goal " + to_text(*whole_of(*part)) + " in parts: " + percent(*share_of(*part)) +
                     " of its lanes before goals",
                 between);
}

constexpr double kElsewhere = 5;  // [m] from home

std::string at_text(const world::Vector3& at) {
  return "(" + std::to_string(std::lround(at.x())) + ", " + std::to_string(std::lround(at.y())) +
         ")";
}

std::string tenths(double number) {
  const long all = std::lround(10 * number);
  const long part = std::abs(all % 10);
  return std::to_string(all / 10) + (part == 0 ? "" : "." + std::to_string(part));
}

}  // namespace

Results::Results(const Rooms& rooms)
    : beliefs_(rooms.beliefs),
      own_goals_(rooms.own_goals),
      true_goals_(rooms.true_goals),
      dates_(rooms.dates),
      committer_(rooms.committer),
      agenda_(rooms.agenda),
      out_(rooms.out),
      book_(rooms.book) {}

// What no plan may have: tasks of goals that were not asked for, ids that were used.
std::string Results::fault_of(const Premises& premises, const mission::ElementaryPlan& plan) {
  std::set<GoalId> asked(premises.goals.begin(), premises.goals.end());
  asked.insert(premises.added.begin(), premises.added.end());
  std::set<TaskId> ids;
  for (const mission::ElementaryTask& task : plan.tasks) {
    const std::string name = "task " + to_text(task.id);
    if (asked.count(task.origin) == 0) return name + " is of no goal that was asked for";
    if (task.id < premises.next_id) return name + " has an id that was used before";
    if (!ids.insert(task.id).second) return name + " is there twice";
  }
  return {};
}

bool Results::fits_now(const Premises& premises, const mission::ElementaryPlan& plan) {
  if (dates_.fits(plan, premises.withdrawn, now())) return true;
  committer_.reschedule();
  return false;
}

// What is due is given before what it takes the place of is told to stop.
void Results::adopt(const Premises& premises, const mission::ElementaryPlan& plan,
                    const std::vector<mission::HighLevelTask>& order) {
  const std::set<GoalId> anew(premises.goals.begin(), premises.goals.end());
  const std::vector<TaskId> stopped = book_.withdraw(anew);
  book_.enter(plan);
  book_.note_parts();
  std::vector<GoalId> wanted;
  for (const mission::HighLevelTask& task : order) {
    if (book_.goals.count(task.id) == 0) continue;
    wanted.push_back(task.id);
    Goal& goal = book_.goals.at(task.id);
    goal.queued = false;
    if (goal.state == GoalState::kReceived) out_.set_state(goal, GoalState::kPlanned);
  }
  tell_landing(plan);
  book_.reorder(wanted);
  true_goals_.foresee();
  committer_.reschedule();
  dates_.promise();
  committer_.commit();
  committer_.stop(stopped);
}

void Results::tell_refined(const Job& job, const mission::ElementaryPlan& plan) {
  std::vector<GoalId> goals = job.premises.goals;
  goals.insert(goals.end(), job.premises.added.begin(), job.premises.added.end());
  out_.decide({"3 refine", job.mission ? "mission " + to_text(*job.mission) : job.need.cause,
               list_of("goals", goals), std::to_string(plan.tasks.size()) + " tasks", now()});
}

// Somewhere else than at home, and why.
void Results::tell_landing(const mission::ElementaryPlan& plan) {
  const world::Vector3& home = beliefs_.knowledge().home;
  for (const mission::ElementaryTask& task : plan.tasks) {
    if (task.type != "land" || task.way.empty()) continue;
    const world::Vector3& at = task.way.back();
    if ((at - home).head<2>().norm() <= kElsewhere) continue;
    const auto why = landing_problem(beliefs_.knowledge(), beliefs_.world(), {now()}, home);
    out_.notice(book_.named(task.origin) + " lands at " + at_text(at) + ", not at home: " +
                why.value_or("there is no way home, or the energy does not last so far"));
  }
}

// ---- operator 1 ----

// What the plan would be is compared with what it is; nothing of it is kept.
mission::MissionEstimate Results::estimate(const Evaluation& evaluation,
                                           const InsertionOutcome& outcome) const {
  mission::MissionEstimate result;
  result.placement = outcome.chosen;
  result.cost = outcome.plan->cost;
  result.energy = outcome.plan->energy;
  for (const auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry) || entry.given()) continue;
    result.cost -= entry.task.cost;
    result.energy -= entry.task.energy;
  }
  std::set<GoalId> asked;
  for (const mission::HighLevelTask& task : evaluation.mission.tasks) asked.insert(task.id);
  for (const mission::ElementaryTask& task : outcome.plan->tasks) {
    const auto dates = outcome.schedule.foreseen.find(task.id);
    if (asked.count(task.origin) == 0 || dates == outcome.schedule.foreseen.end()) continue;
    result.earliest_end = std::max(result.earliest_end, dates->second.earliest_end);
    result.latest_end = std::max(result.latest_end, dates->second.latest_end);
  }
  result.plan_end = outcome.schedule.latest_end;
  return result;
}

// What cannot be placed otherwise may have its place between two parts of what is under way.
bool Results::is_tried_in_parts(const Job& job, const InsertionOutcome& outcome,
                                mission::Placement placement) {
  const bool any_place =
      placement == mission::Placement::kBest || placement == mission::Placement::kInTime;
  return !outcome.plan && any_place && !interrupted_between_parts(book_).empty() &&
         agenda_.try_in_parts(job);
}

// "; interrupted, since nothing else was possible, and taken up again: goals 702".
std::string Results::parts_of(const Premises& premises) const {
  std::set<GoalId> goals;
  for (const TaskId id : premises.withdrawn) {
    const Entry& entry = book_.tasks.at(id);
    if (flown_along(book_, entry) != nullptr) goals.insert(entry.task.origin);
  }
  return goals.empty()
             ? ""
             : list_of("; interrupted, since nothing else was possible, and taken up again: goals",
                       goals);
}

void Results::answer_evaluation(const Job& job, const InsertionOutcome& outcome) {
  if (is_tried_in_parts(job, outcome, agenda_.evaluations().front().mission.placement)) return;
  const Evaluation evaluation = agenda_.take_evaluation();
  mission::MissionOutcome answer{evaluation.mission.id, outcome.plan.has_value(), outcome.reasons,
                                 true, std::nullopt};
  if (outcome.plan) answer.estimate = estimate(evaluation, outcome);
  std::vector<GoalId> goals;
  for (const mission::HighLevelTask& task : evaluation.mission.tasks) goals.push_back(task.id);
  const std::string proposal = proposed(outcome.relaxations);
  if (!proposal.empty()) answer.reasons.push_back(proposal);
  std::string text = "cannot be taken: " + joined(answer.reasons);
  if (answer.estimate) {
    text = "could be taken, " + std::string(to_text(outcome.chosen)) + ": cost " +
           tenths(answer.estimate->cost) + ", energy " + tenths(100 * answer.estimate->energy) +
           " %, ends from " + to_text(answer.estimate->earliest_end) + " s on" +
           mended(outcome.shortened);
  }
  out_.add(MissionDecided{std::move(answer)});
  out_.decide({"1 evaluate", evaluation.cause, list_of("goals", goals), text, evaluation.since});
}

// Of goals that were asked for: they are not part of the plan.
void Results::leave_out(const std::vector<Dropped>& dropped) {
  for (const Dropped& one : dropped) {
    const auto goal = book_.goals.find(one.goal);
    if (goal == book_.goals.end() || !goal->second.queued) continue;
    goal->second.queued = false;
    out_.set_state(goal->second, GoalState::kFailed, one.why);
  }
}

// The goals because of which there is no plan are told why, the others which those are.
void Results::refuse(const Job& job, const std::vector<std::string>& reasons,
                     const std::vector<Dropped>& culprits, const std::string& proposal) {
  const std::string why = reasons.empty() ? "no order is feasible" : joined(reasons);
  leave_out(culprits);
  std::string others;
  for (const Dropped& one : culprits) {
    others += (others.empty() ? "" : "; ") + ("goal " + to_text(one.goal)) + ": " + one.why;
  }
  for (const GoalId id : job.premises.added) {
    book_.goals.at(id).queued = false;
    out_.set_state(book_.goals.at(id), GoalState::kFailed,
                   others.empty() ? why : "all or nothing of the mission is planned; " + others);
  }
  MissionDecided decided{{*job.mission, false, {why}}};
  if (!reasons.empty()) decided.outcome.reasons = reasons;
  if (!others.empty()) decided.outcome.reasons = {others};
  if (!proposal.empty()) decided.outcome.reasons.push_back(proposal);
  for (std::string& reason : decided.outcome.reasons) reason = out_.in_words(reason);
  out_.add(std::move(decided));
  const Pending pending = agenda_.take(*job.mission);
  out_.decide({"1 insert", pending.cause, list_of("goals", job.premises.added),
               "refused: " + why + (proposal.empty() ? "" : "; " + proposal), pending.since});
}

// The UAV gives itself a part of a mapping.
void Results::enter_parts(const std::vector<mission::HighLevelTask>& order) {
  for (const mission::HighLevelTask& task : order)
    if (whole_of(task) && !book_.knows(task.id)) own_goals_.enter(task);
}

void Results::finish(const Job& job, const InsertionOutcome& outcome) {
  const Pending* pending = agenda_.find(*job.mission);
  if (is_tried_in_parts(job, outcome, pending->placement)) return;
  if (!outcome.plan)
    return refuse(job, outcome.reasons, outcome.dropped, proposed(outcome.relaxations));
  Premises premises = job.premises;
  for (const mission::HighLevelTask& task : outcome.order)
    if (whole_of(task) && !book_.knows(task.id)) premises.added.push_back(task.id);
  if (const std::string fault = fault_of(premises, *outcome.plan); !fault.empty()) {
    return refuse(job, {fault});
  }
  if (!fits_now(job.premises, *outcome.plan)) {
    if (!agenda_.again(job, "the plan no longer fits"))
      refuse(job, {"the plan no longer fits in time"});
    return;
  }
  const Pending mission = agenda_.take(*job.mission);
  const std::string parts =
      (mission.in_parts ? parts_of(job.premises) : "") + parted(outcome.order, book_);
  enter_parts(outcome.order);
  tell_refined(job, *outcome.plan);
  const std::size_t decision = out_.reserve_decision();  // adopting has decisions of its own
  adopt(job.premises, *outcome.plan, outcome.order);
  leave_out(outcome.dropped);
  std::string without;
  for (const Dropped& one : outcome.dropped) {
    without += "; left out goal " + to_text(one.goal) + ": " + one.why;
  }
  out_.add(MissionDecided{{mission.id, true, {}}});
  out_.decide(decision, {"1 insert: " + std::string(to_text(outcome.chosen)), mission.cause,
                         list_of("goals", job.premises.added),
                         out_.plan_text() + ", " + dates_.extent() + mended(outcome.shortened) +
                             parts + without + weighed(outcome),
                         mission.since});
}

// ---- operator 6 ----

void Results::fail_safely(const Job& job, const std::vector<std::string>& reasons) {
  const std::string why = job.need.cause + (reasons.empty() ? "" : "; " + joined(reasons));
  committer_.retire({job.premises.goals.begin(), job.premises.goals.end()});
  for (const GoalId id : job.premises.goals) {
    out_.set_state(book_.goals.at(id), GoalState::kFailed, why);
  }
  committer_.reschedule();
  out_.notice("the mission has failed, safe mode: " + why);
  out_.decide({"6 repair: fail", job.need.cause, list_of("goals", job.premises.goals),
               "safe mode: " + why, job.need.since});
}

void Results::finish(const Job& job, const RepairOutcome& outcome) {
  if (!outcome.plan) return fail_safely(job, outcome.before);
  Premises premises = job.premises;
  if (outcome.served == RepairStep::kReturn && job.retreat) {
    premises.added.push_back(own_goals_.enter(*job.retreat));
  }
  if (const std::string fault = fault_of(premises, *outcome.plan); !fault.empty()) {
    return fail_safely(job, {fault});
  }
  if (!fits_now(job.premises, *outcome.plan)) {
    if (agenda_.again(job, "the plan no longer fits")) return;
    agenda_.forget_need();
    return fail_safely(job, {"the plan no longer fits in time"});
  }
  std::set<GoalId> left(job.premises.goals.begin(), job.premises.goals.end());
  for (const auto& task : outcome.order) left.erase(task.id);
  tell_refined(job, *outcome.plan);
  const std::size_t decision = out_.reserve_decision();
  adopt(premises, *outcome.plan, outcome.order);
  for (const GoalId id : left) {
    const auto dropped = std::find_if(outcome.dropped.begin(), outcome.dropped.end(),
                                      [&](const Dropped& one) { return one.goal == id; });
    std::string why = dropped != outcome.dropped.end() ? dropped->why : "no plan has room";
    if (job.need.failed == id) why = job.need.cause + (job.need.refine ? "; " + why : "");
    out_.set_state(book_.goals.at(id), GoalState::kFailed, why);
  }
  const std::string without = left.empty() ? "" : list_of("; dropped", left);
  const std::string before = outcome.before.empty() ? "" : "; before: " + joined(outcome.before);
  out_.decide(decision, {"6 repair: " + std::string(to_text(outcome.served)), job.need.cause,
                         list_of("goals", job.premises.goals),
                         out_.plan_text() + ", " + dates_.extent() + mended(outcome.shortened) +
                             without + before,
                         job.need.since});
}

}  // namespace skein::supervisor
