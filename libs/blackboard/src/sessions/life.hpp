// SPDX-License-Identifier: Apache-2.0
// Lives of one peer: incarnations, each with the receiving half of its event session.
#pragma once

#include <cstdint>

#include "sessions/incoming_events.hpp"
#include "sessions/incoming_parts.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// Of a long state so many parts may come before it is acknowledged: less than is under way.
inline constexpr std::uint32_t kQuietParts = 8;

/// What was heard of one incarnation of a peer.
struct Life {
  Life(NodeNumber self, std::uint64_t self_incarnation) : incoming(self, self_incarnation) {}
  void commit() {
    incoming.commit();
    parts.commit();
  }

  std::uint64_t incarnation = 0;       ///< 0: no heartbeat was heard
  std::uint64_t newest_heartbeat = 0;  ///< its sequence number
  Duration last_heard;                 ///< steady
  IncomingEvents incoming;
  IncomingParts parts;  ///< of events
  IncomingParts state_parts{wire::SlotClass::kState, kQuietParts};
};

/// Another life beside the one that is taken for the peer. It is forgotten after three heartbeat
/// periods of silence. It is one of these:
/// - a newcomer: its events came before its first heartbeat, with which it becomes the peer;
/// - the former life: a later one was heard while it was not yet silent, or it is heard while the
///   later one is silent. It becomes the peer again with kWords new heartbeats over at least two
///   periods, since then it is alive;
/// - a second process, which is refused: the former life has become the peer again. It becomes the
///   peer once that is silent.
///
/// So a restart is followed at once, and of two processes that run at the same time the one that
/// was heard first is the peer. Source: docs/decisions/0072, 0129.
struct Rival {
  /// New heartbeats of the former life that show that it is alive: some may only be late.
  static constexpr int kWords = 3;

  Life life;
  Duration since = {};  ///< steady time when the present life became the peer
  int words = 0;        ///< new heartbeats of the former life since then
  bool is_refused = false;
};

/// Why samples of another life are refused while the peer is heard.
inline const wire::Violation kOfSecond{
    "header.incarnation", "is of a second node with this name, while the first is heard"};
inline const wire::Violation kOfOlderSecond{"header.incarnation",
                                            "is an older one: a second node has this name"};

}  // namespace skein::blackboard
