// SPDX-License-Identifier: Apache-2.0
// Sales held by the holder of the token.
#include <algorithm>

#include "skein/foundation/overloaded.hpp"
#include "team_core.hpp"

namespace skein::auction {

namespace {

constexpr int kSalesOfATerm = 24;         // bits
constexpr std::int64_t kRetryLeases = 6;  // until what nobody could do is called again

std::string worth(const Value& value) {
  return to_text(Duration::milliseconds(static_cast<std::int64_t>(value.first * 1e3)));
}

// Of who has no vehicle.
class NoCraft : public Craft {
 public:
  Abilities abilities() const override { return 0; }
  std::optional<Leg> leg(Stopover, Stopover) const override { return Leg{}; }
  std::optional<std::string> objection(const Task&) const override { return "it has no vehicle"; }
};

}  // namespace

// Who was heard lately and bids.
std::set<MemberNumber> TeamMember::Core::present() const {
  std::set<MemberNumber> members = heard_since(now_ - setup_.limits.patience);
  std::erase_if(members, [this](MemberNumber member) { return !known_.at(member).bids; });
  if (bids_) members.insert(setup_.self);
  std::erase_if(members, [this](MemberNumber member) { return ledger().lost.contains(member); });
  return members;
}

// Something has no owner, or somebody is there that the last sale was without.
bool TeamMember::Core::worth_selling(const std::set<MemberNumber>& present) const {
  if (present.empty()) return false;
  const auto is_new = [this](MemberNumber member) { return !took_part_.contains(member); };
  const bool joined = now_ >= rest_until_ && std::any_of(present.begin(), present.end(), is_new);
  return std::any_of(ledger().entries.begin(), ledger().entries.end(), [&](const auto& each) {
    const Stage stage = each.second.stage;
    return stage == Stage::kForSale || (joined && stage == Stage::kOwned) ||
           (stage == Stage::kUnsold && (joined || now_ >= retry_at_));
  });
}

// Who bids has been told what the tasks are: the ledger says it, calls do not.
bool TeamMember::Core::all_know_what_is_for_sale(const std::set<MemberNumber>& present) const {
  std::uint64_t newest = 0;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage == Stage::kForSale) newest = std::max(newest, entry.revision);
  }
  return std::all_of(present.begin(), present.end(), [&](MemberNumber member) {
    return member == setup_.self || known_.at(member).revision >= newest;
  });
}

// What is neither done nor with somebody who is not there, from now on.
Lot TeamMember::Core::lot_for_sale() const {
  Lot lot;
  const std::set<MemberNumber> here = present();
  const double now = now_.to_seconds();
  for (const auto& [number, entry] : ledger().entries) {
    if (entry.stage == Stage::kDone || entry.stage == Stage::kUnsold) continue;
    const bool away = std::any_of(entry.owners.begin(), entry.owners.end(),
                                  [&](MemberNumber owner) { return !here.contains(owner); });
    if (away) continue;
    Task task = entry.task;
    task.earliest = std::max(0.0, task.earliest - now);
    task.deadline -= now;
    if (entry.stage == Stage::kGranted) task.deadline = std::numeric_limits<double>::infinity();
    lot.tasks.push_back(std::move(task));
  }
  const auto on_sale = [&](TaskNumber number) {
    return std::any_of(lot.tasks.begin(), lot.tasks.end(),
                       [&](const Task& task) { return task.number == number; });
  };
  for (const Precedence& p : ledger().precedences) {
    if (on_sale(p.first) && on_sale(p.then)) lot.precedences.push_back(p);
  }
  return lot;
}

Holding TeamMember::Core::holding(MemberNumber member) const {
  Holding holding{member, {}, 0};
  const auto route = ledger().routes.find(member);
  if (route == ledger().routes.end()) return holding;
  const std::set<MemberNumber> here = present();
  for (const TaskNumber task : route->second) {
    const auto found = ledger().entries.find(task);
    if (found == ledger().entries.end()) continue;
    const LedgerEntry& entry = found->second;
    const auto& owners = entry.owners;
    if (std::find(owners.begin(), owners.end(), member) == owners.end()) continue;
    if (entry.stage != Stage::kOwned && entry.stage != Stage::kGranted) continue;
    const bool away = std::any_of(owners.begin(), owners.end(),
                                  [&](MemberNumber owner) { return !here.contains(owner); });
    if (away) continue;
    holding.tasks.push_back(task);
    if (entry.stage == Stage::kGranted)
      holding.fixed = static_cast<std::uint32_t>(holding.tasks.size());
  }
  return holding;
}

ToAuctioneer TeamMember::Core::answer(const ToMember& call) {
  const auto [sale, lot] =
      std::visit([](const auto& message) { return std::pair(message.sale, message.lot); }, call);
  if (!bidding_ || bidding_->sale != sale) {
    bidding_ = {sale, setup_.craft ? setup_.craft(lot, now_) : std::make_unique<const NoCraft>()};
  }
  ToAuctioneer said = Bidder(setup_.self, *bidding_->craft).handle(call);
  const auto* offer = std::get_if<Offer>(&said);
  if (offer != nullptr && offer->round == 1) effects_.emplace_back(Offered{*offer});
  return said;
}

// One after the other: a team of one sells a whole lot without a message.
void TeamMember::Core::answer_own_calls() {
  while (!own_calls_.empty()) {
    const ToMember call = std::move(own_calls_.front());
    own_calls_.pop_front();
    if (sale_) take(sale_->auctioneer.handle(answer(call), now_));
  }
  if (role_ == Role::kHolder && changed_) {
    commit();
    beat();
    changed_ = false;
  }
}

// What cannot be done any more whoever does it is taken out, and told.
Lot TeamMember::Core::sound_lot() {
  Lot lot = lot_for_sale();
  for (auto wrong = contradictions(lot); !wrong.empty(); wrong = contradictions(lot)) {
    for (const Contradiction& one : wrong) {
      LedgerEntry& entry = change(one.chain.back());
      put_up(entry, one.why);
      entry.stage = Stage::kUnsold;
    }
    effects_.emplace_back(SaleTold{Rejected{std::move(wrong)}});
    lot = lot_for_sale();
  }
  return lot;
}

void TeamMember::Core::sell() {
  const std::set<MemberNumber> here = present();
  if (!worth_selling(here) || !all_know_what_is_for_sale(here)) return;
  std::vector<TaskNumber> again;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage == Stage::kUnsold) again.push_back(task);
  }
  for (const TaskNumber task : again) put_up(change(task), "called again");
  SaleSetup setup{SaleNumber((disk_.term << kSalesOfATerm) + ++sales_),
                  std::make_shared<const Catalogue>(sound_lot()),
                  {},
                  setup_.limits.aim,
                  setup_.limits.sale,
                  setup_.seed + sales_};
  for (const MemberNumber member : here) setup.holdings.push_back(holding(member));
  took_part_ = here;
  retry_at_ = now_ + Duration::nanoseconds(kRetryLeases * setup_.limits.lease.count());
  sale_.emplace(Sale{Auctioneer(std::move(setup)), ledger().revision, here, {}});
  take(sale_->auctioneer.start(now_));
}

void TeamMember::Core::take(SaleEffects effects) {
  for (SaleEffect& effect : effects) {
    if (auto* send = std::get_if<Send>(&effect)) {
      if (send->to == setup_.self)
        own_calls_.push_back(std::move(send->message));
      else
        tell(send->to, std::move(send->message));
    } else if (!std::holds_alternative<Ended>(effect)) {
      explain(effect);
      effects_.emplace_back(SaleTold{std::move(effect)});
    }
  }
  if (sale_->auctioneer.ended()) book_sale();
}

void TeamMember::Core::explain(const SaleEffect& effect) {
  std::visit(Overloaded{
                 [this](const Sold& sold) {
                   std::string& why = sale_->why[sold.task];
                   why = std::string(sold.trade ? "traded" : "sold") + " to " +
                         names(sold.members) + " for " + worth(sold.value);
                   why += sold.next_best ? "; next best " + names(sold.next_best->members) +
                                               " for " + worth(sold.next_best->value)
                                         : "; nobody else could";
                 },
                 [this](const Unsold& unsold) {
                   std::string& why = sale_->why[unsold.task];
                   why = unsold.together;
                   for (const auto& [member, reason] : unsold.reasons) {
                     why += (why.empty() ? "" : "; ") + name(member) + ": " + reason;
                   }
                 },
                 [this](const Rejected& rejected) {
                   for (const Contradiction& wrong : rejected.contradictions) {
                     for (const TaskNumber task : wrong.chain) sale_->why[task] = wrong.why;
                   }
                 },
                 // It is asked in another sale, but not at once: it may be silent again.
                 [this](const Dropped& dropped) {
                   took_part_.erase(dropped.member);
                   rest_until_ = now_ + setup_.limits.lease;
                 },
                 [](const auto&) {},
             },
             effect);
}

// What changed while it was being sold stays as it changed; it is sold anew if need be.
void TeamMember::Core::book_sale() {
  const Sale sale = std::move(*sale_);
  sale_.reset();
  std::map<TaskNumber, std::vector<MemberNumber>> owners;
  Ledger& next = draft();
  for (const Auctioneer::Route& route : sale.auctioneer.routes()) {
    auto& own = next.routes[route.member];
    const std::vector<TaskNumber> before = std::move(own);
    own = route.tasks;
    for (const TaskNumber task : before) {
      if (std::find(own.begin(), own.end(), task) == own.end()) own.push_back(task);
    }
    for (const TaskNumber task : route.tasks) owners[task].push_back(route.member);
  }
  for (auto& [number, entry] : next.entries) {
    if (entry.revision > sale.revision) continue;
    const auto sold = owners.find(number);
    const auto why = sale.why.find(number);
    const bool open = entry.stage == Stage::kForSale || entry.stage == Stage::kOwned;
    if (!open) continue;
    if (sold == owners.end()) {
      if (entry.stage != Stage::kForSale || why == sale.why.end()) continue;
      entry.stage = Stage::kUnsold;
    } else {
      std::sort(sold->second.begin(), sold->second.end());
      if (entry.stage == Stage::kOwned && entry.owners == sold->second) continue;
      entry.stage = Stage::kOwned;
      entry.owners = sold->second;
      // Of this term, so that what an older holder sold without a majority is another sale.
      entry.sale = std::max(entry.sale + 1, next.term << kSalesOfATerm);
    }
    entry.finished.clear();
    entry.stopped.clear();
    entry.revision = next.revision;
    if (why != sale.why.end()) entry.why = why->second;
  }
}

}  // namespace skein::auction
