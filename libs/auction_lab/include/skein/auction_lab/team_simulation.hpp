// SPDX-License-Identifier: Apache-2.0
// A team in virtual time: members that crash and restart, links that are cut and heal, tasks that
// take time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "skein/auction_lab/flat_craft.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

struct TeamWorld {
  std::vector<FlatVehicle> vehicles;
  bool ground = false;  ///< one more member, that only votes
  TeamLimits limits;
  Duration least_delay = Duration::milliseconds(5);
  Duration longest_delay = Duration::milliseconds(80);
  double loss = 0;  ///< of each message
  std::uint64_t seed = 1;
};

/// A member doing a task.
struct Execution {
  enum class End : std::uint8_t { kRunning, kDone, kCrashed, kFailed };
  Claim claim;
  MemberNumber member;
  MissionTime began, ended;
  End end = End::kRunning;
  std::vector<MemberNumber> owners;  ///< of the sale under which it began
  std::string why;                   ///< of that sale
  MissionTime there{};               ///< it begins when the way to the task does
};

/// A member that took the token.
struct TokenHeld {
  MemberNumber member;
  std::uint64_t term = 0;
  MissionTime taken;
};

/// Members count from 0, the ground station is the last. Everything follows from the seed.
class TeamSimulation {
 public:
  explicit TeamSimulation(TeamWorld world);

  std::size_t size() const { return members_.size(); }
  void give(std::size_t member, const GivenMission& mission);
  void cut(std::size_t one, std::size_t other);
  void heal_all() { cuts_.clear(); }
  /// What it does stops; what it stored stays.
  void crash(std::size_t member);
  void restart(std::size_t member);
  bool alive(std::size_t member) const { return members_[member].alive != nullptr; }
  void declare_lost(std::size_t told, std::size_t lost);
  void declare_found(std::size_t told, std::size_t found);
  /// What it does fails; it says so.
  void fail_task(std::size_t member);
  void run_until(MissionTime until);

  MissionTime now() const { return now_; }
  /// Of a member that is alive.
  const Ledger& ledger(std::size_t member) const { return members_[member].alive->ledger(); }
  std::size_t token_holders() const;
  const std::vector<Execution>& executions() const { return executions_; }
  /// Every token ever taken, in order.
  const std::vector<TokenHeld>& tokens() const { return tokens_; }
  const std::vector<SaleEffect>& told() const { return told_; }
  std::uint64_t messages() const { return messages_; }

 private:
  struct Member {
    std::unique_ptr<TeamMember> alive;  ///< none: crashed
    Disk disk;
    Place at;
    std::uint64_t life = 0;  ///< restarts: what was for an earlier one is not heard
    std::optional<std::size_t> running;
  };
  struct Event {
    MissionTime at;
    std::uint64_t number = 0;
    std::size_t member = 0;
    std::uint64_t life = 0;
    TeamInput input;
  };
  struct Later {
    bool operator()(const Event& a, const Event& b) const {
      return std::pair(a.at, a.number) > std::pair(b.at, b.number);
    }
  };

  void start(std::size_t member);
  void feed(std::size_t member, const TeamInput& input);
  void send(std::size_t from, const Tell& tell);
  void begin(std::size_t member, const Claim& claim);
  void schedule(std::size_t member, Duration in, TeamInput input);
  bool linked(std::size_t one, std::size_t other) const;

  TeamWorld world_;
  Random random_;
  std::vector<Member> members_;
  std::set<std::pair<std::size_t, std::size_t>> cuts_;
  std::priority_queue<Event, std::vector<Event>, Later> events_;
  std::vector<Execution> executions_;
  std::vector<TokenHeld> tokens_;
  std::vector<SaleEffect> told_;
  std::uint64_t messages_ = 0, events_made_ = 0;
  MissionTime now_;
};

}  // namespace skein::auction
