// SPDX-License-Identifier: Apache-2.0
// The ledger of the team's tasks and their owners, and the messages that replicate it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/losses.hpp"
#include "skein/auction/message.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

using MissionNumber = Id<struct MissionNumberTag, std::uint64_t>;

/// The life cycle of a task in the ledger.
enum class Stage : std::uint8_t {
  kForSale,  ///< no owner; next: owned, unsold
  /// Sold. May be traded, and is sold again if its owner is silent beyond the lease; next: granted,
  /// for sale.
  kOwned,
  /// Its owners may begin it, so it may have been done; next: done, or for sale once they have
  /// reported that they stopped.
  kGranted,
  kDone,   ///< all of its owners reported it done
  kUnsold  ///< no member can do it; next: for sale, when a member joins
};

struct LedgerEntry {
  /// Times from the epoch of the mission [s]. Of what follows a task that is done, by a delay with
  /// bounds, they are those that the end of that leaves.
  Task task;
  Stage stage = Stage::kForSale;
  std::vector<MemberNumber> owners;
  std::uint64_t sale = 0;           ///< strictly increasing; grants and reports refer to it
  std::set<MemberNumber> finished;  ///< owners that reported the task done
  std::set<MemberNumber> stopped;   ///< owners that will not do it, or have given it up
  std::uint64_t revision = 0;       ///< of the ledger, at the last change of this entry
  std::string why;                  ///< reason of the stage, for people: bids, silence, put back
};

/// The replicated state of the team. Only the holder of the token changes it. A revision that a
/// majority has stored is committed: every later holder has it. Source: [Ongaro, Ousterhout 2014]
/// (Raft), with the whole state in place of a log.
struct Ledger {
  std::uint64_t term = 0;      ///< the term in which the holder wrote it
  std::uint64_t revision = 0;  ///< strictly increasing
  std::set<MissionNumber> missions;
  std::map<TaskNumber, LedgerEntry> entries;
  std::vector<Precedence> precedences;
  std::map<MemberNumber, std::vector<TaskNumber>> routes;
  Losses losses;  ///< who is declared lost by the operator is not counted, and is sold nothing
};

/// A global mission. The number identifies it, however often and to whichever member it is given.
struct GivenMission {
  MissionNumber number;
  Lot lot;
};

/// A task together with the sale under which a member owns it.
struct Claim {
  TaskNumber task;
  std::uint64_t sale = 0;
  auto operator<=>(const Claim&) const = default;
};

/// What a member has done under a claim, and when that ended by its clock.
struct DoneClaim {
  Claim claim;
  MissionTime at;
  bool operator==(const DoneClaim&) const = default;
};

/// From the token's holder to all members, periodically and after every change.
struct Beat {
  std::uint64_t term = 0;
  std::uint64_t committed = 0;           ///< the newest revision that a majority has
  std::shared_ptr<const Ledger> ledger;  ///< none: the receiver has reported this revision already
};

/// From a member to the holder, in answer to a beat: the revision that it has of this term (0:
/// none), and all changes that it wants in the ledger. Each is repeated until the ledger shows it,
/// so lost messages do no harm.
struct Status {
  std::uint64_t term = 0;
  std::uint64_t revision = 0;
  std::vector<Claim> wants;  ///< asks for the grant to begin these
  std::vector<DoneClaim> done;
  std::vector<Claim> stopped;  ///< will not begin them, or has given them up
  std::vector<GivenMission> missions;
  Losses losses;
  bool bids = true;                      ///< false: it only votes, and keeps what it has begun
  std::vector<std::string> stopped_why;  ///< the reason of each of `stopped`, for people
};

/// From a candidate for the token. With `trial` (Raft's pre-vote) the vote has no effect, so that a
/// member that was cut off does not disturb the others when it is back.
struct VoteRequest {
  std::uint64_t term = 0;
  bool trial = false;
  std::uint64_t ledger_term = 0;
  std::uint64_t ledger_revision = 0;
};
struct Vote {
  std::uint64_t term = 0;
  bool trial = false;
};

/// Answer to a vote request or beat of an older term. Without it a member with a newer term and one
/// with a newer ledger would refuse each other for ever.
struct NewerTerm {
  std::uint64_t term = 0;
};

using TeamMessage =
    std::variant<Beat, Status, VoteRequest, Vote, NewerTerm, ToMember, ToAuctioneer>;

}  // namespace skein::auction
