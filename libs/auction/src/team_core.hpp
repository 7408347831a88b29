// SPDX-License-Identifier: Apache-2.0
// The inside of a team member: token, ledger, sales, own work.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

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
  bool has_ended(const Claim& claim) const;

 private:
  enum class Role { kFollower, kCandidate, kHolder };
  struct Known {
    MissionTime heard;
    std::uint64_t revision = 0;  ///< the greatest that it had
    std::uint64_t last = 0;      ///< as last said: less, once it forgot
    bool bids = true;
    std::optional<Status> news;  ///< not yet looked at
  };
  // A sale held here, and what the ledger was when it began.
  struct Sale {
    Auctioneer auctioneer;
    std::uint64_t revision;
    std::set<MemberNumber> participants;
    std::map<TaskNumber, std::string> why;
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
  bool all_before_done(const LedgerEntry& entry) const;
  void resell();
  void put_up(LedgerEntry& entry, std::string why);
  LedgerEntry& change(TaskNumber task);
  Ledger& draft();

  // selling.cpp
  void sell();
  bool worth_selling(const std::set<MemberNumber>& present) const;
  std::set<MemberNumber> present() const;
  bool all_know_what_is_for_sale(const std::set<MemberNumber>& present) const;
  Lot lot_for_sale() const;
  Lot sound_lot();
  ToAuctioneer answer(const ToMember& call);
  void answer_own_calls();
  Holding holding(MemberNumber member) const;
  void take(SaleEffects effects);
  void explain(const SaleEffect& effect);
  void book_sale();

  // work.cpp: what it does of its own
  void work();
  Status status() const;
  std::vector<Claim> wants() const;
  bool mine(const LedgerEntry& entry) const;
  bool ended(const LedgerEntry& entry) const;
  void give_up_claims();
  void store() { stored_ = true; }
  void tell(MemberNumber to, TeamMessage message);
  void put_back(const TaskPutBack& back);
  std::string name(MemberNumber member) const;
  std::string names(const std::vector<MemberNumber>& members) const;

  TeamSetup setup_;
  Disk disk_;
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
  std::optional<Sale> sale_;
  std::uint64_t sales_ = 0;
  /// With which it bids in one sale: from where it was when that began, since in flight every round
  /// would look like a gain, and the sale would not end.
  struct Bidding {
    SaleNumber sale;
    std::unique_ptr<const Craft> craft;
  };
  std::optional<Bidding> bidding_;
  std::deque<ToMember> own_calls_;  ///< of the sale held here
  std::optional<Claim> running_;
  std::optional<MissionTime> idle_since_;
  std::map<MemberNumber, std::vector<Claim>> wants_;  ///< as last said
  std::set<MemberNumber> declared_lost_;
  bool stored_ = false, started_ = false, bids_ = true;
  TeamEffects effects_;
};

}  // namespace skein::auction
