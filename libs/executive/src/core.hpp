// SPDX-License-Identifier: Apache-2.0
// Implementation of the executive: the event loop over plan, conditions, resources and timers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "background.hpp"
#include "conditions.hpp"
#include "outbox.hpp"
#include "plan.hpp"
#include "resource_use.hpp"
#include "skein/executive/executive.hpp"
#include "synchroniser.hpp"
#include "timers.hpp"
#include "urgents.hpp"

namespace skein::executive {

class Executive::Core {
 public:
  explicit Core(Config config);

  Effects handle(const Input& input, MissionTime now);
  Effects give_up(TaskId synchronisation, const std::string& why, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  const Plan& plan() const { return plan_; }
  const Conditions& conditions() const { return conditions_; }
  std::vector<Wait> waits() const { return synchroniser_.waits(now_); }

 private:
  using Slot = Plan::Slot;

  // core.cpp: time, the loop of spec 2.4, and inputs that are not requests
  void advance();
  void pass_timer(const Timer& timer);
  void settle();
  Effects done();
  bool step();
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
  Slot enter(const Task& task);
  void make_urgent(Slot slot);

  // transitions.cpp
  void set_state(Slot slot, TaskState state, const std::string& reason = {});
  void make_way_for(const TaskRecord& task);
  void dispatch(Slot slot);
  void run_synchronisation(Slot slot);
  void say(const Synchronisation& synchronisation, SyncWord word);
  void say_again_later(Slot slot);
  void retire_synchronisation(const TaskRecord& record);
  void interrupt_or_cancel(Slot slot, const std::string& reason);
  void interrupt(Slot slot, const std::string& reason);
  void retire(Slot slot, bool was_aborting);
  void let_go(Slot slot);
  void expect_answer(TaskRecord& record);

  // background.cpp
  bool dispatch_background();
  void end_background(const std::string& reason);
  void retire_background(Slot slot, bool displaced);

  Config config_;
  MissionTime now_ = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());
  Outbox outbox_;
  Plan plan_;
  Conditions conditions_;
  ResourceUse resources_;
  Timers timers_;
  Synchroniser synchroniser_;
  Urgents urgents_;
  Background background_;

  std::uint32_t motion_;  ///< number of the resource kMotion
};

}  // namespace skein::executive
