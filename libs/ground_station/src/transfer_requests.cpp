// SPDX-License-Identifier: Apache-2.0
// Conditions are reduced by what is known; those that name later tasks are sent afterwards.
#include "transfer_requests.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace skein::ground_station {
namespace {

using executive::Clause;
using executive::Formula;
using executive::Literal;
using executive::Modality;
using executive::TaskId;
using executive::TaskInState;
using executive::TaskState;
using mission::HeldTask;

// Holds back a task until its own preconditions are sent: nobody sends this message.
constexpr const char* kNoMessage = "conditions follow";

// Holds from the beginning: what is already satisfied for ever.
const Formula kAlways = {
    {Literal{executive::TimeIs{MissionTime(), true}, false, Modality::kMandatory}}};

constexpr std::array kAhead = {TaskState::kScheduled, TaskState::kStarted, TaskState::kRunning,
                               TaskState::kAborting,  TaskState::kEnded,   TaskState::kAborted};

// The states that a task in `from`, not terminal, may yet enter.
std::vector<TaskState> states_after(TaskState from) {
  const auto here = std::find(kAhead.begin(), kAhead.end(), from);
  return {here + 1, kAhead.end()};
}

bool contains(const std::vector<TaskState>& states, TaskState state) {
  return std::find(states.begin(), states.end(), state) != states.end();
}

enum class Fate { kHolds, kNever, kOpen };  // of a condition, from now on and for ever

struct Reduced {
  Formula formula;
  bool satisfied = false;  ///< for ever; the formula is empty then
};

class Reduction {
 public:
  /// `of_unknown`: the fate of conditions on tasks that neither move nor are among the facts.
  Reduction(const std::vector<HeldTask>& tasks, const TransferFacts& facts, Fate of_unknown)
      : facts_(facts), of_unknown_(of_unknown) {
    for (const HeldTask& task : tasks) moving_[task.task.id] = task.state;
  }

  Reduced reduce(const Formula& formula) const {
    Reduced out;
    for (const Clause& clause : formula) {
      if (auto rest = reduce(clause)) out.formula.push_back(std::move(*rest));
    }
    out.satisfied = !formula.empty() && out.formula.empty();
    return out;
  }

 private:
  // Nothing: it holds for ever.
  std::optional<Clause> reduce(const Clause& clause) const {
    Clause rest;
    for (const Literal& literal : clause) {
      const Fate fate = fate_of(literal);
      if (fate == Fate::kHolds) return std::nullopt;
      if (fate == Fate::kOpen) keep(literal, rest);
    }
    return rest;
  }

  Fate fate_of(const Literal& literal) const {
    const Fate condition =
        std::visit([this](const auto& it) { return fate_of(it); }, literal.condition);
    if (condition == Fate::kOpen) return Fate::kOpen;
    const bool holds = (condition == Fate::kHolds) != literal.negated;
    return holds || literal.modality == Modality::kOptional ? Fate::kHolds : Fate::kNever;
  }

  Fate fate_of(const TaskInState& condition) const {
    const auto moving = moving_.find(condition.task);
    const std::optional<TaskState> state =
        moving != moving_.end() ? std::optional(moving->second) : facts_.state_of(condition.task);
    if (!state) return of_unknown_;
    if (*state == condition.state) {
      return executive::is_terminal(*state) ? Fate::kHolds : Fate::kOpen;
    }
    if (executive::is_terminal(*state)) return Fate::kNever;
    return contains(states_after(*state), condition.state) ? Fate::kOpen : Fate::kNever;
  }
  Fate fate_of(const executive::MessageReceived& condition) const {
    return facts_.messages.contains(condition.message) ? Fate::kHolds : Fate::kOpen;
  }
  Fate fate_of(const executive::TimeIs&) const { return Fate::kOpen; }

  // "Not in the state in which it is now": in any that comes after it. The new executive would see
  // it begin again, and so take it for true too early.
  void keep(const Literal& literal, Clause& rest) const {
    const auto* task = std::get_if<TaskInState>(&literal.condition);
    const auto moving = task != nullptr ? moving_.find(task->task) : moving_.end();
    const bool is_left_later = literal.negated && moving != moving_.end() &&
                               moving->second == task->state &&
                               task->state != TaskState::kScheduled;
    if (!is_left_later) return rest.push_back(literal);
    for (const TaskState state : states_after(task->state)) {
      rest.push_back(Literal{TaskInState{task->task, state}, false, Modality::kMandatory});
    }
  }

  const TransferFacts& facts_;
  Fate of_unknown_;
  std::map<TaskId, TaskState> moving_;
};

bool names_one_of(const Formula& formula, const std::set<TaskId>& tasks) {
  for (const Clause& clause : formula) {
    for (const Literal& literal : clause) {
      const auto* named = std::get_if<TaskInState>(&literal.condition);
      if (named != nullptr && tasks.contains(named->task)) return true;
    }
  }
  return false;
}

// The START of a task, and the UPDATE-COND that has to follow it once all are started.
struct Entry {
  executive::Start start;
  std::optional<executive::UpdateConditions> update;
  bool abort = false;
};

// `later`: tasks that are started after it, and itself.
Entry entry_of(const HeldTask& held, const Reduction& reduction, const std::set<TaskId>& later) {
  Entry entry;
  executive::Task& task = entry.start.task;
  task = held.task;
  const bool is_active = executive::is_active(held.state);
  const Formula preconditions =
      is_active ? Formula() : reduction.reduce(held.task.preconditions).formula;
  const Reduced exit = reduction.reduce(held.task.exit);
  executive::UpdateConditions update{task.id, std::nullopt, std::nullopt};
  task.preconditions = preconditions;
  if (names_one_of(preconditions, later)) {
    update.preconditions = preconditions;
    task.preconditions = {
        {Literal{executive::MessageReceived{kNoMessage}, false, Modality::kMandatory}}};
  }
  task.exit = exit.formula;
  if (names_one_of(exit.formula, later)) {
    update.exit = exit.formula;
    task.exit.clear();
  }
  if (exit.satisfied && !is_active) task.exit = kAlways;
  entry.abort = held.state == TaskState::kAborting || (exit.satisfied && is_active);
  if (update.preconditions || update.exit) entry.update = std::move(update);
  return entry;
}

}  // namespace

std::vector<Request> requests_to_start(std::vector<HeldTask> tasks, const TransferFacts& facts,
                                       FirstGiven first) {
  const auto comes_later = [first](const HeldTask& one) {
    return (one.state == TaskState::kScheduled) == (first == FirstGiven::kUnderWay);
  };
  std::sort(tasks.begin(), tasks.end(), [&](const HeldTask& a, const HeldTask& b) {
    return std::pair(comes_later(a), a.task.id) < std::pair(comes_later(b), b.task.id);
  });
  const Reduction reduction(tasks, facts, Fate::kNever);
  std::set<TaskId> later;
  for (const HeldTask& task : tasks) later.insert(task.task.id);
  std::vector<Request> starts, updates, aborts;
  for (const HeldTask& task : tasks) {
    Entry entry = entry_of(task, reduction, later);
    later.erase(task.task.id);
    starts.emplace_back(std::move(entry.start));
    if (entry.update) updates.emplace_back(std::move(*entry.update));
    if (entry.abort) aborts.emplace_back(executive::Abort{task.task.id});
  }
  starts.insert(starts.end(), updates.begin(), updates.end());
  starts.insert(starts.end(), aborts.begin(), aborts.end());
  return starts;
}

Request without_settled(const Request& request,
                        const std::function<std::optional<TaskState>(TaskId)>& over) {
  const TransferFacts facts{over, {}};
  const Reduction reduction({}, facts, Fate::kOpen);
  const auto exit_of = [&](const Formula& formula) {
    Reduced exit = reduction.reduce(formula);
    return exit.satisfied ? kAlways : std::move(exit.formula);
  };
  Request out = request;
  if (auto* start = std::get_if<executive::Start>(&out)) {
    start->task.preconditions = reduction.reduce(start->task.preconditions).formula;
    start->task.exit = exit_of(start->task.exit);
  } else if (auto* update = std::get_if<executive::UpdateConditions>(&out)) {
    if (update->preconditions) {
      update->preconditions = reduction.reduce(*update->preconditions).formula;
    }
    if (update->exit) update->exit = exit_of(*update->exit);
  }
  return out;
}

}  // namespace skein::ground_station
