// SPDX-License-Identifier: Apache-2.0
// Facts and the formulas that depend on them: finds the tasks that become ready at a change.
#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plan.hpp"
#include "truth.hpp"

namespace skein::executive {

/// A queue of tasks, the lowest id first; take() checks whether a task is still ready.
class ReadyQueue {
 public:
  void push(TaskId id, Plan::Slot slot) { queue_.emplace(id, slot); }
  /// The first entry whose task is still in its slot and satisfies `is_ready`; drops the entries
  /// before it.
  template <class IsReady>
  std::optional<Plan::Slot> take(const Plan& plan, const IsReady& is_ready) {
    while (!queue_.empty()) {
      const auto [id, slot] = queue_.top();
      queue_.pop();
      if (plan[slot].id == id && is_ready(plan[slot])) return slot;
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<TaskId, Plan::Slot>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// The fact base with its watches. When a fact changes, only the literals that name it are
/// evaluated again; tasks whose Ξ became satisfied, or whose Π became satisfied or false for ever,
/// are queued. Source: T III.2.2, spec 2.4.
class Conditions {
 public:
  explicit Conditions(Plan& plan) : plan_(plan) {}

  /// Why these conditions are incoherent for the task `self`; nothing if they are coherent. Null
  /// formulas are not checked. Source: spec 2.3 (coherence).
  std::optional<std::string> incoherence(TaskId self, const Formula* preconditions,
                                         const Formula* exit,
                                         std::optional<MissionTime> deadline) const;

  /// Compiles and watches a formula; a deadline is added to Ξ as an alternative to each clause.
  void attach(Plan::Slot slot, Role role, const Formula& formula,
              std::optional<MissionTime> deadline);
  void detach(Plan::Slot slot, Role role) { plan_[slot].formula(role).clear(); }
  /// The formula as it was given.
  Formula formula_of(Plan::Slot slot, Role role) const;

  void task_changed(Plan::Slot slot);
  void message_received(const std::string& message);
  /// The earliest watched instant, if any. Instants pass one by one.
  std::optional<MissionTime> next_instant() const;
  void instant_passed(MissionTime instant);
  /// Sets the present. Precondition: no watched instant is at or before `now`.
  void now_is(MissionTime now) { now_ = now; }
  /// Forgets leading instants that no formula watches any more, so that next_instant() is right.
  void trim_instants();

  /// Removes from its queue and returns the next task whose Ξ is satisfied (to interrupt), or whose
  /// Π is satisfied or false for ever (to dispatch or abort).
  std::optional<Plan::Slot> take_exit();
  std::optional<Plan::Slot> take_precondition();

 private:
  struct Message {
    std::string text;
    bool received = false;
    WatchList watchers;
  };

  Truth evaluate(const Literal& literal) const;
  Truth evaluate(const Formula& formula) const;
  std::optional<TaskId> unknown_task(TaskId self, const Formula& formula) const;
  CompiledLiteral compile(const Literal& literal, std::uint32_t clause);
  Standing standing_of(const CompiledLiteral& literal) const;
  void watch(const CompiledLiteral& literal, Watch watch);
  void sweep_instants();
  std::uint32_t message_index(const std::string& text);

  bool is_live(const Watch& watch) const {
    return plan_[watch.slot].formula(watch.role()).version() == watch.version;
  }
  void queue_if_ready(Plan::Slot slot, Role role);
  template <class NewStanding>
  void visit(WatchList& list, const NewStanding& standing);

  Plan& plan_;
  std::unordered_map<std::string, std::uint32_t> message_indices_;
  std::deque<Message> messages_;
  std::map<MissionTime, WatchList> instants_;
  std::size_t instant_watches_ = 0, sweep_at_ = 64;
  MissionTime now_ = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());
  ReadyQueue exits_, preconditions_;
};

}  // namespace skein::executive
