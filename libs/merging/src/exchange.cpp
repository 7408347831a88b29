// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/exchange.hpp"

#include <utility>

namespace skein::merging {

bool Exchange::hear(const Message& message) {
  const bool by_witness = !message.of.empty();
  if (!by_witness) arrived_ = message.known == told_version_;
  if (message.brief && message.version != version_) return false;
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
    again_.pause = beat;
  }
  again_.last = now;
  Message message;
  message.number = number;
  message.version = told_version_;
  message.known = version_;
  message.brief = arrived_;
  if (!message.brief) message.claim = std::move(own);
  return message;
}

void Exchange::claims(const Claim& own, Duration beat) {
  if (told_ == own) return;
  arrived_ = false;
  again_.pause = beat;
}

std::optional<MissionTime> Exchange::due() const {
  return arrived_ ? std::nullopt : std::optional(again_.due());
}

}  // namespace skein::merging
