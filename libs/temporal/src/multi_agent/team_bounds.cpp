// SPDX-License-Identifier: Apache-2.0
// What agents tell each other that keep to DIP-L.
#include <algorithm>
#include <vector>

#include "multi_agent/team_graph.hpp"
#include "skein/temporal/team_dates.hpp"

namespace skein::temporal {

namespace {

constexpr Ticks kNothing = kMinusInfinite;

/// The dates of one agent, as seen from the origin and from the present, so that they move with the
/// clock without being told again.
class Bounds {
 public:
  Bounds(TeamGraph& graph, const std::string& self, const Frontier& own,
         const std::string& receiver)
      : graph_(graph),
        self_(self),
        own_(own),
        receiver_(receiver),
        since_origin_(dates({0, kNothing})),
        since_present_(dates({kNothing, 0})) {
    // Limits of what never comes would be passed on around its circle for ever.
    std::vector<bool> never;
    for (const Ticks date : since_origin_.soonest) never.push_back(date == kInfinite);
    graph.leave_out(never);
    until_origin_ = graph.latest(receiver, {0, kInfinite});
    until_present_ = graph.latest(receiver, {kInfinite, 0});
  }

  Frontier all() {
    for (std::size_t i = 0; i < own_.meetings.size(); ++i) {
      const Meeting& meeting = own_.meetings[i];
      const bool shared = is_in(meeting.senders, receiver_) || is_in(meeting.receivers, receiver_);
      if (!shared && !never(i)) continue;
      told_.push_back(i);
      word_.meetings.push_back(meeting);
    }
    for (std::size_t k = 0; k < told_.size(); ++k) {
      arrival(k);
      end(k);
    }
    ways_on();
    return std::move(word_);
  }

 private:
  struct Dates {
    std::vector<Ticks> soonest, slowest;
  };
  Dates dates(const TeamGraph::Since& since) const {
    return {graph_.earliest(&FrontierArc::soonest, since),
            graph_.earliest(&FrontierArc::slowest, since)};
  }
  std::uint32_t arrival_of(std::size_t which) const {
    return graph_.node(self_, Frontier::arrival_of(which));
  }
  std::uint32_t end_of(std::size_t which) const {
    return graph_.node(self_, Frontier::end_of(which));
  }
  bool never(std::size_t which) const {
    return since_origin_.soonest[arrival_of(which)] == kInfinite ||
           since_origin_.soonest[end_of(which)] == kInfinite;
  }
  void say(const FrontierArc& arc) {
    if (std::max({arc.soonest, arc.slowest, arc.latest}) != kNothing) word_.arcs.push_back(arc);
  }

  void arrival(std::size_t k) {
    const std::uint32_t node = arrival_of(told_[k]), local = Frontier::arrival_of(k);
    say({Frontier::kOrigin, local, since_origin_.soonest[node], since_origin_.slowest[node],
         kNothing});
    // Of what never comes the present adds nothing.
    const auto now = [&](const auto& origin, const auto& present) {
      return origin[node] == kInfinite ? kNothing : present[node];
    };
    say({Frontier::kPresent, local, now(since_origin_.soonest, since_present_.soonest),
         now(since_origin_.slowest, since_present_.slowest), kNothing});
    for (const FrontierArc& arc : own_.arcs)
      if (arc.from == Frontier::arrival_of(told_[k]) && arc.to == Frontier::kOrigin)
        say({local, Frontier::kOrigin, kNothing, kNothing, arc.latest});
    auto basis = graph_.basis_of(node);
    if (!basis.empty()) word_.bases.push_back({local, std::move(basis)});
  }

  // Only who receives waits for the others.
  void end(std::size_t k) {
    const std::uint32_t node = end_of(told_[k]), local = Frontier::end_of(k);
    const Ticks origin = until_origin_[node].latest, present = until_present_[node].latest;
    FrontierBasis basis{local, {}};
    const auto limit = [&](const auto& limits, Ticks latest, std::uint32_t to) {
      if (latest == kInfinite) return;
      say({local, to, kNothing, kNothing, -latest});
      for (const std::string& agent : graph_.passed(limits, node))
        basis.ends.push_back({agent, word_.meetings[k].id});
    };
    limit(until_present_, present, Frontier::kPresent);
    limit(until_origin_, origin, Frontier::kOrigin);
    if (!basis.ends.empty()) word_.bases.push_back(std::move(basis));
  }

  void ways_on() {
    for (const FrontierArc& arc : own_.arcs) {
      if (!TeamGraph::goes_on(arc)) continue;
      const std::size_t from = (arc.from - 2) / 2, to = (arc.to - 2) / 2;
      if (!never(from) || !never(to)) continue;
      const auto place = [&](std::size_t which) {
        return static_cast<std::size_t>(std::find(told_.begin(), told_.end(), which) -
                                        told_.begin());
      };
      say({Frontier::end_of(place(from)), Frontier::arrival_of(place(to)), arc.soonest, arc.slowest,
           kNothing});
    }
  }

  const TeamGraph& graph_;
  const std::string& self_;
  const Frontier& own_;
  const std::string& receiver_;
  Dates since_origin_, since_present_;
  std::vector<TeamGraph::Limit> until_origin_, until_present_;
  std::vector<std::size_t> told_;  ///< of the own meetings
  Frontier word_;
};

}  // namespace

Frontier TeamDates::bounds_for(const std::string& receiver) const {
  const auto known = without_inner_nodes(known_);
  const auto own = known.find(self_);
  if (own == known.end() || own->second.meetings.empty()) return {};
  TeamGraph graph(known, unheard_since_, self_);
  return Bounds(graph, self_, own->second, receiver).all();
}

}  // namespace skein::temporal
