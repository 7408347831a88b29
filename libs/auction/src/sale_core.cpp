// SPDX-License-Identifier: Apache-2.0
#include "sale_core.hpp"

#include <algorithm>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein::auction {

namespace {

// Members and tasks of a small team are searched relatively longer: rounds are cheap there.
std::uint32_t patience_of(const SaleSetup& setup) {
  if (setup.limits.patience > 0) return setup.limits.patience;
  return static_cast<std::uint32_t>(std::min<std::size_t>(80 + 10 * setup.lot->size(), 600));
}

std::uint32_t most_rounds_of(const SaleSetup& setup) {
  if (setup.limits.most_rounds > 0) return setup.limits.most_rounds;
  return static_cast<std::uint32_t>(1000 + 10 * setup.lot->size());
}

Duration quarter(Duration whole) { return Duration::nanoseconds(whole.count() / 4); }

BookedRoute without(const BookedRoute& route, const std::vector<TaskNumber>& items) {
  BookedRoute left = route;
  std::erase_if(left.tasks, [&](TaskNumber task) {
    return std::find(items.begin(), items.end(), task) != items.end();
  });
  return left;
}

}  // namespace

Auctioneer::Core::Core(SaleSetup setup)
    : setup_(std::move(setup)), picker_(*setup_.lot, setup_.aim, setup_.limits, setup_.seed) {
  setup_.limits.patience = patience_of(setup_);
  setup_.limits.most_rounds = most_rounds_of(setup_);
  for (const Holding& holding : setup_.holdings) {
    SKEIN_EXPECTS(holding.fixed <= holding.tasks.size());
    index_.emplace(holding.member, members_.size());
    Member& member = members_.emplace_back();
    member.route.member = holding.member;
    member.route.tasks = holding.tasks;
    member.route.fixed = holding.fixed;
    had_members_.insert(holding.tasks.begin(), holding.tasks.end());
  }
  for (const Task& task : setup_.lot->lot().tasks) {
    if (!had_members_.contains(task.number)) to_sell_.push_back(task.number);
  }
  value_.unsold = static_cast<std::uint32_t>(to_sell_.size());
}

void Auctioneer::Core::start(MissionTime now, SaleEffects& effects) {
  SKEIN_EXPECTS(phase_ == Phase::kIdle);
  if (auto wrong = contradictions(setup_.lot->lot()); !wrong.empty()) {
    effects.emplace_back(Rejected{std::move(wrong)});
    phase_ = Phase::kEnded;
    return;
  }
  next_round(now, effects);
}

// What has no members first; then trades, until none has gained for long.
void Auctioneer::Core::next_round(MissionTime now, SaleEffects& effects) {
  deal_.reset();
  selling_ = round_ == 0 || !to_sell_.empty();
  if (selling_) {
    const std::size_t count = std::min<std::size_t>(setup_.limits.together, to_sell_.size());
    items_.assign(to_sell_.begin(), to_sell_.begin() + static_cast<std::ptrdiff_t>(count));
    to_sell_.erase(to_sell_.begin(), to_sell_.begin() + static_cast<std::ptrdiff_t>(count));
  } else {
    const bool enough =
        without_gain_ >= setup_.limits.patience || round_ >= setup_.limits.most_rounds;
    items_ = enough ? std::vector<TaskNumber>{} : picker_.items(books(), last_to_end(), left_over_);
    if (items_.empty()) return finish(effects);
  }
  call(now, effects);
}

void Auctioneer::Core::call(MissionTime now, SaleEffects& effects) {
  ++round_;
  phase_ = Phase::kCalling;
  open_answers(now);
  offers_.clear();
  without_items_.clear();
  awaited_.clear();
  std::set<std::size_t> called;
  for (std::size_t i = 0; i < members_.size(); ++i) called.insert(i);
  if (!selling_) called = picker_.called(books(), items_);
  for (const std::size_t i : called) {
    if (!members_[i].present) continue;
    const BookedRoute& route = without_items_[i] = without(members_[i].route, items_);
    awaited_.insert(i);
    send(i,
         Call{setup_.sale, round_, setup_.lot, route.tasks, route.fixed, items_, 0,
              items_.size() > 1},
         effects);
  }
  if (!awaited_.empty()) return;
  if (selling_) left_over_.insert(left_over_.end(), items_.begin(), items_.end());
  finish(effects);
}

// An offer for the route and the items that were called, as far as can be seen.
bool Auctioneer::Core::makes_sense(const Offer& offer, std::size_t member) const {
  const auto route = without_items_.find(member);
  if (route == without_items_.end() || offer.items.size() != items_.size()) return false;
  const std::size_t length = route->second.tasks.size();
  const bool between = items_.size() > 1 && offer.between.size() != items_.size() * items_.size();
  if (between || offer.legs.size() != length + 1) return false;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const ItemPrice& price = offer.items[i];
    if (price.item != items_[i]) return false;
    for (std::size_t g = 0; g < price.gaps.size(); ++g) {
      const std::uint32_t gap = price.gaps[g].gap;
      const bool in_order = g == 0 || price.gaps[g - 1].gap < gap;
      if (!in_order || gap < route->second.fixed || gap > length) return false;
    }
  }
  return true;
}

void Auctioneer::Core::on_offer(const Offer& offer, MissionTime now, SaleEffects& effects) {
  const auto found = index_.find(offer.member);
  if (phase_ != Phase::kCalling || found == index_.end() || offer.round != round_) return;
  if (!makes_sense(offer, found->second) || awaited_.erase(found->second) == 0) return;
  Member& member = members_[found->second];
  Offer& kept = offers_[found->second] = offer;
  member.abilities = offer.abilities;
  for (ItemPrice& price : kept.items) {
    if (member.vetoes.contains(price.item))
      price.gaps.clear();
    else
      member.objections[price.item] = price.objection;
  }
  if (awaited_.empty()) decide(now, effects);
}

Auctioneer::Core::Deal Auctioneer::Core::draft_deal() {
  Deal deal{Draft(*setup_.lot, setup_.aim, items_), {}, {}, {}, {}};
  Draft::Rest rest;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const auto offer = offers_.find(i);
    if (offer == offers_.end() && !setup_.lot->coupled()) {
      rest.cost += members_[i].cost;
      rest.end = std::max(rest.end, members_[i].end);
      rest.ends += members_[i].ends;
    } else if (offer == offers_.end()) {
      if (members_[i].route.legs.empty()) continue;  // never heard: nothing is known of its dates
      deal.draft.add(without_items_.contains(i) ? without_items_[i] : members_[i].route, nullptr);
      deal.routes.push_back(i);
    } else {
      deal.draft.add(without_items_[i], &offer->second);
      deal.routes.push_back(i);
    }
  }
  rest.unsold = static_cast<std::uint32_t>(to_sell_.size() + left_over_.size());
  for (const TaskNumber item : items_) {
    rest.unsold -=
        static_cast<std::uint32_t>(std::count(left_over_.begin(), left_over_.end(), item));
  }
  deal.draft.set_rest(rest);
  return deal;
}

void Auctioneer::Core::decide(MissionTime now, SaleEffects& effects) {
  Deal deal = draft_deal();
  if (!deal.draft.restore()) {  // routes that wait for each other: whatever has dates is better
    value_.unsold = std::numeric_limits<std::uint32_t>::max();
    if (round_ == 1) {
      sell_all_anew();
    } else if (selling_)
      left_over_.insert(left_over_.end(), items_.begin(), items_.end());
    ++without_gain_;
    return next_round(now, effects);
  }
  deal.decided = determine_winners(deal.draft, picker_.random(), setup_.limits.orders);
  const Value value = deal.draft.value();
  const bool first = round_ == 1;
  if (!selling_ && !better(value, value_)) {
    ++without_gain_;
    return next_round(now, effects);
  }
  if (!first && selling_ && deal.decided.empty()) {
    left_over_.insert(left_over_.end(), items_.begin(), items_.end());
    tell_hopeless(effects);
    return next_round(now, effects);
  }
  award(std::move(deal), now, effects);
}

// Everything that may move goes on sale again.
void Auctioneer::Core::sell_all_anew() {
  std::set<TaskNumber> all(items_.begin(), items_.end());
  std::set<TaskNumber> fixed;
  for (Member& member : members_) {
    auto& tasks = member.route.tasks;
    fixed.insert(tasks.begin(), tasks.begin() + member.route.fixed);
    all.insert(tasks.begin() + member.route.fixed, tasks.end());
    tasks.resize(member.route.fixed);
    member.route.legs.clear();
  }
  for (const TaskNumber task : all) {
    if (!fixed.contains(task)) to_sell_.push_back(task);
  }
}

// Awards for whose route changes; where there is none, the deal is done.
void Auctioneer::Core::award(Deal deal, MissionTime now, SaleEffects& effects) {
  phase_ = Phase::kAwarding;
  open_answers(now);
  for (std::size_t r = 0; r < deal.routes.size(); ++r) {
    const std::size_t i = deal.routes[r];
    const auto tasks = deal.draft.tasks(r);
    if (tasks == members_[i].route.tasks) continue;
    deal.awaited.insert(i);
    send(i, Award{setup_.sale, round_, setup_.lot, tasks}, effects);
  }
  deal_ = std::move(deal);
  if (deal_->awaited.empty()) close_deal(now, effects);
}

bool Auctioneer::Core::has_legs(const Answer& answer, std::size_t member) const {
  for (std::size_t r = 0; r < deal_->routes.size(); ++r) {
    if (deal_->routes[r] == member) return answer.legs.size() == deal_->draft.tasks(r).size() + 1;
  }
  return false;
}

void Auctioneer::Core::on_answer(const Answer& answer, MissionTime now, SaleEffects& effects) {
  const auto found = index_.find(answer.member);
  if (phase_ != Phase::kAwarding || found == index_.end() || answer.round != round_) return;
  if (!answer.refusal && !has_legs(answer, found->second)) return;
  if (deal_->awaited.erase(found->second) == 0) return;
  if (answer.refusal) {
    Member& member = members_[found->second];
    for (const TaskNumber item : items_) {
      if (std::find(member.route.tasks.begin(), member.route.tasks.end(), item) ==
          member.route.tasks.end()) {
        member.vetoes.insert(item);
        member.objections[item] = *answer.refusal;
      }
    }
    effects.emplace_back(Dropped{answer.member, round_, *answer.refusal});
    return drop_deal(now, effects);
  }
  deal_->taken[found->second] = answer;
  if (deal_->awaited.empty()) close_deal(now, effects);
}

void Auctioneer::Core::close_deal(MissionTime now, SaleEffects& effects) {
  const Deal deal = std::move(*deal_);
  without_gain_ = 0;
  book(deal);
  tell_sold(deal, effects);
  std::erase_if(left_over_, [&](TaskNumber task) {
    return std::find(items_.begin(), items_.end(), task) != items_.end();
  });
  std::set<std::uint32_t> sold;
  for (const Decided& one : deal.decided) sold.insert(one.placing.item);
  for (std::uint32_t i = 0; i < items_.size(); ++i) {
    if (sold.contains(i))
      had_members_.insert(items_[i]);
    else
      left_over_.push_back(items_[i]);
  }
  tell_hopeless(effects);
  next_round(now, effects);
}

// What was to be sold is offered again: the winner that refused will not be asked.
void Auctioneer::Core::drop_deal(MissionTime now, SaleEffects& effects) {
  if (selling_) to_sell_.insert(to_sell_.begin(), items_.begin(), items_.end());
  ++without_gain_;
  next_round(now, effects);
}

void Auctioneer::Core::book(const Deal& deal) {
  for (std::size_t r = 0; r < deal.routes.size(); ++r) {
    Member& member = members_[deal.routes[r]];
    member.route.tasks = deal.draft.tasks(r);
    const auto answer = deal.taken.find(deal.routes[r]);
    member.route.legs = answer != deal.taken.end() ? answer->second.legs : deal.draft.legs(r);
    if (const auto offer = offers_.find(deal.routes[r]); offer != offers_.end()) {
      member.route.free_from = offer->second.free_from;
    }
    member.end = deal.draft.end(r);
    member.cost = deal.draft.cost(r);
    member.ends = deal.draft.ends(r);
    member.starts.clear();
    for (const TaskNumber task : member.route.tasks)
      member.starts.push_back(deal.draft.start(task));
  }
  value_ = deal.draft.value();
}

void Auctioneer::Core::open_answers(MissionTime now) {
  closes_ = now + setup_.limits.answer_within;
  say_again_ = now + quarter(setup_.limits.answer_within);
  said_.clear();
}

void Auctioneer::Core::send(std::size_t member, ToMember message, SaleEffects& effects) {
  said_[member] = message;
  effects.emplace_back(Send{members_[member].route.member, std::move(message)});
}

void Auctioneer::Core::tick(MissionTime now, SaleEffects& effects) {
  if (!next_wakeup() || now < *next_wakeup()) return;
  if (now < closes_) {
    say_again_ = now + quarter(setup_.limits.answer_within);
    for (const std::size_t i : awaited()) {
      effects.emplace_back(Send{members_[i].route.member, said_.at(i)});
    }
    return;
  }
  if (phase_ == Phase::kCalling) {
    bool keeps_items = false;
    for (const std::size_t i : awaited_) {
      keeps_items = keeps_items || without_items_[i].tasks != members_[i].route.tasks;
      drop(i, "did not answer a call", effects);
    }
    awaited_.clear();
    if (!keeps_items) return decide(now, effects);
    ++without_gain_;
    return next_round(now, effects);
  }
  for (const std::size_t i : deal_->awaited) drop(i, "did not answer an award", effects);
  drop_deal(now, effects);
}

std::optional<MissionTime> Auctioneer::Core::next_wakeup() const {
  if (phase_ != Phase::kCalling && phase_ != Phase::kAwarding) return std::nullopt;
  return std::min(say_again_, closes_);
}

// Silent: it keeps what it has, and is not asked again in this sale.
void Auctioneer::Core::drop(std::size_t member, const char* why, SaleEffects& effects) {
  members_[member].present = false;
  effects.emplace_back(Dropped{members_[member].route.member, round_, why});
}

std::size_t Auctioneer::Core::last_to_end() const {
  const auto last = std::max_element(members_.begin(), members_.end(),
                                     [](const auto& a, const auto& b) { return a.end < b.end; });
  return static_cast<std::size_t>(last - members_.begin());
}

std::vector<BookedRoute> Auctioneer::Core::books() const {
  std::vector<BookedRoute> books;
  for (const Member& member : members_) {
    books.push_back(member.route);
    if (!member.present) books.back().fixed = static_cast<std::uint32_t>(member.route.tasks.size());
  }
  return books;
}

std::vector<Auctioneer::Route> Auctioneer::Core::routes() const {
  std::vector<Auctioneer::Route> routes;
  for (const Member& member : members_) {
    routes.push_back(
        {member.route.member, member.route.tasks, member.starts, member.end, member.cost});
  }
  return routes;
}

}  // namespace skein::auction
