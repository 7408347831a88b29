// SPDX-License-Identifier: Apache-2.0
#include "requests/hand_over.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "skein/supervisor/commitment.hpp"

namespace skein::supervisor {

namespace {

/// What another executive had is back by then, or never.
constexpr Duration kComesBack = Duration::milliseconds(5'000);
constexpr const char* kStayedAway = "the executive that had it did not give it back in time";

}  // namespace

void HandOver::hand_over_goal(GoalId id) {
  Goal& goal = book_.goals.at(id);
  if (is_settled(goal.state)) return;
  goal.queued = false;
  if (!book_.is_wholly_given(id) || book_.has_lost(id))
    out_.set_state(goal, GoalState::kHandedOver);
}

void HandOver::give_up(const Disengage& input) {
  engaged_ = false;
  returning_.reset();
  awaited_until_.reset();
  book_.elsewhere.clear();
  for (const Evaluation& one : agenda_.clear()) {
    out_.add(MissionDecided{{one.mission.id, false, {input.cause}, true}});
  }
  safe_mode_.hurry();
  if (!book_.nothing_in_hand())
    committer_.stop_safe_waits();  // what the executive has waits for their end
  HandedOver held;
  const std::set<TaskId> by_order = book_.ending_by_order();
  std::vector<GoalId> goals;
  for (const GoalId id : book_.order) {
    hand_over_goal(id);
    if (book_.goals.at(id).state == GoalState::kHandedOver) goals.push_back(id);
  }
  for (const auto& [id, entry] : book_.tasks) {
    const bool open = book_.goals.at(entry.task.origin).state == GoalState::kHandedOver;
    if (!open || entry.given() || !entry.live()) continue;
    executive::Task task = to_start(entry.task, entry.window, by_order).task;
    held.tasks.push_back({std::move(task), TaskState::kScheduled, false, entry.task.origin});
  }
  out_.decide({"0 user request", input.cause, list_of("goals", goals),
               "handed over: " + std::to_string(held.tasks.size()) + " tasks", now()});
  out_.add(std::move(held));
}

// A goal of which the executive was given tasks meanwhile, and lost none, stays with it; what it
// was not given is no longer part of it. The others have no plan.
std::vector<GoalId> HandOver::take_back(const std::set<GoalId>& goals) {
  std::set<GoalId> anew;
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    if (goals.count(id) == 0) continue;
    Goal& goal = book_.goals.at(id);
    const bool partly = book_.is_given(id) && (!book_.is_wholly_given(id) || book_.has_lost(id));
    if (is_settled(goal.state) || (goal.state != GoalState::kHandedOver && !partly)) continue;
    if (book_.has_in_hand(id) && !book_.has_lost(id)) {
      for (const Entry* entry : book_.of(id)) {
        if (!entry->given()) book_.tasks.at(entry->task.id).advance(Step::kWithdraw);
      }
      const auto tasks = book_.of(id);
      const bool begun = std::any_of(tasks.begin(), tasks.end(), [](const Entry* one) {
        return one->seen.started.has_value();
      });
      out_.set_state(goal, begun ? GoalState::kUnderWay : GoalState::kPlanned);
      continue;
    }
    anew.insert(id);
    result.push_back(id);
    out_.set_state(goal, GoalState::kReceived);
  }
  committer_.retire(anew);
  return result;
}

void HandOver::lose(Entry& entry) {
  entry.unseen = true;
  entry.over_elsewhere = true;
  entry.abort(now());
}

void HandOver::stays_away(Entry& entry) {
  lose(entry);
  out_.add(NotGivenBack{{entry.task.id, entry.task.type, TaskState::kAborted, kStayedAway}});
}

// What the executive has lost to somebody else.
void HandOver::forget_but(const std::set<TaskId>& kept) {
  for (auto& [id, entry] : book_.tasks) {
    if (entry.given() && !entry.over() && kept.count(id) == 0) lose(entry);
  }
  for (auto it = book_.loose.begin(); it != book_.loose.end();) {
    const bool there = kept.count(it->first) != 0;
    if (!there) book_.forgotten.set(it->first.value(), it->second.ours ? kOursElsewhere : 1);
    it = there ? std::next(it) : book_.loose.erase(it);
  }
}

// Of what waits at the other executive nothing is seen here: it may have been aborted there.
void HandOver::await_return(const Engage& input) {
  Return all{{}, {}, {}, input.cause, input.resume, now() + kComesBack};
  for (const TaskId id : book_.in_hand()) {
    const GoalId goal = book_.tasks.at(id).task.origin;
    if (is_settled(book_.goals.at(goal).state)) continue;
    all.missing.insert(id);
    if (book_.has_lost(goal)) all.goals.insert(goal);
  }
  for (const TaskId id : input.elsewhere)
    if (all.missing.count(id) != 0 && !book_.tasks.at(id).task.open_ended)
      all.carried_out.insert(id);
  book_.elsewhere.insert(all.missing.begin(), all.missing.end());
  if (!all.missing.empty()) returning_ = std::move(all);
}

std::set<GoalId> HandOver::not_awaited() const {
  std::set<GoalId> result(book_.order.begin(), book_.order.end());
  if (returning_)
    for (const GoalId id : returning_->goals) result.erase(id);
  return result;
}

// Those that lead the vehicle away are waited for to their end: where it is then is not known.
void HandOver::await(const std::vector<TaskId>& elsewhere) {
  for (const TaskId id : elsewhere) {
    const auto loose = book_.loose.find(id);
    if (loose == book_.loose.end() || loose->second.leads_away) continue;
    book_.elsewhere.insert(id);
    awaited_until_ = now() + kComesBack;
  }
}

void HandOver::await_no_longer() {
  awaited_until_.reset();
  std::erase_if(book_.elsewhere, [&](TaskId id) { return book_.loose.erase(id) > 0; });
}

void HandOver::came_back(TaskId task) {
  if (returning_ && returning_->missing.erase(task) > 0) plan_returned();
}

void HandOver::time_passes() {
  if (awaited_until_ && now() >= *awaited_until_) await_no_longer();
  if (returning_ && returning_->until && now() >= *returning_->until) lose_what_stays_away();
}

// What the vehicle carries out is seen to its end.
void HandOver::lose_what_stays_away() {
  returning_->until.reset();
  std::erase_if(returning_->missing, [&](TaskId id) {
    if (returning_->carried_out.count(id) != 0) return false;
    Entry& entry = book_.tasks.at(id);
    returning_->goals.insert(entry.task.origin);
    book_.elsewhere.erase(id);
    if (!entry.over()) stays_away(entry);
    return true;
  });
  plan_returned();
}

std::optional<MissionTime> HandOver::next_wakeup() const {
  return earliest(returning_ ? returning_->until : std::nullopt, awaited_until_);
}

// Of those that lost a task, the ones of which nothing is missing any more.
std::set<GoalId> HandOver::returned() {
  std::set<GoalId> result = std::exchange(returning_->goals, {});
  for (const TaskId id : returning_->missing) {
    const GoalId goal = book_.tasks.at(id).task.origin;
    if (result.erase(goal) > 0) returning_->goals.insert(goal);
  }
  return result;
}

void HandOver::plan_returned() {
  const std::set<GoalId> back = returned();
  const std::string cause = returning_->cause;
  const bool resume = returning_->resume;
  if (returning_->missing.empty()) returning_.reset();
  if (!resume)
    for (const GoalId id : back) hand_over_goal(id);
  const std::vector<GoalId> goals = resume ? take_back(back) : std::vector<GoalId>();
  committer_.reschedule();
  if (!goals.empty()) agenda_.plan_anew(std::nullopt, false, cause);
}

void HandOver::take(const Engage& input) {
  const bool was_engaged = std::exchange(engaged_, true);
  safe_mode_.begin();
  if (input.in_executive) forget_but({input.in_executive->begin(), input.in_executive->end()});
  if (!input.resume && !was_engaged) {
    for (const GoalId id : book_.order) hand_over_goal(id);
  }
  await(input.elsewhere);
  if (!input.in_executive) await_return(input);
  const std::vector<GoalId> goals = input.resume ? take_back(not_awaited()) : std::vector<GoalId>();
  out_.decide({"0 user request", input.cause, list_of("goals", goals), "engaged", now()});
  committer_.reschedule();
  if (!goals.empty()) agenda_.plan_anew(std::nullopt, false, input.cause);
}

}  // namespace skein::supervisor
