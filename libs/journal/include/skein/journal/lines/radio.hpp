// SPDX-License-Identifier: Apache-2.0
// Of channels and what passes over them. docs/journal.md says when each is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// An event sample left (sent) or arrived (received) over radio.
struct Message {
  static constexpr std::string_view kKind = "message";
  Text slot = {};
  Text from = {};
  Text to = {};
  std::uint64_t sequence = 0;
  Text direction = {};
  /// The session that a NegotiationMessage is about, as lines of negotiations name it.
  OptionalText subject = {};
  OptionalText opener = {};
  std::optional<double> opened = {};

  static void fields(auto& it, auto&& each) {
    each("slot", it.slot);
    each("from", it.from);
    each("to", it.to);
    each("sequence", it.sequence);
    each("direction", it.direction);
    each("subject", it.subject);
    each("opener", it.opener);
    each("opened", it.opened);
  }
};

/// A node was restarted with what it knew, last heard of at that mission time [s].
struct Resumed {
  static constexpr std::string_view kKind = "resumed";
  double from = 0;

  static void fields(auto& it, auto&& each) { each("from", it.from); }
};

/// What a node sends to a peer goes past relays; left out: directly again.
struct Route {
  static constexpr std::string_view kKind = "route";
  Text peer = {};
  OptionalText via = {};
  std::optional<std::uint64_t> relays = {};

  static void fields(auto& it, auto&& each) {
    each("peer", it.peer);
    each("via", it.via);
    each("relays", it.relays);
  }
};

/// What a node believes of a peer.
struct Reach {
  static constexpr std::string_view kKind = "reach";
  Text peer = {};
  bool reachable = false;

  static void fields(auto& it, auto&& each) {
    each("peer", it.peer);
    each("reachable", it.reachable);
  }
};

/// An event was too late to be handled.
struct Expired {
  static constexpr std::string_view kKind = "expired";
  Text slot = {};
  Text to = {};
  std::uint64_t sequence = 0;
  Text from = {};

  static void fields(auto& it, auto&& each) {
    each("slot", it.slot);
    each("to", it.to);
    each("sequence", it.sequence);
    each("from", it.from);
  }
};

/// Events `sequence` to `last` that the sender gave up.
struct Lost {
  static constexpr std::string_view kKind = "lost";
  Text slot = {};
  Text to = {};
  std::uint64_t sequence = 0;
  std::uint64_t last = 0;
  Text from = {};

  static void fields(auto& it, auto&& each) {
    each("slot", it.slot);
    each("to", it.to);
    each("sequence", it.sequence);
    each("last", it.last);
    each("from", it.from);
  }
};

/// A sample that could not be sent.
struct Unsent {
  static constexpr std::string_view kKind = "unsent";
  Text slot = {};
  Text to = {};
  Text why = {};

  static void fields(auto& it, auto&& each) {
    each("slot", it.slot);
    each("to", it.to);
    each("why", it.why);
  }
};

/// Malformed content was refused; once per slot, origin and field.
struct Dropped {
  static constexpr std::string_view kKind = "dropped";
  Text slot = {};
  Text origin = {};
  Text field = {};
  Text why = {};

  static void fields(auto& it, auto&& each) {
    each("slot", it.slot);
    each("origin", it.origin);
    each("field", it.field);
    each("why", it.why);
  }
};

/// The DDS vendor refused to connect or disconnect a channel.
struct Transport {
  static constexpr std::string_view kKind = "transport";
  Text channel = {};
  Text why = {};

  static void fields(auto& it, auto&& each) {
    each("channel", it.channel);
    each("why", it.why);
  }
};

/// Truth: the radio from one node to another carries samples, or no longer; capacity in bit/s. "*"
/// as both ends: every link that no other line is about.
struct Link {
  static constexpr std::string_view kKind = "link";
  Text from = {};
  Text to = {};
  bool up = false;
  std::optional<double> capacity = {};

  static void fields(auto& it, auto&& each) {
    each("from", it.from);
    each("to", it.to);
    each("up", it.up);
    each("capacity", it.capacity);
  }
};

}  // namespace skein::journal::lines
