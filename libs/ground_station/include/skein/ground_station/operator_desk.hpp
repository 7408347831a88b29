// SPDX-License-Identifier: Apache-2.0
// Where operators' requests are received: what is done, for whom, and what they are told.
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

/// Several operators, known by name, ask at once. Laws:
/// - a request, known by operator and number, is done at most once; asked again, it is answered
/// again
///   with what came of it so far; another request under its number is refused;
/// - all problems of a request are told, and then none of its deeds is done;
/// - every accepted request is complete in the end, since every command comes to its end;
/// - at most one operator has a UAV in hand, and only that one commands it meanwhile; a UAV that
///   nobody has in hand may be commanded by all. Script and scripted operators are not asked;
/// - who is asked to let go has kPatience to keep the UAV: then it passes to who asked. So nobody
///   who has gone away holds a UAV for ever.
///
/// | hand of a UAV | when                                    | then                          |
/// |---------------|-----------------------------------------|-------------------------------|
/// | nobody's      | take_in_hand, steering                  | the operator's                |
/// | one's         | he gives back, or lets go               | nobody's, or whom he names    |
/// | one's         | another asks                            | his, with an asker            |
/// | with an asker | he keeps it                             | his                           |
/// | with an asker | kPatience passes                        | the asker's                   |
///
/// Memory is bounded: kRequestsKept of each operator are remembered, and of what is older than
/// these it is only known that it is. Deterministic; not safe to share between threads. Cost of a
/// request: O(deeds × UAVs). Source: ADR 16.
class OperatorDesk {
 public:
  static constexpr Duration kPatience = Duration::milliseconds(30'000);
  static constexpr std::size_t kRequestsKept = 64;
  static constexpr std::size_t kOperators = 64;
  static constexpr std::size_t kLongestName = 64;  ///< [byte]
  /// Tasks by which operators steer are numbered from here on.
  static constexpr std::uint64_t kFirstSteeringId = 900'000'000;

  /// What a request is checked against.
  struct Surroundings {
    const Board& board;
    std::vector<std::string> answers;  ///< that the script waits for
    std::vector<Alarm> alarms;
  };
  using Effect = std::variant<DoActions, OperatorActs, JudgeAlarm, OperatorAsked, HandChanged>;

  std::vector<Effect> handle(const OperatorRequest& request, const Surroundings& around,
                             MissionTime now);
  /// UAVs that were not kept pass to who asked.
  std::vector<Effect> wake(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Commands and what could not be done belong to the request that asked for them.
  void note(const CommandChanged& change, MissionTime now);
  void note(const Anomaly& anomaly);
  /// Of every request about which there is something new, or that was asked again.
  std::vector<OperatorAnswered> take_answers();

  /// Nobody's for a UAV that was never in hand.
  Hand hand_of(const std::string& uav) const;
  /// The latest, oldest first, of all who ask; not more than kCommandsKept.
  const std::deque<IssuedCommand>& commands() const { return latest_; }
  static constexpr std::size_t kCommandsKept = 64;

 private:
  struct Entry {
    std::uint64_t fingerprint = 0;
    OperatorAnswered answer;
  };
  struct Operator {
    std::map<std::uint64_t, Entry> requests;
    std::uint64_t forgotten = 0;  ///< the greatest number of those that are not remembered
  };
  using Effects = std::vector<Effect>;
  using Hands = std::map<std::string, Hand>;
  using Key = std::pair<std::string, std::uint64_t>;

  /// A request that is looked at: nothing of it is done while it may still be refused.
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
  std::map<std::string, std::uint64_t> steering_;  ///< next task's number, by UAV
  std::map<std::string, Key> asked_by_;            ///< requests with commands, by their asked_by
  std::set<Key> news_;
  std::vector<OperatorAnswered> refusals_;  ///< of what was no request
  std::deque<IssuedCommand> latest_;
};

}  // namespace skein::ground_station
