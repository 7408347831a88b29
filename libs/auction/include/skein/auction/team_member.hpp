// SPDX-License-Identifier: Apache-2.0
// One member of a team that allocates its global missions by auction.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/ledger.hpp"

namespace skein::auction {

struct TeamLimits {
  Duration beat = Duration::milliseconds(500);
  /// Without a beat for this time plus a random part of up to as much again, a member becomes a
  /// candidate for the token.
  Duration patience = Duration::seconds(2);
  /// After this silence of a member, tasks that it owns without a grant are sold again. Granted
  /// tasks wait until the member is heard or declared lost, unless they are repeatable: the cost of
  /// at-most-once execution under a partition.
  Duration lease = Duration::seconds(10);
  std::uint32_t ahead = 1;  ///< tasks granted to a member at a time, which it may do while cut off
  Aim aim{0.5};
  SaleLimits sale{};
};

/// What a member must keep through a crash. To be stored before the effects after it are carried
/// out.
struct Disk {
  std::uint64_t term = 0;
  bool voted = false;  ///< in that term
  std::shared_ptr<const Ledger> ledger;
  std::map<TaskNumber, std::uint64_t> started;  ///< task to the last sale under which it began it
  std::map<TaskNumber, std::uint64_t> done;
  std::map<TaskNumber, MissionTime> done_at;  ///< when it ended each of these
  std::map<TaskNumber, std::uint64_t> stopped;
  std::map<TaskNumber, std::string> stopped_why;
  /// Given to this member, which says them whenever its ledger lacks them: another holder of the
  /// token may come with an older one.
  std::vector<GivenMission> missions;
};

/// Makes the craft for bids in a sale. None: not yet; the member, which has been without one since
/// `since`, keeps the call, its own auctioneer's too, and asks again at each input.
using CraftMaker = std::function<std::unique_ptr<const Craft>(
    std::shared_ptr<const Catalogue> catalogue, MissionTime since)>;

struct TeamSetup {
  MemberNumber self;
  std::vector<MemberNumber> roster;  ///< all voting members, this one included
  CraftMaker craft;                  ///< none: votes only, as the ground station does
  TeamLimits limits;
  std::uint64_t seed = 1;
  Disk disk{};                                  ///< stored before a restart
  std::map<MemberNumber, std::string> names{};  ///< of members, for texts that people read
};

// ---- inputs ----
struct Heard {
  MemberNumber from;
  TeamMessage message;
};
struct MissionGiven {
  GivenMission mission;
};
struct TaskDone {
  TaskNumber task;
};
/// A running task failed, or this member puts an owned task back on sale.
struct TaskPutBack {
  TaskNumber task;
  std::string why{};
};
/// Whether this member bids from now on (initially: if it has a craft). A member that stops bidding
/// keeps its tasks until it puts them back.
struct Bids {
  bool bids = true;
};
/// The operator declares a member lost for good. If that is wrong, tasks granted to it may be done
/// twice.
struct DeclaredLost {
  MemberNumber member;
};
/// The operator takes that back: it counts again, and is sold to again.
struct DeclaredFound {
  MemberNumber member;
};
struct Tick {};
using TeamInput = std::variant<Heard, MissionGiven, TaskDone, TaskPutBack, Bids, DeclaredLost,
                               DeclaredFound, Tick>;

// ---- effects ----
struct Tell {
  MemberNumber to;
  TeamMessage message;
};
struct Store {
  Disk disk;
};
struct BeginTask {
  Claim claim;
};
struct TokenTaken {
  std::uint64_t term = 0;
};
struct TokenLost {};
/// An event of a sale that this member holds: Sold, Unsold, Dropped or Rejected.
struct SaleTold {
  SaleEffect what;
};
/// This member's bids in the first round of a sale, or its reasons for none.
struct Offered {
  Offer offer;
};
using TeamEffect = std::variant<Tell, Store, BeginTask, TokenTaken, TokenLost, SaleTold, Offered>;
using TeamEffects = std::vector<TeamEffect>;

/// Bids for tasks, owns them and, while it holds the token, sells them. Does not depend on
/// synchronised clocks: a task is begun only under a committed grant (stored by a majority), and
/// only the grantees can give a grant back. Source: spec 6.3.
class TeamMember {
 public:
  explicit TeamMember(TeamSetup setup);
  ~TeamMember();
  TeamMember(TeamMember&&) noexcept;
  TeamMember& operator=(TeamMember&&) noexcept;

  TeamEffects handle(const TeamInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool holds_token() const;
  /// Whether these members and this one are most of those that are not declared lost: nothing is
  /// sold or granted without so many.
  bool are_most(const std::set<MemberNumber>& members) const;
  /// Whether this member's part of the claim is over: done, or put back.
  bool has_ended(const Claim& claim) const;
  /// The last ledger received; its newest revision may not be committed yet.
  const Ledger& ledger() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::auction
