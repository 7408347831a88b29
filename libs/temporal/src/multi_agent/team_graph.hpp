// SPDX-License-Identifier: Apache-2.0
// What a team has told each other of its plans, as one graph.
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
/// A date that is no other in any course.
bool is_fact(const Frontier& frontier, std::uint32_t node);
/// Who waits for himself comes later with every round.
Ticks sum(Ticks a, Ticks b);

/// Whole networks become frontiers, whoever told them.
std::map<std::string, Frontier> without_inner_nodes(std::map<std::string, Frontier> known);

/// All frontiers in one graph, in which who receives waits for who sends. Lifetime: refers to
/// `known`. Precondition: no inner nodes.
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
    bool there;  ///< it has come
  };
  /// Who has to come before an end.
  const std::vector<Awaited>& awaited(std::uint32_t end) const;

  /// The dates of the origin and the present from which others follow; kMinusInfinite, or, of
  /// limits, kInfinite: what follows from it does not count.
  struct Since {
    Ticks origin = 0, present = 0;
  };
  /// Earliest dates of a course. Who waits for himself never comes.
  std::vector<Ticks> earliest(Weight weight, const Since& since) const;

  /// Of those who wait in the circles that pass through an end: who gives way, and how. There is
  /// always one who has a meeting before another of a smaller number, and whoever puts these in
  /// order brings no other two out of it: so it comes to an end.
  struct Yield {
    const std::string* agent = nullptr;
    MeetingId meeting = 0, behind = 0;
    bool there = false;  ///< at the former
    /// It gives way before the other.
    bool before(const Yield& other) const;
  };
  std::optional<Yield> yield_at(std::uint32_t end) const;

  struct Limit {
    Ticks latest = kInfinite;
    const std::string* of = nullptr;  ///< whose bound it is
    std::size_t arc = 0;              ///< by which it was found
  };
  /// Latest dates by what all but `without` bound from above, when all lasts longest.
  std::vector<Limit> latest(const std::string& without, const Since& since) const;
  /// Nothing bounds, and nothing is bounded by, what is marked in `never` from here on.
  void leave_out(const std::vector<bool>& never);
  /// Whose bounds a limit was found by, in their order. Precondition: of `latest`, and bounded.
  std::vector<std::string> passed(const std::vector<Limit>& limits, std::uint32_t node) const;

  /// The ends of meetings on which an arrival rests, as FrontierBasis has them. Precondition: of
  /// `self`.
  std::vector<EndOf> basis_of(std::uint32_t arrival) const;

  /// From the end of a meeting to another one.
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
