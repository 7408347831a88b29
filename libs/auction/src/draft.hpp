// SPDX-License-Identifier: Apache-2.0
// The allocation problem of one round: routes, the tasks on sale, their possible positions in the
// routes with the resulting values, and the dates of all tasks.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "skein/auction/aim.hpp"
#include "skein/auction/catalogue.hpp"
#include "skein/auction/message.hpp"

namespace skein::auction {

/// A member's route as the auctioneer has booked it, with the figures that the member last gave.
struct BookedRoute {
  MemberNumber member;
  std::vector<TaskNumber> tasks;
  std::uint32_t fixed = 0;  ///< the first `fixed` tasks are not moved
  std::vector<Leg> legs;    ///< to each task, then to the end
  double free_from = 0;     ///< [s]
};

/// A possible insertion of an item: a position in the route of each member of a group.
struct Placing {
  struct Spot {
    std::uint32_t route = 0;
    std::uint32_t position = 0;
  };
  std::uint32_t item = 0;
  std::vector<Spot> spots;
  Value value;  ///< of the whole allocation with this insertion
};

/// The working state of winner determination. A placing is evaluated without inserting it, from the
/// longest paths to and from the item (head and tail, as in job-shop scheduling); this is exact,
/// since an insertion never shortens another path, but for delays, whose way is flown after the
/// first has ended: there it is an estimate. Cost: schedule() is linear in tasks, times delays with
/// a greatest; placings() is linear in gaps, times the number of groups for a joint task.
class Draft {
 public:
  /// `catalogue` outlives the draft.
  Draft(const Catalogue& catalogue, Aim aim, std::vector<TaskNumber> items);
  /// The share of the value that is outside the draft.
  struct Rest {
    double cost = 0;
    double end = 0;   ///< the latest of a route [s]
    double ends = 0;  ///< sum of the ends of tasks [s]
    std::uint32_t unsold = 0;
  };
  void set_rest(const Rest& rest) { rest_ = rest; }
  /// `offer`: of a member that was called, for exactly this route; null: items cannot go to it.
  void add(const BookedRoute& route, const Offer* offer);

  /// Removes all items from the routes and dates the rest. False: those routes are infeasible.
  bool restore();
  /// Computes the dates of all placed tasks. False: precedences form a cycle, or a deadline is
  /// missed.
  bool schedule();
  /// The best placing of each group of members, best group first, at most `most`.
  std::vector<Placing> placings(std::uint32_t item, std::size_t most) const;
  /// Inserts an item and dates all tasks. False: infeasible, and nothing has changed.
  bool place(const Placing& placing);

  Value value() const;
  std::size_t item_count() const { return items_.size(); }
  bool placed(std::uint32_t item) const { return nodes_[item].placed; }
  std::size_t route_count() const { return routes_.size(); }
  MemberNumber member(std::size_t route) const { return routes_[route].member; }
  std::vector<TaskNumber> tasks(std::size_t route) const;
  double start(TaskNumber task) const;
  double end(std::size_t route) const;
  double cost(std::size_t route) const;
  /// The sum of the ends of the tasks of a route [s].
  double ends(std::size_t route) const;
  std::vector<Leg> legs(std::size_t route) const;

 private:
  struct Stop {
    std::uint32_t node;
    std::int32_t gap;  ///< position in the route of the call; -1: an item
    Leg leg;
  };
  struct Route {
    MemberNumber member;
    Abilities abilities = 0;
    double free_from = 0;
    double energy = 0;
    std::uint32_t fixed = 0;
    bool called = false;
    std::vector<Stop> stops, base;
    Leg home, base_home;
    double spent = 0;          ///< energy that the placed items add
    std::vector<Leg> in, out;  ///< row per item, column per gap; kNoWay: not offered
    std::vector<Leg> between;  ///< row per item left, column per item reached
    std::vector<double> item_energy;
    std::vector<bool> willing;
  };
  struct Arc {
    std::uint32_t node;
    Delay delay;
  };
  struct Node {
    std::uint32_t task = 0;
    bool placed = false;
    double start = 0, tail = 0, latest = 0;
    double put_off = 0;  ///< begins no sooner, or another would come too late after it [s]
    std::uint32_t rank = 0, waiting = 0;
    std::vector<Placing::Spot> spots;
    std::vector<Arc> before, after;
  };
  // One position in one route at which an item could be inserted.
  struct Gap {
    Placing::Spot spot;
    double arrival = 0;  ///< [s]
    double in = 0;       ///< the way to the item [s]
    double out = 0;      ///< the way from it [s]
    double rest = 0;     ///< longest time from the end of the item to the end of its successors [s]
    double by = 0;       ///< latest end of the item [s]
    double cost = 0;     ///< of the detour
  };
  // The best combination of gaps for one group of members.
  struct Best {
    bool found = false;
    Value value;
    std::vector<Gap> gaps;
    void consider(const std::optional<Value>& judged, std::span<const Gap> group);
    Placing placing(std::uint32_t item) const;
  };
  std::uint32_t node_of(TaskNumber task);
  void link(std::uint32_t node);
  double begins_after(const Arc& before, double way) const;
  double way_to(std::uint32_t node, std::span<const Gap> group = {}) const;
  bool put_off();
  Leg way_in(const Route& route, std::uint32_t item, std::size_t position) const;
  Leg way_out(const Route& route, std::uint32_t item, std::size_t position) const;
  std::vector<Gap> gaps(std::uint32_t item, std::uint32_t route) const;
  std::optional<Value> judge(std::uint32_t item, std::span<const Gap> group) const;
  std::vector<Placing> single_placings(std::uint32_t item) const;
  std::vector<Placing> joint_placings(std::uint32_t item) const;
  void combine(std::uint32_t item, const std::vector<std::vector<Gap>>& gaps,
               std::vector<Gap>& chosen, Best& best) const;
  Leg leg_at(const Route& route, std::size_t position) const;
  bool suffices(const Task& task, std::uint32_t group,
                const std::vector<std::vector<Gap>>& partners) const;
  bool circular(std::uint32_t item, std::span<const Gap> group) const;
  bool forward();
  bool backward();
  void insert(const Placing& placing);
  const Task& task_of(const Node& node) const { return catalogue_->task(node.task); }

  const Catalogue* catalogue_;
  Aim aim_;
  std::vector<TaskNumber> items_;
  std::vector<Node> nodes_;  ///< the items first
  std::vector<std::int32_t> node_of_task_;
  std::vector<Route> routes_;
  std::vector<std::uint32_t> order_;
  Rest rest_;
  double cost_ = 0, end_ = 0, ends_ = 0;
  std::uint32_t unsold_ = 0;
};

}  // namespace skein::auction
