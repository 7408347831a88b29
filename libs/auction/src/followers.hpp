// SPDX-License-Identifier: Apache-2.0
// What the holder of the token knows of the other members, and tells them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "skein/foundation/repeats.hpp"

namespace skein::auction {

/// By their statuses, while it holds the token. A value.
class Followers {
 public:
  void hear(MemberNumber member, const Status& status, MissionTime now);
  bool has_heard(MemberNumber member) const { return known_.contains(member); }
  /// When a member was heard last; absent: never.
  std::optional<MissionTime> heard(MemberNumber member) const;
  std::set<MemberNumber> heard_since(MissionTime since) const;
  /// Those of them that bid.
  std::set<MemberNumber> bidding_since(MissionTime since) const;
  /// Whether a member has had this revision of the ledger, or a later one.
  bool has(MemberNumber member, std::uint64_t revision) const;
  std::set<MemberNumber> with(std::uint64_t revision) const;
  /// The latest revision of each, in the order of the members.
  std::vector<std::uint64_t> revisions() const;
  /// The last status of each that was heard since the last call.
  std::vector<std::pair<MemberNumber, Status>> take_news();
  /// Whether a member that has not this revision is told the ledger in this beat. Whoever does not
  /// answer for longer than a beat is told it ever more rarely: perhaps its channel carries no
  /// more, and would be full of ledgers that come too late.
  bool is_told(MemberNumber member, std::uint64_t revision, MissionTime now, Duration beat);

 private:
  struct Known {
    MissionTime heard;
    std::uint64_t revision = 0;  ///< greatest ledger revision that the member reported
    std::uint64_t last = 0;      ///< last reported one: less if it restarted without its disk
    bool bids = true;
    std::optional<Status> news;  ///< last status that is not yet in the ledger
  };
  /// The ledger as a member was told it, which has not said that it has it.
  struct Telling {
    std::uint64_t revision = 0;
    Repeats again;
  };
  std::map<MemberNumber, Known> known_;
  std::map<MemberNumber, Telling> told_;
};

}  // namespace skein::auction
