// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/bidder.hpp"

#include <algorithm>
#include <bit>

#include "skein/foundation/overloaded.hpp"

namespace skein::auction {

namespace {

using Route = std::vector<TaskNumber>;

Stopover before_gap(const Route& route, std::size_t gap) {
  return gap == 0 ? Stopover::begin() : Stopover::of(route[gap - 1]);
}

Stopover after_gap(const Route& route, std::size_t gap) {
  return gap == route.size() ? Stopover::end() : Stopover::of(route[gap]);
}

void keep_cheapest(std::vector<GapPrice>& gaps, std::size_t wanted, const std::vector<Leg>& legs) {
  if (wanted == 0 || gaps.size() <= wanted) return;
  const auto detour = [&](const GapPrice& price) {
    return price.in.seconds + price.out.seconds - legs[price.gap].seconds;
  };
  std::stable_sort(gaps.begin(), gaps.end(),
                   [&](const auto& a, const auto& b) { return detour(a) < detour(b); });
  gaps.resize(wanted);
  std::sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
}

}  // namespace

ToAuctioneer Bidder::handle(const ToMember& message) const {
  return std::visit(Overloaded{[this](const Call& call) { return ToAuctioneer(price(call)); },
                               [this](const Award& award) { return ToAuctioneer(take(award)); }},
                    message);
}

// Empty: it may do it.
std::string Bidder::refusal_of(const Task& task) const {
  if (task.forbidden.contains(self_)) return "the operator forbids it";
  const bool alone = task.least_members <= 1 && std::popcount(task.needs) <= 1;
  if (alone && task.pinned && *task.pinned != self_) return "the operator gives it to another";
  if ((task.needs_each & ~craft_->abilities()) != 0) {
    return "it lacks an ability that every member needs";
  }
  if (task.needs != 0 && (task.needs & craft_->abilities()) == 0) {
    return "it has none of the abilities";
  }
  return craft_->objection(task).value_or("");
}

// Each gap that has ways in and out.
ItemPrice Bidder::price_item(const Call& call, const Task& task) const {
  ItemPrice price{task.number, craft_->energy_of(task), {}, refusal_of(task)};
  if (!price.objection.empty()) return price;
  const Stopover place = Stopover::of(task.number);
  for (std::size_t gap = call.fixed; gap <= call.route.size(); ++gap) {
    const auto in = craft_->leg(before_gap(call.route, gap), place);
    const auto out = craft_->leg(place, after_gap(call.route, gap));
    if (in && out) price.gaps.push_back({static_cast<std::uint32_t>(gap), *in, *out});
  }
  if (price.gaps.empty()) price.objection = "there is no way to it";
  return price;
}

std::vector<Leg> Bidder::legs_of(const Route& route) const {
  std::vector<Leg> legs;
  for (std::size_t gap = 0; gap <= route.size(); ++gap) {
    legs.push_back(craft_->leg(before_gap(route, gap), after_gap(route, gap)).value_or(kNoWay));
  }
  return legs;
}

Offer Bidder::price(const Call& call) const {
  Offer offer{call.sale,
              call.round,
              self_,
              craft_->abilities(),
              craft_->free_from(),
              craft_->energy(),
              legs_of(call.route),
              {},
              {}};
  for (const Leg& leg : offer.legs) offer.energy -= leg.energy;
  for (const TaskNumber task : call.route) {
    offer.energy -= craft_->energy_of(call.lot->task(task));
  }
  for (const TaskNumber item : call.items) {
    offer.items.push_back(price_item(call, call.lot->task(item)));
    keep_cheapest(offer.items.back().gaps, call.gaps, offer.legs);
  }
  if (!call.between) return offer;
  for (const TaskNumber from : call.items) {
    for (const TaskNumber to : call.items) {
      offer.between.push_back(
          from == to ? kNoWay : craft_->leg(Stopover::of(from), Stopover::of(to)).value_or(kNoWay));
    }
  }
  return offer;
}

Answer Bidder::take(const Award& award) const {
  Answer answer{award.sale,   award.round,          self_,
                std::nullopt, legs_of(award.route), craft_->energy()};
  for (const TaskNumber number : award.route) {
    const Task& task = award.lot->task(number);
    answer.energy -= craft_->energy_of(task);
    if (std::string own = refusal_of(task); !own.empty()) answer.refusal = std::move(own);
  }
  for (const Leg& leg : answer.legs) {
    answer.energy -= leg.energy;
    if (leg.seconds >= kNoWay.seconds) answer.refusal = "there is no way along this route";
  }
  if (answer.energy < 0) answer.refusal = "the energy does not last for this route";
  return answer;
}

}  // namespace skein::auction
