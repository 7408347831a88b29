// SPDX-License-Identifier: Apache-2.0
// Implementation of TeamMember: token, ledger and sales. Its own tasks run in OwnWork.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "followers.hpp"
#include "held_sale.hpp"
#include "kept_back.hpp"
#include "own_work.hpp"
#include "skein/auction/bidder.hpp"
#include "skein/auction/team_member.hpp"
#include "skein/foundation/random.hpp"
#include "task_ends.hpp"

namespace skein::auction {

/// Roles, and the events that change them (election as in Raft, with a pre-vote):
/// - follower to candidate: no beat of the holder for TeamLimits::patience; asks for trial votes,
///   which do not change terms.
/// - candidate on trial to candidate: a majority would vote for it; asks for votes in a new term.
/// - candidate to holder: a majority has voted for it; it continues the ledger in its term.
/// - any to follower: a message of a higher term.
/// - holder to follower: no messages of a majority for TeamLimits::patience.
class TeamMember::Core {
 public:
  explicit Core(TeamSetup setup);
  TeamEffects handle(const TeamInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool holds_token() const { return role_ == Role::kHolder; }
  const Ledger& ledger() const { return *disk_.ledger; }
  bool has_ended(const Claim& claim) const { return own_.has_ended(claim); }
  bool majority(const std::set<MemberNumber>& members) const;

 private:
  enum class Role { kFollower, kCandidate, kHolder };
  // token.cpp
  void on(const Beat& beat, MemberNumber from);
  void on(const Status& status, MemberNumber from);
  void on(const VoteRequest& request, MemberNumber from);
  void on(const Vote& vote, MemberNumber from);
  void on(const NewerTerm& newer, MemberNumber from);
  void on(const ToMember& call, MemberNumber from);
  void on(const ToAuctioneer& answer, MemberNumber from);
  void adopt_term(std::uint64_t term);
  void follow();
  void stand(bool trial);
  void hold();
  void beat();
  void commit();

  // keeping.cpp: changes that the holder makes to the ledger
  void keep_ledger();
  void take_status(MemberNumber member, const Status& status);
  void admit(const GivenMission& mission);
  void end_claims(MemberNumber member, const Status& status);
  void settle(LedgerEntry& entry, const std::string& why);
  void grant();
  bool may_begin(const LedgerEntry& entry) const;
  void resell();
  LedgerEntry& change(TaskNumber task);
  Ledger& draft();

  // selling.cpp
  void sell();
  std::set<MemberNumber> present() const;
  bool is_to_sell(const std::set<MemberNumber>& here) const;
  Lot sound_lot();
  std::optional<ToAuctioneer> answer(const ToMember& call);
  void answer_calls();
  void take(SaleEffects effects);
  void book_sale();

  Status status() const;
  void tell(MemberNumber to, TeamMessage message);

  TeamSetup setup_;
  Disk disk_;
  OwnWork own_;  ///< works on disk_
  std::vector<MemberNumber> others_;
  MemberNames names_;
  Random random_;
  Role role_ = Role::kFollower;
  MissionTime now_;
  MissionTime stand_at_, beat_at_;
  MissionTime held_since_, rest_until_, retry_at_;
  std::optional<MissionTime> last_beat_;
  bool trial_ = false;
  std::set<MemberNumber> votes_;
  Followers followers_;  ///< since it holds the token
  std::uint64_t committed_ = 0;
  bool changed_ = false;
  std::set<MemberNumber> took_part_;  ///< members of the last sale that this member held
  std::optional<HeldSale> sale_;
  std::uint64_t sales_ = 0;
  /// The craft with which this member bids during one sale. It starts at the vehicle's position
  /// when the sale began: with the current position of a vehicle in flight every round would look
  /// like a gain, and the sale would not end.
  struct Bidding {
    SaleNumber sale;
    std::shared_ptr<const Catalogue> lot;
    MissionTime since;                   ///< without a craft since then
    std::unique_ptr<const Craft> craft;  ///< none: not made yet
  };
  std::optional<Bidding> bidding_;
  std::optional<std::pair<MemberNumber, ToMember>> kept_call_;  ///< of another, without a craft yet
  std::deque<ToMember> own_calls_;                    ///< from the own auctioneer to this member
  std::map<MemberNumber, std::vector<Claim>> wants_;  ///< last claims of each member
  TaskEnds task_ends_;
  KeptBack kept_back_;
  Losses losses_;  ///< what this member was told by an operator, and knew then
  bool stored_ = false, started_ = false, bids_ = true;
  TeamEffects effects_;
};

}  // namespace skein::auction
