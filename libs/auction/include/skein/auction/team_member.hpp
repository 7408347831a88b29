// SPDX-License-Identifier: Apache-2.0
// One member of a team that shares out its missions.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/ledger.hpp"

namespace skein::auction {

struct TeamLimits {
  Duration beat = Duration::milliseconds(500);
  Duration patience = Duration::seconds(2);  ///< without a beat, then up to as much again by chance
  /// Silence after which what somebody has not been granted is sold again. What it was granted
  /// waits until it is heard or declared lost, unless the task is repeatable: this is what
  /// at-most-once costs under a partition.
  Duration lease = Duration::seconds(10);
  std::uint32_t ahead = 1;  ///< tasks granted to a member at a time: what it may do when cut off
  Aim aim{0.5};
  SaleLimits sale{};
};

/// What a member keeps through a crash. Stored before anything that follows in the effects is done.
struct Disk {
  std::uint64_t term = 0;
  bool voted = false;  ///< in that term
  std::shared_ptr<const Ledger> ledger;
  std::map<TaskNumber, std::uint64_t> started;  ///< the last sale under which it began
  std::map<TaskNumber, std::uint64_t> done;
  std::map<TaskNumber, std::uint64_t> stopped;
  std::map<TaskNumber, std::string> stopped_why;
  std::vector<GivenMission> missions;  ///< given here, not yet known to be with a majority
};

/// The craft with which to bid in a sale whose times count from `origin`.
using CraftMaker = std::function<std::unique_ptr<const Craft>(
    std::shared_ptr<const Catalogue> catalogue, MissionTime origin)>;

struct TeamSetup {
  MemberNumber self;
  std::vector<MemberNumber> roster;  ///< all that vote, itself among them
  CraftMaker craft;                  ///< none: votes only, as the ground station does
  TeamLimits limits;
  std::uint64_t seed = 1;
  Disk disk{};                                  ///< of before a restart
  std::map<MemberNumber, std::string> names{};  ///< of members in what is said to people
};

// What comes in.
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
/// What runs failed, or what is owned is put back on sale.
struct TaskPutBack {
  TaskNumber task;
  std::string why{};
};
/// Whether it takes part in sales from now on; at first, if it has a craft. Who does not keeps what
/// it owns until it puts that back.
struct Bids {
  bool bids = true;
};
/// The operator says that a member will never be heard again. Said wrongly, what it was granted may
/// be done twice.
struct DeclaredLost {
  MemberNumber member;
};
struct Tick {};
using TeamInput =
    std::variant<Heard, MissionGiven, TaskDone, TaskPutBack, Bids, DeclaredLost, Tick>;

// What goes out.
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
/// Of a sale held here: Sold, Unsold, Dropped, Rejected.
struct SaleTold {
  SaleEffect what;
};
/// What this member offered in the first round of a sale: its bids, or why it makes none.
struct Offered {
  Offer offer;
};
using TeamEffect = std::variant<Tell, Store, BeginTask, TokenTaken, TokenLost, SaleTold, Offered>;
using TeamEffects = std::vector<TeamEffect>;

/// Bids, owns and, when it holds the token, sells. Without dependence on clocks that agree: a task
/// is begun only under a grant that a majority has, and a grant is taken back only by those it was
/// given to. Source: spec 6.3.
class TeamMember {
 public:
  explicit TeamMember(TeamSetup setup);
  ~TeamMember();
  TeamMember(TeamMember&&) noexcept;
  TeamMember& operator=(TeamMember&&) noexcept;

  TeamEffects handle(const TeamInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool holds_token() const;
  /// Whether its own part of the claim is over: done, or put back.
  bool has_ended(const Claim& claim) const;
  /// As last heard; the newest part of it may not be committed.
  const Ledger& ledger() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::auction
