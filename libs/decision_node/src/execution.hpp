// SPDX-License-Identifier: Apache-2.0
// The executive as a component.
#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "component.hpp"
#include "skein/executive/executive.hpp"

namespace skein::decision_node {

class Core;

class Execution final : public Component {
 public:
  explicit Execution(Core& core);

  void take(const Command& command) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void peer_in_reach(const std::string& peer) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override { return executive_.next_wakeup(); }

  /// What is asked of the executive, and by whom (nobody: whose answer nobody is told); done after
  /// all that was asked before.
  enum class By { kNode, kSupervisor, kNobody };
  void run(executive::Input input, By by = By::kNode);
  void take(const SyncMessage& message);
  void take(const DegreeTold& told) { degrees_[told.from] = told.degree; }

  /// A task that is not over.
  bool holds(functional::TaskId id) const;
  /// One that is being aborted.
  bool stops(functional::TaskId id) const;
  std::vector<executive::TaskStatus> tasks() const { return executive_.tasks(); }
  std::uint64_t changes() const { return executive_.changes(); }
  /// Tasks that are not over, without the background routine, with the goals they serve.
  std::vector<mission::HeldTask> held() const;
  bool airborne() const { return airborne_; }
  /// The ground's executive has the tasks below an id from now on, with the synchronisation
  /// messages that came here.
  void let_go(executive::TaskId below, const std::vector<mission::HeldTask>& tasks);

 private:
  struct Asked {
    executive::Input input;
    By by = By::kNode;
    std::optional<Command> command = {};
  };
  void post(Asked asked);
  /// Its synchronisation messages go from here to the UAV, not past the ground station.
  bool synchronises_directly(const std::string& uav) const;
  void note_over(functional::TaskId id);
  void handle(const Asked& asked);
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
  /// Received: the last of each synchronisation and sender.
  std::map<std::pair<std::uint64_t, std::string>, SyncMessage> syncs_;
  /// Of other UAVs, as far as they have said.
  std::map<std::string, mission::Degree> degrees_;
  /// Tasks that are over and in the plan, in that order.
  std::deque<functional::TaskId> over_;
};

}  // namespace skein::decision_node
