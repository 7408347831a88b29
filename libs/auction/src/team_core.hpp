// SPDX-License-Identifier: Apache-2.0
// The inside of a team member: token, ledger, sales. Its own work is OwnWork.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "held_sale.hpp"
#include "own_work.hpp"
#include "skein/auction/bidder.hpp"
#include "skein/auction/team_member.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

/// Follower, without a beat for its patience: candidate, asking on trial.
/// Candidate, if a majority would vote for it: asks in earnest.
/// Candidate, once a majority voted for it: holder, with a ledger of its term.
/// Anyone who hears of a higher term: follower.
/// Holder that hears no majority for its patience: follower.
class TeamMember::Core {
 public:
  explicit Core(TeamSetup setup);
  TeamEffects handle(const TeamInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool holds_token() const { return role_ == Role::kHolder; }
  const Ledger& ledger() const { return *disk_.ledger; }
  bool has_ended(const Claim& claim) const { return own_.has_ended(claim); }

 private:
  enum class Role { kFollower, kCandidate, kHolder };
  struct Known {
    MissionTime heard;
    std::uint64_t revision = 0;  ///< the greatest that it had
    std::uint64_t last = 0;      ///< as last said: less, once it forgot
    bool bids = true;
    std::optional<Status> news;  ///< not yet looked at
  };

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
  void let_go_of_missions();
  bool majority(const std::set<MemberNumber>& members) const;
  std::set<MemberNumber> heard_since(MissionTime since) const;
  std::vector<MemberNumber> others() const;

  // keeping.cpp: what a holder does to the ledger
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
  bool is_listening() const;
  bool is_to_sell(const std::set<MemberNumber>& here) const;
  Lot sound_lot();
  ToAuctioneer answer(const ToMember& call);
  void answer_own_calls();
  void take(SaleEffects effects);
  void book_sale();

  Status status() const;
  void tell(MemberNumber to, TeamMessage message);

  TeamSetup setup_;
  Disk disk_;
  OwnWork own_;  ///< by that disk
  MemberNames names_;
  Random random_;
  Role role_ = Role::kFollower;
  MissionTime now_;
  MissionTime stand_at_, beat_at_;
  MissionTime held_since_, rest_until_, retry_at_;
  std::optional<MissionTime> last_beat_;
  bool trial_ = false;
  std::set<MemberNumber> votes_;
  std::map<MemberNumber, Known> known_;
  std::uint64_t committed_ = 0;
  bool changed_ = false;
  std::set<MemberNumber> took_part_;  ///< in the last sale held here
  std::optional<HeldSale> sale_;
  std::uint64_t sales_ = 0;
  /// With which it bids in one sale: from where it was when that began, since in flight every round
  /// would look like a gain, and the sale would not end.
  struct Bidding {
    SaleNumber sale;
    std::unique_ptr<const Craft> craft;
  };
  std::optional<Bidding> bidding_;
  std::deque<ToMember> own_calls_;                    ///< of the sale held here
  std::map<MemberNumber, std::vector<Claim>> wants_;  ///< as last said
  std::set<MemberNumber> declared_lost_;
  bool stored_ = false, started_ = false, bids_ = true;
  TeamEffects effects_;
};

}  // namespace skein::auction
