// SPDX-License-Identifier: Apache-2.0
// The components of a decision node, and the distribution of inputs to them.
#pragma once

#include <array>
#include <optional>

#include "autonomy.hpp"
#include "bus.hpp"
#include "commands.hpp"
#include "deliberation.hpp"
#include "execution.hpp"
#include "interaction/interaction.hpp"
#include "interaction/on_board.hpp"
#include "interaction/voice.hpp"
#include "meetings/meetings.hpp"
#include "merging/merging.hpp"
#include "own_tasks.hpp"
#include "partners.hpp"
#include "safekeeping.hpp"
#include "skein/decision_node/decision_node.hpp"
#include "team/team.hpp"
#include "vehicle.hpp"

namespace skein::decision_node {

class Core {
 public:
  explicit Core(Config config);

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  const Config& config() const { return config_; }
  int degree() const { return autonomy_.degree(); }
  Bus& bus() { return bus_; }
  Commands& commands() { return commands_; }
  Partners& partners() { return partners_; }
  OwnTasks& own_tasks() { return own_tasks_; }
  Vehicle& vehicle() { return vehicle_; }
  Execution& execution() { return execution_; }
  Deliberation& deliberation() { return deliberation_; }
  Interaction& interaction() { return interaction_; }
  const Merging& merging() const { return merging_; }
  Voice& voice() { return voice_; }
  Team& team() { return team_; }
  Meetings& meetings() { return meetings_; }
  Autonomy& autonomy() { return autonomy_; }
  Safekeeping& safekeeping() { return safekeeping_; }

  /// An operator says that this UAV is lost: nobody here waits for it any more.
  void declare_lost(const std::string& uav);
  /// An operator takes that back.
  void declare_found(const std::string& uav);
  /// Tells every component that a task entered a state, whichever executive has it, if any.
  void tell_task(const executive::TaskEvent& event);
  /// Interrupts a task that the functional layer was given.
  void interrupt(functional::TaskId task);
  /// Queues a status on behalf of the functional layer, behind the inputs already queued.
  void post_status(functional::Status status);

 private:
  void on(const Started& started);
  void on(const Command& command);
  void on(const UnreadableCommand& command);
  void on(const PlaceTold& told);
  void on(const ElementaryRequest& asked);
  void on(const GroundTaskSeen& seen) { tell_task(seen.event); }
  void on(const StatusTold& told);
  void on(const SyncMessage& message) { execution_.take(message); }
  void on(const DegreeTold& told) { execution_.take(told); }
  void on(const world::Telemetry& telemetry);
  void on(const world::Perception& perception) { bus_.emit(PerceptionPassedOn{perception}); }
  void on(const LayerForgot& forgot);
  void on(const Contact& contact);
  void on(const supervisor::JobFinished& done) { deliberation_.job_finished(done); }
  /// A message about a joint task: passed on to the ground if the ground plays the role.
  template <class Heard>
  void on_joint(const Heard& heard) {
    if (!voice_.passes_on(heard)) interaction_.hear(heard);
  }
  void on(const interaction::SessionMessage& message) { on_joint(message); }
  void on(const PartnerSeen& seen) { on_joint(seen); }
  void on(const JointTaskTold& told) { on_joint(told); }
  void on(const GroundNegotiates& said) { voice_.say(said); }
  void on(const GroundPlays& said) { voice_.say(said); }
  void on(const ReckoningFinished& done) { interaction_.reckoned(done); }
  void on(const DetoursPlanned& done) { team_.detours_planned(done); }
  void on(const TeamTold& told) { team_.hear(told); }
  void on(const MergeTold& told) { merging_.hear(told); }
  void on(const WaySearched& done) { merging_.hear(done); }
  void on(const FrontierTold& told) { meetings_.hear(told); }
  void on(const Tick&);
  void pass_on(const functional::Status& status);
  void tell_board_if_changed();
  /// All components, in the order in which they are told of events.
  std::array<Component*, 7> components() {
    return {&merging_, &execution_, &deliberation_, &interaction_, &voice_, &team_, &meetings_};
  }
  std::array<const Component*, 7> components() const {
    return {&merging_, &execution_, &deliberation_, &interaction_, &voice_, &team_, &meetings_};
  }

  Config config_;
  Bus bus_;
  Commands commands_;
  Partners partners_;
  OwnTasks own_tasks_;
  Vehicle vehicle_;
  Merging merging_;
  Execution execution_;
  Deliberation deliberation_;
  OnBoard joint_host_;
  Interaction interaction_;
  Voice voice_;
  Team team_;
  Meetings meetings_;
  Autonomy autonomy_;
  Safekeeping safekeeping_;
  /// Changes whenever a board made now would differ.
  struct BoardMark {
    int degree = 0;
    bool airborne = false;
    std::uint64_t changes = 0;  ///< Executive::changes()
    bool operator==(const BoardMark&) const = default;
  };
  std::optional<BoardMark> board_mark_;  ///< at the last board sent
  std::optional<BoardChanged> last_board_;
};

}  // namespace skein::decision_node
