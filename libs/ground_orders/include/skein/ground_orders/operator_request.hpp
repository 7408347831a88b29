// SPDX-License-Identifier: Apache-2.0
// What operators ask of the ground station while a mission runs, and what they are told.
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

/// Would the operator who has the UAV in hand let go of it? If he does not keep it, it passes.
struct AskForUav {
  std::string uav;
};
/// The answer: no. It stays with who has it.
struct KeepUav {
  std::string uav;
};
/// Nobody has it in hand from now on, or another operator does; its degree stays.
struct LetGo {
  std::string uav;
  std::string to = {};  ///< empty: nobody
};
/// What a step of the script waits for from an operator.
struct Answer {
  std::string does;
};
/// A person has judged: confirmed or infirmed.
struct JudgeAlarm {
  AlarmId alarm;
  AlarmState state = AlarmState::kConfirmed;
};
/// A UAV in the operator's hand flies along the points [m] ENU, at once.
struct SteerTo {
  std::string uav;
  std::vector<world::Vector3> points;
};

/// What a script can do, and what only a person can.
using OperatorDeed = std::variant<Action, AskForUav, KeepUav, LetGo, Answer, JudgeAlarm, SteerTo>;

/// "take_in_hand marvin", "close_air tower", "judge_alarm 1 confirmed": for people.
std::string to_text(const OperatorDeed& deed);
/// The UAV that it commands, so that nobody else may have it in hand; empty: none.
std::string commanded_by(const OperatorDeed& deed);

/// All of its deeds are done, in order, or none.
struct OperatorRequest {
  std::string who;
  std::uint64_t number = 0;       ///< from 1; of this operator's requests, each is done once
  std::uint64_t fingerprint = 0;  ///< of its text: whether one with the same number is the same
  std::vector<OperatorDeed> deeds = {};
  std::vector<std::string> problems = {};  ///< found when it was read
};

/// A command that was issued, and what came of it.
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

/// What came of a request so far.
struct OperatorAnswered {
  std::string who;
  std::uint64_t number = 0;
  bool accepted = false;
  bool complete = false;  ///< refused, or all its commands came to their end
  /// Why it was refused; of an accepted one, what of it could not be done. All at once.
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

/// Who has a UAV in hand, and who asks for it.
struct Hand {
  std::string holder = {};                    ///< empty: nobody
  std::string asker = {};                     ///< empty: nobody
  std::optional<MissionTime> passes_at = {};  ///< then it is the asker's, unless it is kept
  bool operator==(const Hand&) const = default;
};
struct HandChanged {
  std::string uav;
  Hand hand;
};

/// Actions of an operator, to be done as those of a script are.
struct DoActions {
  std::vector<Action> actions;
  std::string asked_by;
};

}  // namespace skein::ground_station
