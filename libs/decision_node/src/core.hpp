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
  /// To whom each kind of input goes (inputs.cpp).
  class Inputs;

  void told(const functional::Status& status);
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
