// SPDX-License-Identifier: Apache-2.0
// Facts and the formulas that depend on them: who becomes ready when a fact changes.
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

/// Tasks by id, the lowest first; whether one is still ready is checked when it is taken.
class ReadyQueue {
 public:
  void push(TaskId id, Plan::Slot slot) { queue_.emplace(id, slot); }
  /// The first entry whose task is in its slot still and passes `is_ready`; drops those before it.
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

  /// Why these conditions may not be given to task `self`, or nothing. Absent ones are not looked
  /// at. Source: spec 2.3 (coherence).
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
  /// Instants pass one by one: the earliest watched one, if any.
  std::optional<MissionTime> next_instant() const;
  void instant_passed(MissionTime instant);
  /// Nothing watched lies at or before `now` any more.
  void now_is(MissionTime now) { now_ = now; }
  /// Forgets instants that no formula watches any more, so that next_instant() tells the truth.
  void trim_instants();

  /// The next task to interrupt (Ξ) or to dispatch or abort (Π), taken out of its queue.
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
