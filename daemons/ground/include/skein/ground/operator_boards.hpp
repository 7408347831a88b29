// SPDX-License-Identifier: Apache-2.0
// What the ground station tells operators of what it knows.
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

/// The boards that have changed since they were last told, not more often than each kPeriod, and
/// not at all while nothing happens.
class OperatorBoards {
 public:
  static constexpr Duration kPeriod = Duration::milliseconds(500);
  /// Of a UAV's tasks that are over; the others are all told.
  static constexpr std::size_t kTasksOver = 40;

  /// `something`: an input came that may have changed a board; `tasks`: it may have changed more of
  /// a UAV than where it is.
  void something_happened(bool something, bool tasks) {
    changed_ = changed_ || something;
    tasks_changed_ = tasks_changed_ || (something && tasks);
  }
  std::optional<MissionTime> next_wakeup() const;
  bool is_due(MissionTime now) const;
  /// `team`: null where the ground station is in none. Precondition: it is due.
  std::vector<wire::Sample> news(const ground_station::GroundControl& control,
                                 const ground_station::TeamDesk* team, const node::Roster& roster,
                                 MissionTime now);
  /// Nobody reads what is told from here on: news() gives nothing, and costs nothing, but what is
  /// due is due as ever.
  void go_unread() { unread_ = true; }
  /// They are read again: all boards, as they are now, if any was due meanwhile.
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

/// The answer as it goes out.
wire::OperatorReply operator_reply(const ground_station::OperatorAnswered& answer);

}  // namespace skein::ground
