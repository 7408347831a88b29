// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/frontier.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

#include "skein/foundation/fingerprint.hpp"

namespace skein::temporal {

namespace {

using Weight = Ticks FrontierArc::*;

bool is_beyond(Ticks value) {
  return value != kInfinite && value != kMinusInfinite && (value > kFarthest || value < -kFarthest);
}

/// The paths of one course from one node, through nodes that are not kept.
class Paths {
 public:
  Paths(std::size_t nodes, std::size_t kept, const std::vector<FrontierLink>& links, Weight weight)
      : kept_(kept), weight_(weight), out_(nodes) {
    for (const FrontierLink& link : links)
      if (link.*weight != kMinusInfinite) out_[link.from].push_back(&link);
  }

  /// Nothing: a cycle asks for more and more.
  std::optional<std::vector<Ticks>> from(std::uint32_t source) const {
    std::vector<Ticks> reached(out_.size(), kMinusInfinite);
    std::vector<std::size_t> visits(out_.size(), 0);
    std::vector<bool> queued(out_.size(), false);
    std::deque<std::uint32_t> queue{source};
    reached[source] = 0;
    while (!queue.empty()) {
      const std::uint32_t node = queue.front();
      queue.pop_front();
      queued[node] = false;
      if (++visits[node] > out_.size()) return std::nullopt;
      for (const FrontierLink* link : out_[node]) {
        const Ticks there = sum(reached[node], link->*weight_);
        if (link->to == source || there <= reached[link->to]) continue;
        reached[link->to] = there;
        if (link->to < kept_ || queued[link->to]) continue;
        queued[link->to] = true;
        queue.push_back(link->to);
      }
    }
    return reached;
  }

 private:
  static Ticks sum(Ticks a, Ticks b) {
    return a == kInfinite || b == kInfinite ? kInfinite : std::clamp(a + b, -kFarthest, kFarthest);
  }

  std::size_t kept_;
  Weight weight_;
  std::vector<std::vector<const FrontierLink*>> out_;
};

}  // namespace

MeetingId order_of(const std::string& waiter) {
  Fingerprint name;
  name.put(std::string("air of ")).put(waiter);
  return MeetingId{1} << 52U | name.value() >> 12U;
}

std::optional<std::string> fault_of(const Frontier& frontier) {
  if (frontier.meetings.size() > kMostMeetings)
    return "more than " + std::to_string(kMostMeetings) + " meetings";
  std::set<MeetingId> seen;
  for (const Meeting& meeting : frontier.meetings)
    if (!seen.insert(meeting.id).second)
      return "meeting " + std::to_string(meeting.id) + " is there twice";
  const std::uint32_t kept = Frontier::arrival_of(frontier.meetings.size());
  const std::size_t nodes = kept + kMostInnerNodes;
  for (std::size_t i = 0; i < frontier.arcs.size(); ++i) {
    const FrontierArc& arc = frontier.arcs[i];
    const std::string which = "arc " + std::to_string(i);
    if (arc.from >= nodes || arc.to >= nodes) return which + " names a node that is not there";
    if (arc.from == arc.to) return which + " leads from a node to itself";
    if (is_beyond(arc.soonest) || is_beyond(arc.slowest) || is_beyond(arc.latest))
      return which + " is beyond " + std::to_string(kFarthest) + " ns";
    const bool is_date = arc.from < 2;
    if ((arc.soonest == kInfinite && !is_date) || arc.latest == kInfinite)
      return which + " asks for for ever";
  }
  for (const FrontierBasis& basis : frontier.bases) {
    if (basis.node < 2 || basis.node >= kept) return "a basis of what is at no meeting";
    if (basis.ends.size() > kMostMeetings) return "a basis of too much";
  }
  return std::nullopt;
}

Frontier eliminated(const Frontier& whole) {
  const std::uint32_t kept = Frontier::arrival_of(whole.meetings.size());
  std::size_t nodes = kept;
  for (const FrontierArc& arc : whole.arcs)
    nodes = std::max<std::size_t>({nodes, arc.from + std::size_t{1}, arc.to + std::size_t{1}});
  return {whole.meetings, eliminate(nodes, kept, whole.arcs), {}};
}

std::vector<FrontierArc> eliminate(std::size_t nodes, std::size_t kept,
                                   const std::vector<FrontierLink>& links) {
  std::vector<FrontierArc> between(kept * kept);
  for (const Weight weight : {&FrontierArc::soonest, &FrontierArc::slowest, &FrontierArc::latest}) {
    const Paths paths(nodes, kept, links, weight);
    std::vector<std::vector<Ticks>> reached;
    for (std::uint32_t from = 0; from < kept; ++from) {
      auto paths_from = paths.from(from);
      if (!paths_from) break;
      reached.push_back(std::move(*paths_from));
    }
    if (reached.size() < kept) continue;
    for (std::uint32_t from = 0; from < kept; ++from)
      for (std::uint32_t to = 0; to < kept; ++to)
        if (to != from) between[from * kept + to].*weight = reached[from][to];
  }
  std::vector<FrontierArc> arcs;
  for (std::uint32_t i = 0; i < between.size(); ++i) {
    FrontierArc& arc = between[i];
    arc.from = i / static_cast<std::uint32_t>(kept);
    arc.to = i % static_cast<std::uint32_t>(kept);
    if (std::max({arc.soonest, arc.slowest, arc.latest}) != kMinusInfinite) arcs.push_back(arc);
  }
  return arcs;
}

}  // namespace skein::temporal
