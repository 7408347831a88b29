// SPDX-License-Identifier: Apache-2.0
// Sales held by the holder of the token.
#include <algorithm>

#include "for_sale.hpp"
#include "skein/auction/lateness.hpp"
#include "team_core.hpp"

namespace skein::auction {

namespace {

constexpr std::int64_t kRetryLeases = 6;  // until what nobody could do is called again

// Of who has no vehicle.
class NoCraft : public Craft {
 public:
  Abilities abilities() const override { return 0; }
  std::optional<Leg> leg(Stopover, Stopover) const override { return Leg{}; }
  std::optional<std::string> objection(const Task&) const override { return "it has no vehicle"; }
};

// Times of a sale count from its beginning; people are told those of the mission.
Lot in_mission_time(Lot lot, MissionTime begun) {
  for (Task& task : lot.tasks) {
    task.earliest += begun.to_seconds();
    task.deadline += begun.to_seconds();
  }
  return lot;
}

// Two who hold a token in one term, as members wrongly declared lost make possible, give two sales
// one number.
bool same_tasks(const Catalogue& one, const Catalogue& other) {
  return &one == &other ||
         std::ranges::equal(one.lot().tasks, other.lot().tasks, {}, &Task::number, &Task::number);
}

// The own auctioneer says again what is not answered.
bool waits(const std::deque<ToMember>& calls, const ToMember& call) {
  const auto round_of = [](const ToMember& said) {
    return std::visit([](const auto& one) { return std::pair(one.sale, one.round); }, said);
  };
  return std::any_of(calls.begin(), calls.end(), [&](const ToMember& kept) {
    return kept.index() == call.index() && round_of(kept) == round_of(call);
  });
}

}  // namespace

// Who was heard lately and bids.
std::set<MemberNumber> TeamMember::Core::present() const {
  std::set<MemberNumber> members = followers_.bidding_since(now_ - setup_.limits.patience);
  if (bids_) members.insert(setup_.self);
  std::erase_if(members, [this](MemberNumber member) { return ledger().losses.is_lost(member); });
  return members;
}

// Something has no owner, or somebody is there that the last sale was without; and who bids has
// been told what the tasks are: the ledger says it, calls do not.
bool TeamMember::Core::is_to_sell(const std::set<MemberNumber>& here) const {
  const auto any_unheard = [this] {
    return std::any_of(others_.begin(), others_.end(), [this](MemberNumber member) {
      return !followers_.has_heard(member) && !ledger().losses.is_lost(member);
    });
  };
  // Who has just taken the token has heard nobody: all have the time of a beat to answer its first.
  if (now_ < held_since_ + setup_.limits.beat && any_unheard()) return false;
  const auto is_new = [this](MemberNumber member) { return !took_part_.contains(member); };
  const bool joined = now_ >= rest_until_ && std::any_of(here.begin(), here.end(), is_new);
  if (here.empty() || !worth_selling(ledger(), joined, now_ >= retry_at_, now_)) return false;
  const std::uint64_t newest = newest_for_sale(ledger());
  return std::all_of(here.begin(), here.end(), [&](MemberNumber member) {
    return member == setup_.self || followers_.has(member, newest);
  });
}

// None: the craft for its sale is not there yet.
std::optional<ToAuctioneer> TeamMember::Core::answer(const ToMember& call) {
  const auto [sale, lot] =
      std::visit([](const auto& message) { return std::pair(message.sale, message.lot); }, call);
  if (!bidding_ || bidding_->sale != sale || !same_tasks(*bidding_->lot, *lot)) {
    const bool is_waiting = bidding_ && bidding_->craft == nullptr;
    bidding_ = Bidding{sale, lot, is_waiting ? bidding_->since : now_, nullptr};
  }
  if (bidding_->craft == nullptr) {
    bidding_->craft =
        setup_.craft ? setup_.craft(lot, bidding_->since) : std::make_unique<const NoCraft>();
  }
  if (bidding_->craft == nullptr) return std::nullopt;
  ToAuctioneer said = Bidder(setup_.self, *bidding_->craft).handle(call);
  const auto* offer = std::get_if<Offer>(&said);
  if (offer != nullptr && offer->round == 1) effects_.emplace_back(Offered{*offer});
  return said;
}

// The own ones one after the other: a team of one sells a whole lot without a message.
void TeamMember::Core::answer_calls() {
  if (kept_call_) {
    if (auto said = answer(kept_call_->second)) {
      tell(kept_call_->first, std::move(*said));
      kept_call_.reset();
    }
  }
  while (sale_ && !own_calls_.empty()) {
    const auto said = answer(own_calls_.front());
    if (!said) break;
    own_calls_.pop_front();
    take(sale_->auctioneer.handle(*said, now_));
  }
  if (!sale_) own_calls_.clear();
  if (role_ == Role::kHolder && changed_) {
    commit();
    beat();
    changed_ = false;
  }
}

// What cannot be done any more whoever does it is taken out, and told.
Lot TeamMember::Core::sound_lot() {
  Lot lot = lot_for_sale(ledger(), present(), now_);
  for (auto wrong = contradictions(lot); !wrong.empty(); wrong = contradictions(lot)) {
    auto told = contradictions(in_mission_time(lot, now_));
    if (!told.empty()) wrong = std::move(told);  // else it is one by rounding alone
    for (const Contradiction& one : wrong) take_out(change(one.chain.back()), one.why);
    effects_.emplace_back(SaleTold{Rejected{std::move(wrong)}});
    lot = lot_for_sale(ledger(), present(), now_);
  }
  return lot;
}

void TeamMember::Core::sell() {
  for (const TaskNumber task : newly_too_late(ledger(), now_)) {
    LedgerEntry& entry = change(task);
    take_out(entry, why_too_late(entry.task));
    effects_.emplace_back(SaleTold{Rejected{{{{task}, entry.why}}}});
  }
  const std::set<MemberNumber> here = present();
  if (!is_to_sell(here)) return;
  for (const TaskNumber task : unsold_in_time(ledger(), now_)) put_up(change(task), "called again");
  // Of this term, so that what an older holder sold without a majority is another sale.
  const SaleNumber number((disk_.term << kSalesOfATerm) + ++sales_);
  SaleSetup setup{number,
                  std::make_shared<const Catalogue>(sound_lot()),
                  {},
                  setup_.limits.aim,
                  setup_.limits.sale,
                  setup_.seed + sales_};
  for (const MemberNumber member : here) setup.holdings.push_back(holding(ledger(), here, member));
  took_part_ = here;
  retry_at_ = now_ + Duration::nanoseconds(kRetryLeases * setup_.limits.lease.count());
  sale_.emplace(HeldSale{Auctioneer(std::move(setup)), number, ledger().revision});
  take(sale_->auctioneer.start(now_));
}

void TeamMember::Core::take(SaleEffects effects) {
  for (SaleEffect& effect : effects) {
    if (auto* send = std::get_if<Send>(&effect)) {
      if (send->to != setup_.self)
        tell(send->to, std::move(send->message));
      else if (!waits(own_calls_, send->message))
        own_calls_.push_back(std::move(send->message));
    } else if (!std::holds_alternative<Ended>(effect)) {
      sale_->explain(effect, names_);
      // It is asked in another sale, but not at once: it may be silent again.
      if (const auto* dropped = std::get_if<Dropped>(&effect)) {
        took_part_.erase(dropped->member);
        rest_until_ = now_ + setup_.limits.lease;
      }
      effects_.emplace_back(SaleTold{std::move(effect)});
    }
  }
  if (sale_->auctioneer.ended()) book_sale();
}

// What it sold goes into the ledger.
void TeamMember::Core::book_sale() {
  const HeldSale sale = std::move(*sale_);
  sale_.reset();
  sale.book(draft());
}

}  // namespace skein::auction
