// SPDX-License-Identifier: Apache-2.0
// Commands that were issued and have not ended.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Numbers commands from 1 and keeps each until it is taken. Deterministic. A value; not safe to
/// share between threads. Cost: O(log n) in the commands that are kept, but O(n) of what is asked
/// about all of a UAV.
class PendingCommands {
 public:
  static constexpr std::size_t kExpiredKept = 64;

  struct Pending {
    std::string uav;
    Request request;
    MissionTime expires;
    std::string asked_by;
    bool delivered = false;
  };

  /// `grace`: how long after a command's expiry its answer may still be under way.
  explicit PendingCommands(Duration grace) : grace_(grace) {}

  CommandNumber issue(const IssueCommand& command);
  /// Null: it is over, or there never was one. Valid until it is taken.
  const Pending* find(CommandNumber number) const;
  /// It is over. Absent: it is over already, or there never was one.
  std::optional<Pending> take(CommandNumber number);
  /// It has expired: it is remembered among the last ones, since an answer may come all the same.
  void remember_expired(CommandNumber number, const Pending& pending);
  /// One that has expired, once. Absent: that is not so, or long ago.
  std::optional<Pending> take_expired(CommandNumber number);
  /// Absent: it is over, or its delivery was told.
  std::optional<CommandChanged> deliver(CommandNumber number);

  MissionTime given_up_at(const Pending& pending) const { return pending.expires + grace_; }
  /// The first one that is given up by `now`.
  std::optional<CommandNumber> given_up(MissionTime now) const;
  std::optional<MissionTime> next_wakeup() const;

  /// Those of the UAV, in the order of their issue.
  std::vector<std::pair<CommandNumber, Pending>> of(const std::string& uav) const;
  /// The tasks that those of the UAV start.
  std::set<executive::TaskId> started_for(const std::string& uav) const;
  /// What the last change of degree among these asks for.
  std::optional<Degree> last_degree_of(const std::deque<CommandNumber>& numbers) const;

 private:
  std::map<CommandNumber, Pending> pending_;
  std::set<std::pair<MissionTime, CommandNumber>> deadlines_;
  std::map<CommandNumber, Pending> expired_;  ///< the last kExpiredKept
  Duration grace_;
  std::uint64_t last_number_ = 0;
};

/// In words: "START 3 goto, for marvin".
std::string in_words(const PendingCommands::Pending& pending);

/// For the journal. `why`: of its end.
CommandChanged changed(CommandNumber number, const PendingCommands::Pending& pending,
                       CommandState state, const std::string& why = {});

}  // namespace skein::ground_station
