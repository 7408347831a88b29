// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/exchange.hpp"

#include <algorithm>
#include <utility>

namespace skein::merging {

bool Exchange::hear(const Message& message, MissionTime now) {
  const bool by_witness = !message.of.empty();
  if (!by_witness) {
    const bool is_known = message.known == told_version_;
    if (is_known && !arrived_ && in_full_ == 1) round_trip_ = now - told_at_;
    arrived_ = is_known;
  }
  if (message.lacks) on_its_way_until_ = {};
  lacks_ = message.brief && message.version != version_;
  if (lacks_) return false;
  number_ = message.number;
  heard_ = true;
  if (message.brief) return true;
  claim_ = message.claim;
  version_ = message.version;
  return true;
}

Message Exchange::tell(Claim own, std::uint64_t number, MissionTime now, Duration beat) {
  if (told_version_ == 0 || told_ != own) {
    told_ = own;
    told_version_ = number;
    arrived_ = false;
    on_its_way_until_ = {};
    in_full_ = 0;
    told_at_ = now;
    again_.pause = beat;
  }
  again_.last = now;
  Message message;
  message.number = number;
  message.version = told_version_;
  message.known = version_;
  message.lacks = lacks_;
  message.brief = arrived_ || now < on_its_way_until_;
  if (message.brief) return message;
  ++in_full_;
  on_its_way_until_ = now + kOnItsWay;
  message.claim = std::move(own);
  return message;
}

void Exchange::claims(const Claim& own, Duration beat) {
  if (told_ == own) return;
  arrived_ = false;
  again_.pause = beat;
}

std::optional<MissionTime> Exchange::due() const {
  return arrived_ ? std::nullopt : std::optional(std::max(again_.due(), on_its_way_until_));
}

}  // namespace skein::merging
