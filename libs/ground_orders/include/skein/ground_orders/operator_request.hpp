// SPDX-License-Identifier: Apache-2.0
// Requests of operators to the ground station while a mission runs, and the answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/ground_orders/alarm.hpp"
#include "skein/ground_orders/messages.hpp"
#include "skein/ground_orders/script.hpp"

namespace skein::ground_station {

/// Asks the operator who has the UAV in hand to let go of it. Without KeepUav in time it passes to
/// the asker.
struct AskForUav {
  std::string uav;
};
/// The refusal of AskForUav: the UAV stays in the hand of its holder.
struct KeepUav {
  std::string uav;
};
/// The UAV is in nobody's hand from now on, or in that of operator `to`; its degree stays.
struct LetGo {
  std::string uav;
  std::string to = {};  ///< empty: nobody
};
/// The operator's action that a step of the script waits for (OnOperator).
struct Answer {
  std::string does;
};
/// A person judges an alarm: kConfirmed or kInfirmed.
struct JudgeAlarm {
  AlarmId alarm;
  AlarmState state = AlarmState::kConfirmed;
};
/// Makes a UAV in the operator's hand fly along the points [m] ENU, at once.
struct SteerTo {
  std::string uav;
  std::vector<world::Vector3> points;
  bool drives = false;  ///< it keeps to the ground
};

/// One element of a request: an action as in a script, or one that only operators have.
using OperatorDeed = std::variant<Action, AskForUav, KeepUav, LetGo, Answer, JudgeAlarm, SteerTo>;

/// "take_in_hand marvin", "close_air tower", "judge_alarm 1 confirmed": for people.
std::string to_text(const OperatorDeed& deed);
/// The UAV that the deed commands, which no other operator may have in hand; empty: none.
std::string commanded_by(const OperatorDeed& deed);

/// A request of an operator: all deeds are done, in order, or none.
struct OperatorRequest {
  std::string who;
  std::uint64_t number = 0;       ///< from 1, unique among this operator's requests
  std::uint64_t fingerprint = 0;  ///< hash of its text, to recognise a repeated request
  std::vector<OperatorDeed> deeds = {};
  std::vector<std::string> problems = {};  ///< found when the request was read
};

/// A command that was issued, and its state.
struct IssuedCommand {
  CommandNumber command;
  std::string uav;
  std::string what;
  std::string asked_by;
  CommandState state = CommandState::kIssued;
  std::string why = {};
  MissionTime issued;
  std::optional<MissionTime> settled = {};
};

/// The result of a request so far.
struct OperatorAnswered {
  std::string who;
  std::uint64_t number = 0;
  bool accepted = false;
  bool complete = false;  ///< refused, or all its commands are settled
  /// Why it was refused, all at once; of an accepted request, what could not be done.
  std::vector<std::string> problems = {};
  std::vector<IssuedCommand> commands = {};
};

/// A request was accepted or refused; for the journal, once.
struct OperatorAsked {
  std::string who;
  std::uint64_t number = 0;
  std::string what;
  bool accepted = false;
  std::string why = {};
};

/// The operator who has a UAV in hand, and the one who asks for it.
struct Hand {
  std::string holder = {};                    ///< empty: nobody
  std::string asker = {};                     ///< empty: nobody
  std::optional<MissionTime> passes_at = {};  ///< when it passes to the asker, unless it is kept
  bool operator==(const Hand&) const = default;
};
struct HandChanged {
  std::string uav;
  Hand hand;
};

/// Actions of an operator, to be carried out like those of a script.
struct DoActions {
  std::vector<Action> actions;
  std::string asked_by;
};

}  // namespace skein::ground_station
