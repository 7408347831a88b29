// SPDX-License-Identifier: Apache-2.0
// Effects of a call, and the frames among them.
#pragma once

#include <utility>
#include <vector>

#include "skein/autopilot/bridge.hpp"

namespace skein::autopilot {

class Outbox {
 public:
  explicit Outbox(mavlink::Address own) : own_(own) {}

  void send(const mavlink::Message& message) {
    effects_.push_back(Transmit{mavlink::to_bytes(mavlink::to_frame(message, own_, sequence_++))});
  }
  void add(Effect effect) { effects_.push_back(std::move(effect)); }
  void say(std::string text) { effects_.push_back(Notice{std::move(text)}); }
  std::vector<Effect> take() { return std::exchange(effects_, {}); }

 private:
  mavlink::Address own_;
  std::uint8_t sequence_ = 0;
  std::vector<Effect> effects_;
};

}  // namespace skein::autopilot
