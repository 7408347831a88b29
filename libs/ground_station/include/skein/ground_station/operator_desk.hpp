// SPDX-License-Identifier: Apache-2.0
// Receives operators' requests, checks them against each other, and answers them.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/ground_orders/operator_request.hpp"
#include "skein/ground_station/monitoring.hpp"

namespace skein::ground_station {

/// Serves several operators, identified by name, concurrently. Laws:
/// - a request, identified by operator and number, is done at most once; if it is repeated, its
///   present result is sent again; another request with its number is refused;
/// - a request with problems is answered with all of them, and none of its deeds is done;
/// - every accepted request is complete in the end, since every command is settled in the end;
/// - at most one operator has a UAV in hand, and only that operator commands it meanwhile; a UAV in
///   nobody's hand may be commanded by all. Script and scripted operators are exempt;
/// - an operator who is asked to let go of a UAV has kPatience to keep it; then it passes to the
///   asker. So no absent operator keeps a UAV for ever.
///
/// | hand of a UAV | when                                    | then                          |
/// |---------------|-----------------------------------------|-------------------------------|
/// | nobody's      | take_in_hand, steering                  | the operator's                |
/// | a holder's    | the holder gives back, or lets go       | nobody's, or the named one's  |
/// | a holder's    | another operator asks                   | the holder's, with an asker   |
/// | with an asker | the holder keeps it                     | the holder's                  |
/// | with an asker | kPatience passes                        | the asker's                   |
///
/// Memory is bounded: the last kRequestsKept requests of each operator are remembered; older ones
/// are recognised as old by their numbers. Deterministic; not safe to share between threads. Cost
/// of a request: O(deeds × UAVs). Source: ADR 16.
class OperatorDesk {
 public:
  static constexpr Duration kPatience = Duration::milliseconds(30'000);
  static constexpr std::size_t kRequestsKept = 64;
  static constexpr std::size_t kOperators = 64;
  static constexpr std::size_t kLongestName = 64;  ///< [byte]

  /// The state that a request is checked against.
  struct Surroundings {
    const Board& board;
    std::vector<std::string> answers;  ///< operator actions that the script waits for
    std::vector<Alarm> alarms;
  };
  using Effect = std::variant<DoActions, OperatorActs, JudgeAlarm, OperatorAsked, HandChanged>;

  std::vector<Effect> handle(const OperatorRequest& request, const Surroundings& around,
                             MissionTime now);
  /// Passes UAVs to their askers when kPatience is over.
  std::vector<Effect> wake(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Adds the change of a command, or an anomaly, to the answer of the request that caused it.
  void note(const CommandChanged& change, MissionTime now);
  void note(const Anomaly& anomaly);
  /// The team is asked whether it takes a mission of a request; until it has said so the request is
  /// not answered. Why it refuses is added to the answer.
  void note(const GiveGlobalMission& mission);
  void note(const GlobalMissionChanged& change);
  /// The answers to requests that have news, or that were repeated, since the last call.
  std::vector<OperatorAnswered> take_answers();

  /// Who has the UAV in hand; nobody if it never was.
  Hand hand_of(const std::string& uav) const;
  /// The latest commands of all sources, oldest first; at most kCommandsKept.
  const std::deque<IssuedCommand>& commands() const { return latest_; }
  static constexpr std::size_t kCommandsKept = 64;

 private:
  struct Entry {
    std::uint64_t fingerprint = 0;
    OperatorAnswered answer;
  };
  struct Operator {
    std::map<std::uint64_t, Entry> requests;
    std::uint64_t forgotten = 0;  ///< greatest number of a request that is no longer remembered
  };
  using Effects = std::vector<Effect>;
  using Hands = std::map<std::string, Hand>;
  using Key = std::pair<std::string, std::uint64_t>;

  /// A request under examination: its effects are kept back while it may still be refused.
  struct Draft {
    const OperatorRequest& request;
    const Surroundings& around;
    MissionTime now;
    Hands hands;
    Effects effects = {};
    std::vector<std::string> problems = {};
    std::map<std::string, std::uint64_t> steering = {};
  };

  std::vector<std::string> problems_of_form(const OperatorRequest& request) const;
  const Entry* find(const std::string& who, std::uint64_t number) const;
  void remember(const OperatorRequest& request, OperatorAnswered answer);
  static OperatorAsked asked(const Draft& draft);
  Effects adopt(Draft& draft);
  void forget(Operator& one);
  static const UavOnBoard* find(const Draft& draft, const std::string& uav);
  static bool may_command(Draft& draft, const std::string& uav);
  void draft_deed(const OperatorDeed& deed, Draft& draft) const;
  void take(const Action& action, Draft& draft) const;
  void take(const AskForUav& deed, Draft& draft) const;
  void take(const KeepUav& deed, Draft& draft) const;
  void take(const LetGo& deed, Draft& draft) const;
  void take(const Answer& deed, Draft& draft) const;
  void take(const JudgeAlarm& deed, Draft& draft) const;
  void take(const SteerTo& deed, Draft& draft) const;

  std::map<std::string, Operator> operators_;
  Hands hands_;
  std::map<std::string, std::uint64_t> steering_;  ///< id of the next steering task, by UAV
  std::map<std::string, Key> asked_by_;            ///< requests with commands, by `asked_by`
  std::set<Key> news_;
  std::map<mission::MissionId, Key> given_;  ///< global missions that the team has still to take on
  std::vector<OperatorAnswered> refusals_;   ///< of malformed requests
  std::deque<IssuedCommand> latest_;
};

}  // namespace skein::ground_station
