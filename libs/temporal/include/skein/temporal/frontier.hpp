// SPDX-License-Identifier: Apache-2.0
// The frontier of an agent's network: what other agents need for temporal consistency with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Identifies a meeting of several agents, the same at all of them.
using MeetingId = std::uint64_t;

/// A meeting: its end at each receiver follows the arrival of every sender.
struct Meeting {
  MeetingId id = 0;
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  bool operator==(const Meeting&) const = default;
};

/// The meeting that represents an order between paths (spec 6.4): the receiver gets its air once
/// the senders have left it. It may get other air earlier, so nothing follows for its earliest
/// dates. Ids of orders are from 2^52 to 2^53, one for each waiting agent.
MeetingId order_of(const std::string& waiter);
inline bool is_order(MeetingId id) { return id >> 52U == 1; }

inline constexpr std::size_t kMostMeetings = 256;
inline constexpr std::uint32_t kMostInnerNodes = 4096;
/// 52 days: sums of such figures stay within the engines' range.
inline constexpr Ticks kFarthest = Ticks{1} << 52;

/// Lower bounds on to - from [ns], one for each course (assumption on durations); kMinusInfinite:
/// no bound.
struct FrontierArc {
  std::uint32_t from = 0, to = 0;
  Ticks soonest = kMinusInfinite;  ///< least durations, each task as early as possible
  Ticks slowest =
      kMinusInfinite;  ///< greatest durations, as early as possible; kInfinite: unbounded
  Ticks latest = kMinusInfinite;  ///< greatest durations, with all upper bounds
  bool operator==(const FrontierArc&) const = default;
};

/// The end of a meeting at one of its receivers.
struct EndOf {
  std::string agent;
  MeetingId meeting = 0;
  auto operator<=>(const EndOf&) const = default;
};

/// The contributions of other agents to the dates of a node. Of an arrival: the ends that it rests
/// on, and, from the first end of an order between paths on, those that only its greatest date
/// rests on. Of an end: the agents whose bounds limit it, in their order.
struct FrontierBasis {
  std::uint32_t node = 0;
  std::vector<EndOf> ends;
  bool operator==(const FrontierBasis&) const = default;
};

/// An agent's network without its inner nodes: its macro-network (DIP-M) over the origin, the
/// present (the same instant for all agents), and for each of its meetings arrival and end. Without
/// `bases` it contains nothing that follows from other agents' frontiers; with `bases` it contains
/// the dates computed by the agent (DIP-L). Nodes after those of the meetings are inner ones that
/// were not eliminated (DIP-G, CIP). Source: M 4.3; spec 5.3.
struct Frontier {
  static constexpr std::uint32_t kOrigin = 0, kPresent = 1;
  static constexpr std::uint32_t arrival_of(std::size_t meeting) {
    return static_cast<std::uint32_t>(2 + 2 * meeting);
  }
  static constexpr std::uint32_t end_of(std::size_t meeting) { return arrival_of(meeting) + 1; }

  std::vector<Meeting> meetings;  ///< their ids differ
  std::vector<FrontierArc> arcs;
  std::vector<FrontierBasis> bases = {};
  bool operator==(const Frontier&) const = default;
};

/// The first fault of a frontier, in words: a duplicate meeting, more than kMostMeetings, an arc
/// with unknown nodes or from a node to itself, a finite figure beyond ±kFarthest, an entry of
/// `bases` that is not for a node of a meeting.
std::optional<std::string> fault_of(const Frontier& frontier);

/// A link of the network from which a frontier is made; bounds as in FrontierArc.
using FrontierLink = FrontierArc;

/// The arcs that remain when all but the first `kept` of `nodes` nodes are eliminated: the longest
/// path over eliminated nodes, in each course. Arcs without a bound are left out; a course with a
/// positive cycle gives no bounds. Cost:
/// O(kept · nodes · links) at worst, kept · links where links follow the order of time.
std::vector<FrontierArc> eliminate(std::size_t nodes, std::size_t kept,
                                   const std::vector<FrontierLink>& links);

/// The frontier with its inner nodes eliminated.
Frontier eliminated(const Frontier& whole);

}  // namespace skein::temporal
