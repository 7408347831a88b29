// SPDX-License-Identifier: Apache-2.0
#include "skein/auction_lab/sale_simulation.hpp"

#include <variant>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::auction {

namespace {

struct Parcel {
  MissionTime at;
  std::uint64_t number = 0;  ///< of those due at one instant, the first sent is the first heard
  MemberNumber member;       ///< to whom, or from whom
  std::variant<ToMember, ToAuctioneer> content;
};

struct Later {
  bool operator()(const Parcel& a, const Parcel& b) const {
    return std::pair(a.at, a.number) > std::pair(b.at, b.number);
  }
};

class Play {
 public:
  Play(SaleSetup setup, const std::vector<const Craft*>& crafts, const SaleTransport& transport,
       const Presence& present)
      : transport_(transport), random_(transport.seed, "auction/transport"), present_(present) {
    SKEIN_EXPECTS(crafts.size() == setup.holdings.size());
    for (std::size_t i = 0; i < crafts.size(); ++i) {
      bidders_.emplace(setup.holdings[i].member, Bidder(setup.holdings[i].member, *crafts[i]));
    }
    auctioneer_ = std::make_unique<Auctioneer>(std::move(setup));
  }

  SaleOutcome run() {
    take(auctioneer_->start(now_));
    while (!auctioneer_->ended()) {
      const auto wakeup = auctioneer_->next_wakeup();
      SKEIN_ENSURES(wakeup || !under_way_.empty());
      if (under_way_.empty() || (wakeup && *wakeup < under_way_.top().at)) {
        now_ = *wakeup;
        take(auctioneer_->tick(now_));
        continue;
      }
      const Parcel parcel = under_way_.top();
      under_way_.pop();
      now_ = parcel.at;
      deliver(parcel);
    }
    outcome_.routes = auctioneer_->routes();
    outcome_.value = auctioneer_->value();
    outcome_.rounds = auctioneer_->rounds();
    outcome_.ended = now_;
    return std::move(outcome_);
  }

 private:
  void deliver(const Parcel& parcel) {
    if (const auto* to_member = std::get_if<ToMember>(&parcel.content)) {
      if (present_ && !present_(parcel.member, now_)) return;
      send(parcel.member, bidders_.at(parcel.member).handle(*to_member));
    } else {
      take(auctioneer_->handle(std::get<ToAuctioneer>(parcel.content), now_));
    }
  }

  void take(SaleEffects effects) {
    for (SaleEffect& effect : effects) {
      if (auto* message = std::get_if<Send>(&effect))
        send(message->to, std::move(message->message));
      else
        outcome_.told.push_back(std::move(effect));
    }
  }

  void send(MemberNumber member, std::variant<ToMember, ToAuctioneer> content) {
    ++outcome_.messages;
    const double part = random_.uniform();
    if (random_.chance(transport_.loss)) return;
    const auto span = static_cast<double>((transport_.longest - transport_.least).count());
    const auto delay =
        transport_.least + Duration::nanoseconds(static_cast<std::int64_t>(part * span));
    under_way_.push({now_ + delay, outcome_.messages, member, std::move(content)});
  }

  SaleTransport transport_;
  Random random_;
  Presence present_;
  std::map<MemberNumber, Bidder> bidders_;
  std::unique_ptr<Auctioneer> auctioneer_;
  std::priority_queue<Parcel, std::vector<Parcel>, Later> under_way_;
  SaleOutcome outcome_;
  MissionTime now_;
};

}  // namespace

SaleOutcome play_sale(SaleSetup setup, const std::vector<const Craft*>& crafts,
                      const SaleTransport& transport, const Presence& present) {
  return Play(std::move(setup), crafts, transport, present).run();
}

}  // namespace skein::auction
