// SPDX-License-Identifier: Apache-2.0
// The executive as a component.
#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "component.hpp"
#include "skein/executive/executive.hpp"
#include "wait_starts.hpp"

namespace skein::decision_node {

class Core;

class Execution final : public Component {
 public:
  explicit Execution(Core& core);

  void take(const Command& command) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void peer_in_reach(const std::string& peer) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

  /// Queues an input for the executive, behind those already queued. `by`: who gets the answer.
  enum class By { kNode, kSupervisor, kNobody };
  void run(executive::Input input, By by = By::kNode);
  void take(const SyncMessage& message);
  void take(const DegreeTold& told) { degrees_[told.from] = told.degree; }

  /// Aborts synchronisations that wait for a partner that is given up.
  void give_up_on_partners();

  /// Whether the executive has this task, unfinished.
  bool holds(functional::TaskId id) const;
  /// Whether this task is being aborted.
  bool stops(functional::TaskId id) const;
  /// It is a wait without end, which the executive ends when another motion begins.
  bool gives_way(executive::TaskId id) const;
  std::vector<executive::TaskStatus> tasks() const { return executive_.tasks(); }
  std::uint64_t changes() const { return executive_.changes(); }
  /// Unfinished tasks except the background routine, with the goals they serve.
  std::vector<mission::HeldTask> held() const;
  bool airborne() const { return airborne_; }
  /// Hands the tasks with ids below `below` over to the ground's executive, with the
  /// synchronisation messages received for them.
  void let_go(executive::TaskId below, const std::vector<mission::HeldTask>& tasks);

 private:
  struct Asked {
    executive::Input input;
    By by = By::kNode;
    std::optional<Command> command = {};
  };
  void post(Asked asked);
  /// Whether synchronisation messages to `uav` are sent directly, not through the ground station.
  bool synchronises_directly(const std::string& uav) const;
  /// Whether a wait for `uav` ends after its lease: both deliberate, or nobody else would end it.
  bool has_lease(const std::string& uav) const;
  /// When a silent UAV is waited for no longer; absent: it goes on waiting.
  std::optional<MissionTime> gives_up_at(const executive::Wait& wait, const std::string& uav) const;
  std::optional<MissionTime> stays_away_until(const executive::Wait& wait,
                                              const std::string& uav) const;
  /// Why the partner is waited for no longer; absent: it is.
  std::optional<std::string> why_given_up(const executive::Wait& wait, const std::string& uav);
  void give_up(functional::TaskId wait, const std::string& why);
  /// The executive's waits, each from when its partners are waited for.
  std::vector<executive::Wait> waits() const;
  void note_over(functional::TaskId id);
  void handle(const Asked& asked);
  /// The task under way that is to be aborted and that the ground has not given back yet.
  std::optional<functional::TaskId> not_given_back(const executive::Input& input) const;
  void carry_out(const executive::TaskEvent& event, const Asked& asked);
  void carry_out(const executive::Dispatch& dispatch, const Asked& asked);
  void carry_out(const executive::Interrupt& interrupt, const Asked& asked);
  void carry_out(const executive::SendSync& sync, const Asked& asked);
  void carry_out(const executive::Reply& reply, const Asked& asked);
  void carry_out(const executive::ForwardToSupervisor&, const Asked&) {}
  void carry_out(const executive::Notice& notice, const Asked& asked);

  Core& core_;
  executive::Executive executive_;
  bool airborne_ = false;
  /// The last message received of each synchronisation and sender.
  std::map<std::pair<std::uint64_t, std::string>, SyncMessage> syncs_;
  /// When a partner without the synchronisation in its plan was last given up; a goal that is
  /// planned anew does not wait for it again.
  std::map<std::pair<std::string, std::uint64_t>, MissionTime> stayed_away_;
  WaitStarts wait_starts_;
  /// Degrees of other UAVs, as far as known.
  std::map<std::string, mission::Degree> degrees_;
  /// Tasks of the plan that are over, in the order of their ends.
  std::deque<functional::TaskId> over_;
};

}  // namespace skein::decision_node
