// SPDX-License-Identifier: Apache-2.0
// What is under way about the degree of a UAV.
#pragma once

#include <optional>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// The change of degree that was sent and is not settled, what came of the last one, and when the
/// degree was told last: plan boards, hand-overs and answers come in any order. A value; not safe
/// to share between threads. Cost of each call: O(1).
class DegreeChange {
 public:
  /// Sent; counts as settled at `until`.
  void begin(CommandNumber command, const mission::ChangeDegree& wanted, MissionTime until);
  bool under_way() const { return change_.has_value(); }
  /// What the board will show, which shows `degree` now.
  Degree expected(Degree degree) const { return change_ ? change_->wanted.degree : degree; }
  /// The command of the one under way.
  std::optional<CommandNumber> command() const;
  /// When the one under way counts as settled.
  std::optional<MissionTime> until() const;

  /// A plan board tells the degree. Returns the one to show; absent: none, since what is told is
  /// old, or waits for the end of the change.
  std::optional<Degree> on_board(Degree told, std::optional<MissionTime> at);
  /// A command has ended, at a UAV of this degree. Returns whether the change is settled thereby:
  /// what is accepted and makes a difference is settled by the hand-over that follows.
  bool ended(CommandNumber command, CommandState state, Degree degree);

  struct Meaning {
    bool wanted = false;   ///< it settles the change under way
    bool resumes = false;  ///< what was held may be forgotten: the UAV was asked to resume
    bool unasked = false;  ///< the UAV interrupted its plan by itself
  };
  /// The UAV, of this degree so far, hands its plan over.
  Meaning handed_over(Degree to, Degree degree, std::optional<MissionTime> at);

  /// The change under way is over. Returns the degree on plan boards meanwhile. Precondition:
  /// under_way().
  std::optional<Degree> settle();

 private:
  struct Change {
    CommandNumber command;
    mission::ChangeDegree wanted;
    MissionTime until;
    std::optional<Degree> seen;  ///< on plan boards meanwhile
  };
  std::optional<Change> change_;
  std::optional<MissionTime> told_at_;  ///< time of the last degree told
  /// The last change that expired; it may have been made, and its hand-over be under way.
  std::optional<mission::ChangeDegree> unanswered_;
  bool tells_again_ = false;  ///< asked for the degree that it has: its plan comes all the same
};

}  // namespace skein::ground_station
