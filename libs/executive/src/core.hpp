// SPDX-License-Identifier: Apache-2.0
// The executive's insides: the event loop over plan, conditions, resources, timers.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "conditions.hpp"
#include "plan.hpp"
#include "resource_use.hpp"
#include "skein/executive/executive.hpp"
#include "synchroniser.hpp"
#include "timers.hpp"

namespace skein::executive {

class Executive::Core {
 public:
  explicit Core(Config config);

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  const Plan& plan() const { return plan_; }
  const Conditions& conditions() const { return conditions_; }

 private:
  using Slot = Plan::Slot;

  // core.cpp: time, the loop of spec 2.4, and inputs that are not requests
  void advance();
  void pass_timer(const Timer& timer);
  bool counts(const Timer& timer) const;
  void settle();
  bool step();
  std::optional<Slot> take_urgent();
  void on(const FunctionalStatus& status);
  void on(const SyncReceived& message);
  void on(const PeerReachable& peer);
  void on(const Flight& flight);
  void on(const Relinquish& request);
  void on(const Tick&) {}

  // requests.cpp
  void on(const Start& request);
  void on(const Abort& request);
  void on(const ProcessMessage& request);
  void on(const UpdateConditions& request);
  void on(const Suppress& request);
  std::optional<std::string> refusal_of(const Start& request) const;
  Formula preconditions_of(const Start& request) const;
  Slot enter(const Task& task);
  void make_urgent(Slot slot);
  std::optional<std::string> refusal_of(const UpdateConditions& request) const;
  void reply(RequestKind kind, std::optional<TaskId> id, const std::optional<std::string>& refusal);

  // transitions.cpp
  void set_state(Slot slot, TaskState state, const std::string& reason = {});
  void announce(const TaskRecord& record);
  void note_flight(functional::Leaves leaves);
  void dispatch(Slot slot);
  void run_synchronisation(Slot slot);
  void interrupt_or_cancel(Slot slot, const std::string& reason);
  void interrupt(Slot slot, const std::string& reason);
  void retire(Slot slot, bool was_aborting);
  void free_urgents(TaskId blocker);
  void let_go(Slot slot);
  std::string reason_of_exit(const TaskRecord& record) const;
  bool answers_functionally(const TaskRecord& record) const;
  void expect_answer(TaskRecord& record);
  void notice(std::string text) { effects_.push_back(Notice{std::move(text)}); }

  // background.cpp
  bool uses_motion(const TaskRecord& record) const;
  bool wants_background() const;
  void dispatch_background();
  void displace_background(TaskId by);
  void end_background(const std::string& reason);
  void retire_background(bool displaced);

  Config config_;
  MissionTime now_ = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());
  Effects effects_;
  Plan plan_;
  Conditions conditions_;
  ResourceUse resources_;
  Timers timers_;
  Synchroniser synchroniser_;
  ReadyQueue urgent_ready_;
  std::unordered_map<TaskId, std::vector<TaskId>> waiting_for_;  ///< blocker → urgent tasks
  std::set<TaskId> urgent_motion_;  ///< urgent tasks that use motion, not yet dispatched
  std::uint32_t joint_active_ = 0;

  std::uint32_t motion_;  ///< number of the resource
  bool airborne_ = false;
  bool resting_ = false;              ///< no background routine until the next START
  std::optional<TaskId> background_;  ///< under way
  std::optional<MissionTime> background_retry_;
  std::uint64_t background_count_ = 0;
};

}  // namespace skein::executive
