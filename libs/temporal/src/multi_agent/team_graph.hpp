// SPDX-License-Identifier: Apache-2.0
// The frontiers of a team's plans, joined to one graph.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/temporal/frontier.hpp"

namespace skein::temporal {

using Weight = Ticks FrontierArc::*;

bool is_in(const std::vector<std::string>& names, const std::string& name);
/// Whether the date of a node is the same in all courses (fastest, slowest, latest).
bool is_fact(const Frontier& frontier, std::uint32_t node);
/// Saturating sum of dates, since a node in a circle of waits gets later with every round.
Ticks sum(Ticks a, Ticks b);

/// Reduces whole networks to frontiers, by eliminating their inner nodes.
std::map<std::string, Frontier> without_inner_nodes(std::map<std::string, Frontier> known);

/// All frontiers in one graph, in which the end of a meeting at its receivers follows the arrivals
/// of its senders. Lifetime: refers to `known`. Precondition: no inner nodes.
class TeamGraph {
 public:
  using Known = std::map<std::string, Frontier>;
  /// `self`: of others' dates that rest on what it waits for itself, it knows that they never come.
  TeamGraph(const Known& known, const std::map<std::string, MissionTime>& unheard_since,
            const std::string& self);

  std::uint32_t node(const std::string& agent, std::uint32_t local) const {
    return local < 2 ? local : first_.at(agent) + local - 2;
  }
  struct Awaited {
    const std::string* agent;
    std::uint32_t arrival;
    bool there;  ///< the agent has arrived
  };
  /// The arrivals that must precede an end.
  const std::vector<Awaited>& awaited(std::uint32_t end) const;

  /// The dates of the origin and the present as sources of propagation; kMinusInfinite (for limits
  /// kInfinite): not a source.
  struct Since {
    Ticks origin = 0, present = 0;
  };
  /// Earliest dates of a course. Nodes in a circle of waits never come.
  std::vector<Ticks> earliest(Weight weight, const Since& since) const;

  /// Which agent of the circles of waits through an end gives way, and how. In a circle there is
  /// always an agent that has a meeting before another one of a smaller number; putting these two
  /// in order does not disorder any other two, so the procedure terminates.
  struct Yield {
    const std::string* agent = nullptr;
    MeetingId meeting = 0, behind = 0;
    bool there = false;  ///< the agent has arrived at the former meeting
    /// Whether this agent is preferred for giving way.
    bool before(const Yield& other) const;
  };
  std::optional<Yield> yield_at(std::uint32_t end) const;

  struct Limit {
    Ticks latest = kInfinite;
    const std::string* of = nullptr;  ///< whose bound it is
    std::size_t arc = 0;              ///< by which it was found
  };
  /// Latest dates with greatest durations, from the upper bounds of all agents except `without`.
  std::vector<Limit> latest(const std::string& without, const Since& since) const;
  /// Excludes the nodes marked in `never` from propagation from now on.
  void leave_out(const std::vector<bool>& never);
  /// The agents whose bounds a limit follows from, in order. Precondition: the limit is from
  /// `latest`, and bounded.
  std::vector<std::string> passed(const std::vector<Limit>& limits, std::uint32_t node) const;

  /// The ends of meetings on which an arrival rests, as FrontierBasis has them. Precondition: of
  /// `self`.
  std::vector<EndOf> basis_of(std::uint32_t arrival) const;

  /// Whether the arc leads from the end of a meeting to another meeting.
  static bool goes_on(const FrontierArc& arc);

 private:
  struct Arc {
    FrontierArc arc;
    const std::string* agent;             ///< whose; null: of a meeting
    const FrontierBasis* past = nullptr;  ///< of a limit that rests on others'
  };

  void enter(const std::string& agent, const Frontier& frontier, Ticks last_word);
  void join(const std::string& agent, std::size_t which);
  void see_circles();
  std::vector<bool> reached_from(std::uint32_t start, Weight weight = &FrontierArc::soonest) const;
  bool awaits(std::uint32_t end, const EndOf& own, bool certainly) const;
  std::set<EndOf> ends_before(std::uint32_t arrival, Weight weight) const;
  bool has_end(const EndOf& one) const;
  bool bounds(const Arc& one, const std::string& without) const;
  std::vector<bool> revise(const std::string& without, std::vector<Limit>& limit) const;
  std::vector<bool> revise(Weight weight, std::vector<Ticks>& date) const;

  const Known& known_;
  std::string self_;
  std::uint32_t nodes_ = 2;
  std::map<std::string, std::uint32_t> first_;
  std::vector<Arc> arcs_;
  std::map<std::uint32_t, std::vector<Awaited>> awaited_;
  std::map<std::uint32_t, const FrontierBasis*> basis_;
  std::map<std::uint32_t, EndOf> end_of_;  ///< the end that a node is
};

}  // namespace skein::temporal
