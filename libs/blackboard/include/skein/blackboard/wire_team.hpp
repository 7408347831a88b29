// SPDX-License-Identifier: Apache-2.0
// Slots of class event with which a team shares out its missions. What the fields
// mean is said where they come from: skein/auction/ledger.hpp and message.hpp. Members are numbered
// by the team's roster. Source: spec 6.3.
// Written by idl/generate_wire.py from idl/event.idl: change that, and run it.
// clang-format off
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

enum class TeamStage : std::uint32_t {
  kForSale,
  kOwned,
  kGranted,
  kDone,
  kUnsold,
  kCount
};
constexpr auto names_of(TeamStage) {
  return std::to_array<std::string_view>({"for-sale", "owned", "granted", "done", "unsold"});
}

enum class TeamNeedForm : std::uint32_t {
  kNeedLess,
  kNeedAtMost,
  kNeedEqual,
  kNeedAtLeast,
  kNeedGreater,
  kNeedValue,
  kNeedAny,
  kCount
};
constexpr auto names_of(TeamNeedForm) {
  return std::to_array<std::string_view>({"need-less", "need-at-most", "need-equal",
    "need-at-least", "need-greater", "need-value", "need-any"});
}

/// Of each member: skein/interaction/requirement.hpp.
struct TeamNeed {
  std::string capability;
  TeamNeedForm form = TeamNeedForm::kNeedLess;
  std::string value;  ///< kNeedValue
  double figure = 0;  ///< of a relation
  bool operator==(const TeamNeed&) const = default;
};
SKEIN_WIRE_FIELDS(TeamNeed, capability, form, value, figure)

/// A task on sale. Times in s: in the ledger from the epoch, in a sale from its beginning.
struct TeamTask {
  std::uint32_t number = 0;
  double duration = 0;  ///< [s]
  std::uint64_t needs = 0;
  std::uint64_t needs_each = 0;
  std::uint32_t least_members = 1;
  double earliest = 0;  ///< [s]
  bool has_deadline = false;
  double deadline = 0;  ///< [s]
  double x = 0;  ///< [m] ENU
  double y = 0;  ///< [m] ENU
  std::vector<std::uint32_t> pinned;  ///< none or one
  std::vector<std::uint32_t> forbidden;
  bool repeatable = false;
  std::vector<MissionTask> work;  ///< none (in sales) or one
  std::string asked_by;
  std::vector<TeamNeed> needs_of_work;  ///< none in sales
  bool operator==(const TeamTask&) const = default;
};
SKEIN_WIRE_FIELDS(TeamTask, number, duration, needs, needs_each, least_members, earliest,
    has_deadline, deadline, x, y, pinned, forbidden, repeatable, work, asked_by, needs_of_work)

/// `first` ends before `after` begins.
struct TeamPrecedence {
  std::uint32_t first = 0;
  std::uint32_t after = 0;
  bool operator==(const TeamPrecedence&) const = default;
};
SKEIN_WIRE_FIELDS(TeamPrecedence, first, after)

struct TeamEntry {
  TeamTask task;
  TeamStage stage = TeamStage::kForSale;
  std::vector<std::uint32_t> owners;
  std::uint64_t sale = 0;
  std::vector<std::uint32_t> finished;
  std::vector<std::uint32_t> stopped;
  std::uint64_t revision = 0;
  std::string why;
  bool operator==(const TeamEntry&) const = default;
};
SKEIN_WIRE_FIELDS(TeamEntry, task, stage, owners, sale, finished, stopped, revision, why)

struct TeamRoute {
  std::uint32_t member = 0;
  std::vector<std::uint32_t> tasks;
  bool operator==(const TeamRoute&) const = default;
};
SKEIN_WIRE_FIELDS(TeamRoute, member, tasks)

struct TeamLoss {
  std::uint32_t member = 0;
  std::uint32_t turns = 0;  ///< declared lost, found again, …: odd while it is lost
  bool operator==(const TeamLoss&) const = default;
};
SKEIN_WIRE_FIELDS(TeamLoss, member, turns)

struct TeamLedger {
  std::uint64_t term = 0;
  std::uint64_t revision = 0;
  std::vector<std::uint64_t> missions;
  std::vector<TeamEntry> entries;
  std::vector<TeamPrecedence> precedences;
  std::vector<TeamRoute> routes;
  std::vector<TeamLoss> losses;
  bool operator==(const TeamLedger&) const = default;
};
SKEIN_WIRE_FIELDS(TeamLedger, term, revision, missions, entries, precedences, routes, losses)

struct TeamClaim {
  std::uint32_t task = 0;
  std::uint64_t sale = 0;
  std::string why;  ///< it was put back
  bool operator==(const TeamClaim&) const = default;
};
SKEIN_WIRE_FIELDS(TeamClaim, task, sale, why)

/// Done under a claim.
struct TeamEnd {
  std::uint32_t task = 0;
  std::uint64_t sale = 0;
  std::int64_t at = 0;  ///< [ns] of the mission
  bool operator==(const TeamEnd&) const = default;
};
SKEIN_WIRE_FIELDS(TeamEnd, task, sale, at)

struct TeamMission {
  std::uint64_t number = 0;
  std::vector<TeamTask> tasks;
  std::vector<TeamPrecedence> precedences;
  bool operator==(const TeamMission&) const = default;
};
SKEIN_WIRE_FIELDS(TeamMission, number, tasks, precedences)

enum class TeamWord : std::uint32_t {
  kBeat,
  kStatus,
  kVoteRequest,
  kVote,
  kNewerTerm,
  kCount
};
constexpr auto names_of(TeamWord) {
  return std::to_array<std::string_view>({"beat", "status", "vote-request", "vote", "newer-term"});
}

/// About the token and the ledger.
struct TeamMessage {
  SampleHeader header;
  TeamWord word = TeamWord::kBeat;
  std::uint64_t term = 0;
  /// kBeat: what is committed; kStatus: what it has; kVoteRequest: of its ledger.
  std::uint64_t revision = 0;
  std::vector<TeamLedger> ledger;  ///< kBeat: none (the receiver has it) or one
  bool bids = false;  ///< this and what follows: kStatus
  std::vector<TeamClaim> wants;
  std::vector<TeamEnd> done;
  std::vector<TeamClaim> stopped;
  std::vector<TeamMission> missions;
  std::vector<TeamLoss> losses;
  bool trial = false;  ///< kVoteRequest, kVote
  std::uint64_t ledger_term = 0;  ///< kVoteRequest
  bool operator==(const TeamMessage&) const = default;
};
SKEIN_WIRE_FIELDS(TeamMessage, header, word, term, revision, ledger, bids, wants, done, stopped,
    missions, losses, trial, ledger_term)

struct TeamLeg {
  double seconds = 0;
  double cost = 0;
  double energy = 0;  ///< [J]
  bool operator==(const TeamLeg&) const = default;
};
SKEIN_WIRE_FIELDS(TeamLeg, seconds, cost, energy)

struct TeamGap {
  std::uint32_t gap = 0;
  TeamLeg way_in;
  TeamLeg way_out;
  bool operator==(const TeamGap&) const = default;
};
SKEIN_WIRE_FIELDS(TeamGap, gap, way_in, way_out)

struct TeamPrice {
  std::uint32_t item = 0;
  double energy = 0;  ///< [J]
  std::vector<TeamGap> gaps;
  std::string objection;
  bool operator==(const TeamPrice&) const = default;
};
SKEIN_WIRE_FIELDS(TeamPrice, item, energy, gaps, objection)

enum class TeamSaleWord : std::uint32_t {
  kCall,
  kAward,
  kOffer,
  kAnswer,
  kCount
};
constexpr auto names_of(TeamSaleWord) {
  return std::to_array<std::string_view>({"call", "award", "offer", "answer"});
}

/// What auctioneer and bidders say to each other.
struct TeamSale {
  SampleHeader header;
  TeamSaleWord word = TeamSaleWord::kCall;
  std::uint64_t sale = 0;
  std::uint32_t round = 0;
  std::vector<TeamTask> tasks;  ///< kCall, kAward: the lot
  std::vector<TeamPrecedence> precedences;
  std::vector<std::uint32_t> route;
  std::uint32_t fixed_tasks = 0;  ///< kCall, as the next three
  std::vector<std::uint32_t> items;
  std::uint32_t gaps = 0;
  bool between = false;
  std::uint64_t abilities = 0;  ///< kOffer
  double free_from = 0;  ///< kOffer [s]
  double energy = 0;  ///< kOffer, kAnswer [J]
  std::vector<TeamLeg> legs;  ///< kOffer, kAnswer
  std::vector<TeamPrice> prices;  ///< kOffer
  std::vector<TeamLeg> ways;  ///< kOffer: between items
  bool refused = false;  ///< kAnswer
  std::string why;
  bool operator==(const TeamSale&) const = default;
};
SKEIN_WIRE_FIELDS(TeamSale, header, word, sale, round, tasks, precedences, route, fixed_tasks,
    items, gaps, between, abilities, free_from, energy, legs, prices, ways, refused, why)

}  // namespace skein::wire
