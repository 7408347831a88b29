// SPDX-License-Identifier: Apache-2.0
// Safe waits: in the air the UAV has a task, or it is reported that it has none.
#pragma once

#include <optional>
#include <string>

#include "commitment/committer.hpp"
#include "jobs/agenda.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Starts a safe wait when the UAV has nothing to do. Lifetime: refers to its arguments.
class SafeMode {
 public:
  SafeMode(Duration horizon, const Beliefs& beliefs, const Agenda& agenda, Committer& committer,
           Outbox& out, const Book& book);

  /// Starts a safe wait unless a task is under way or begins soon. The wait ends when a task that
  /// the executive has may begin.
  void keep();
  /// A safe wait was refused or aborted: no new one is started before `at`.
  void pause_until(MissionTime at) { again_ = at; }
  void hurry() { again_.reset(); }
  bool pauses() const { return again_ && out_.now() < *again_; }
  std::optional<MissionTime> paused_until() const { return again_; }
  /// When to report a task of others that the plan waits for.
  std::optional<MissionTime> tells_at() const;
  /// The UAV begins to decide for itself: what keeps it from its tasks is reported, also again.
  void begin();

 private:
  MissionTime now() const { return out_.now(); }
  void forget_told() { told_ = false; }
  void tell(const std::string& what);
  void tell_what_is_in_the_way();
  std::string why_idle() const;
  std::optional<std::string> what_is_decided() const;
  std::string begins_from(GoalId id) const;

  Duration horizon_;
  const Beliefs& beliefs_;
  const Agenda& agenda_;
  Committer& committer_;
  Outbox& out_;
  const Book& book_;
  bool told_ = false;                 ///< that the UAV flies without a task
  std::optional<TaskId> in_the_way_;  ///< a task of others that the plan waits for
  MissionTime in_the_way_since_;
  bool told_in_the_way_ = false;
  std::optional<MissionTime> again_;  ///< no safe wait before then
};

}  // namespace skein::supervisor
