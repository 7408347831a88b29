// SPDX-License-Identifier: Apache-2.0
// Boards: the state of the ground station, as published to operators.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "skein/ground_station/team_desk.hpp"
#include "skein/node/roster.hpp"

namespace skein::ground {

/// Publishes the boards that have changed since they were last sent, at most once per kPeriod, and
/// none while nothing happens.
class OperatorBoards {
 public:
  static constexpr Duration kPeriod = Duration::milliseconds(500);
  /// Most finished tasks in a UAV's board; all others are included.
  static constexpr std::size_t kTasksOver = 40;

  /// `something`: an input may have changed a board; `tasks`: it may have changed more of a UAV
  /// than its position.
  void something_happened(bool something, bool tasks) {
    changed_ = changed_ || something;
    tasks_changed_ = tasks_changed_ || (something && tasks);
  }
  std::optional<MissionTime> next_wakeup() const;
  bool is_due(MissionTime now) const;
  /// The changed boards. `team`: null if the ground station is in no team. Precondition: boards are
  /// due.
  std::vector<wire::Sample> news(const ground_station::GroundControl& control,
                                 const ground_station::TeamDesk* team, const node::Roster& roster,
                                 MissionTime now);
  /// There are no readers from now on: news() returns nothing, at no cost, but boards become due as
  /// before.
  void go_unread() { unread_ = true; }
  /// There are readers again: returns all current boards, if any was due meanwhile.
  std::vector<wire::Sample> be_read(const ground_station::GroundControl& control,
                                    const ground_station::TeamDesk* team,
                                    const node::Roster& roster);

 private:
  std::vector<wire::Sample> changed_boards(const ground_station::GroundControl& control,
                                           const ground_station::TeamDesk* team,
                                           const node::Roster& roster, bool tasks);
  void tell(wire::Sample board, std::vector<wire::Sample>& news);

  bool unread_ = false;
  bool missed_ = false;  ///< some were due while nobody read
  bool changed_ = false;
  bool tasks_changed_ = true;  ///< none was told yet
  std::optional<MissionTime> told_at_;
  std::map<std::pair<wire::Slot, std::uint32_t>, wire::Sample> told_;
};

/// The answer to an operator as a sample.
wire::OperatorReply operator_reply(const ground_station::OperatorAnswered& answer);

}  // namespace skein::ground
