// SPDX-License-Identifier: Apache-2.0
// Who has what: the one book of the team, and what its members say to each other about it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/message.hpp"

namespace skein::auction {

using MissionNumber = Id<struct MissionNumberTag, std::uint64_t>;

/// | stage   | means                                              | to |
/// |---------|----------------------------------------------------|-----------------------------------|
/// | forsale | nobody's                                           | owned, unsold | | owned   |
/// sold; may be traded, or sold again if its owner is silent beyond its lease | granted, for sale |
/// | granted | its owners may begin: it may have been done        | done; for sale once they said
/// that they stopped | | done    | all its owners said so                             | | | unsold
/// | nobody can                                         | for sale, when somebody comes     |
enum class Stage : std::uint8_t { kForSale, kOwned, kGranted, kDone, kUnsold };

struct LedgerEntry {
  Task task;  ///< times from the epoch of the mission [s]
  Stage stage = Stage::kForSale;
  std::vector<MemberNumber> owners;
  std::uint64_t sale = 0;           ///< strictly rising: a grant and a report name theirs
  std::set<MemberNumber> finished;  ///< owners that said that they are done
  std::set<MemberNumber> stopped;   ///< owners that said that they will not, or not any more
  std::uint64_t revision = 0;       ///< of the ledger, when this last changed
  std::string why;                  ///< of the stage, for people: bids, silence, put back by whom
};

/// The state on which the team agrees. The holder of the token alone changes it; what a majority
/// has is committed, and no later holder can be without it. Source: [Ongaro, Ousterhout 2014], with
/// the whole state in place of a log.
struct Ledger {
  std::uint64_t term = 0;      ///< of the token that wrote it
  std::uint64_t revision = 0;  ///< strictly rising
  std::set<MissionNumber> missions;
  std::map<TaskNumber, LedgerEntry> entries;
  std::vector<Precedence> precedences;
  std::map<MemberNumber, std::vector<TaskNumber>> routes;
  std::set<MemberNumber> lost;  ///< so declared by the operator: they count no more
};

/// A global mission; its number is the same however often and to whomever it is given.
struct GivenMission {
  MissionNumber number;
  Lot lot;
};

/// A task under one sale of it.
struct Claim {
  TaskNumber task;
  std::uint64_t sale = 0;
  auto operator<=>(const Claim&) const = default;
};

/// Holder to all, regularly and whenever something changed.
struct Beat {
  std::uint64_t term = 0;
  std::uint64_t committed = 0;           ///< a majority has this revision
  std::shared_ptr<const Ledger> ledger;  ///< none: the receiver said that it has it
};

/// Member to holder, answering a beat: what it has, and everything that it wants the ledger to say.
/// Said until the ledger says so: nothing is lost with a message.
struct Status {
  std::uint64_t term = 0;
  std::uint64_t revision = 0;
  std::vector<Claim> wants;  ///< a go-ahead
  std::vector<Claim> done;
  std::vector<Claim> stopped;  ///< not begun, or begun and given up
  std::vector<GivenMission> missions;
  std::set<MemberNumber> lost;
  bool bids = true;                      ///< else it votes only, and keeps what it has begun
  std::vector<std::string> stopped_why;  ///< of each that stopped; for people
};

/// Who would hold the token asks; `trial` asks without consequence, so that one who was cut off
/// does not disturb the others.
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

/// To whom asked for votes or beat in an older term: without it, one with the newer term and one
/// with the newer ledger would refuse each other for ever.
struct NewerTerm {
  std::uint64_t term = 0;
};

using TeamMessage =
    std::variant<Beat, Status, VoteRequest, Vote, NewerTerm, ToMember, ToAuctioneer>;

}  // namespace skein::auction
