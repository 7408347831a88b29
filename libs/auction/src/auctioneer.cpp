// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/auctioneer.hpp"

#include "sale_core.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::auction {

Auctioneer::Auctioneer(SaleSetup setup) : core_(std::make_unique<Core>(std::move(setup))) {}
Auctioneer::~Auctioneer() = default;
Auctioneer::Auctioneer(Auctioneer&&) noexcept = default;
Auctioneer& Auctioneer::operator=(Auctioneer&&) noexcept = default;

SaleEffects Auctioneer::start(MissionTime now) {
  SaleEffects effects;
  core_->start(now, effects);
  return effects;
}

SaleEffects Auctioneer::handle(const ToAuctioneer& answer, MissionTime now) {
  SaleEffects effects;
  const SaleNumber sale = std::visit([](const auto& said) { return said.sale; }, answer);
  if (sale != core_->number()) return effects;
  std::visit(Overloaded{[&](const Offer& offer) { core_->on_offer(offer, now, effects); },
                        [&](const Answer& taken) { core_->on_answer(taken, now, effects); }},
             answer);
  return effects;
}

SaleEffects Auctioneer::tick(MissionTime now) {
  SaleEffects effects;
  core_->tick(now, effects);
  return effects;
}

std::optional<MissionTime> Auctioneer::next_wakeup() const { return core_->next_wakeup(); }
bool Auctioneer::ended() const { return core_->ended(); }
std::uint32_t Auctioneer::rounds() const { return core_->rounds(); }
std::vector<Auctioneer::Route> Auctioneer::routes() const { return core_->routes(); }
Value Auctioneer::value() const { return core_->value(); }

}  // namespace skein::auction
