// SPDX-License-Identifier: Apache-2.0
// From the bytes of a link to what one autopilot says.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "outbox.hpp"
#include "picture.hpp"

namespace skein::autopilot {

using Answer = std::pair<mavlink::CommandAck, mavlink::Address>;

/// There may be several vehicles, stations and cameras on one link. The vehicle is the system that
/// was configured, or the first whose autopilot is heard.
class Listener {
 public:
  Listener(const BridgeConfig& config, Picture& picture) : config_(config), picture_(picture) {}

  /// Puts what is new into the picture; gives the answers to commands.
  std::vector<Answer> take(const mavlink::Bytes& bytes, Duration now, Outbox& out);
  std::optional<std::uint8_t> system() const { return system_; }
  const mavlink::ParserCounts& counts() const { return parser_.counts(); }

 private:
  bool recognises(const mavlink::Frame& frame, const mavlink::Message& message, Outbox& out);
  void note(const mavlink::Message& message, Duration now, Outbox& out);

  const BridgeConfig& config_;
  Picture& picture_;
  mavlink::Parser parser_;
  std::optional<std::uint8_t> system_;
  std::set<std::uint8_t> strangers_;
};

}  // namespace skein::autopilot
