// SPDX-License-Identifier: Apache-2.0
// What others need to know of an agent's network to keep theirs consistent with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Names what several agents do together, the same at all of them.
using MeetingId = std::uint64_t;

/// Whoever receives goes on once every sender has come: its end follows each sender's arrival.
struct Meeting {
  MeetingId id = 0;
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  bool operator==(const Meeting&) const = default;
};

/// An order between ways (spec 6.4) is a meeting as well: who receives has its air once the senders
/// have left it. It may get air elsewhere before, so of the earliest dates nothing follows from it.
/// Numbers of orders are those from 2^52 to 2^53, one for each who waits.
MeetingId order_of(const std::string& waiter);
inline bool is_order(MeetingId id) { return id >> 52U == 1; }

inline constexpr std::size_t kMostMeetings = 256;
inline constexpr std::uint32_t kMostInnerNodes = 4096;
/// 52 days: sums of such figures stay within the engines' range.
inline constexpr Ticks kFarthest = Ticks{1} << 52;

/// to - from >= each of these [ns], in one course of nature; kMinusInfinite: nothing is said.
struct FrontierArc {
  std::uint32_t from = 0, to = 0;
  Ticks soonest = kMinusInfinite;  ///< all durations least, each task as early as it may be
  Ticks slowest = kMinusInfinite;  ///< all greatest, likewise; kInfinite: no figure bounds it
  Ticks latest = kMinusInfinite;   ///< all greatest, with all that bounds from above
  bool operator==(const FrontierArc&) const = default;
};

/// The end of a meeting at one of those who receive there.
struct EndOf {
  std::string agent;
  MeetingId meeting = 0;
  auto operator<=>(const EndOf&) const = default;
};

/// What others said in the dates of a node. Of an arrival: the ends on which it rests, and behind
/// the first one of an order between ways those on which its greatest date alone rests; of an end:
/// whose bounds it has to be kept to for, in their order.
struct FrontierBasis {
  std::uint32_t node = 0;
  std::vector<EndOf> ends;
  bool operator==(const FrontierBasis&) const = default;
};

/// An agent's network without its inner nodes: its macro-network (DIP-M) over the origin, the
/// present, which is the same instant for all agents, and for each of its meetings its arrival and
/// its end. It says nothing that follows from what others said, unless it has `bases`: then it is
/// the dates that the agent has found (DIP-L). Nodes behind those of the meetings are inner ones
/// that were not eliminated (DIP-G, CIP). Source: M 4.3; spec 5.3.
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

/// What makes no frontier, in words: a meeting given twice, more than kMostMeetings, an arc between
/// nodes that are not there or from a node to itself, a figure beyond ±kFarthest that is not
/// infinite, what `bases` says of no node of a meeting.
std::optional<std::string> fault_of(const Frontier& frontier);

/// A link of a network that a frontier is to be made of: to - from >= each.
using FrontierLink = FrontierArc;

/// The arcs that remain when all but the first `kept` of so many nodes are eliminated: of paths
/// whose inner nodes are not kept, the one that asks for most, in each course. Without arcs that
/// say nothing. A course in which a cycle asks for more than nothing says nothing. Cost:
/// O(kept · nodes · links) at worst, kept · links where links follow the order of time.
std::vector<FrontierArc> eliminate(std::size_t nodes, std::size_t kept,
                                   const std::vector<FrontierLink>& links);

/// A frontier with inner nodes without them.
Frontier eliminated(const Frontier& whole);

}  // namespace skein::temporal
