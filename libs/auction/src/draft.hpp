// SPDX-License-Identifier: Apache-2.0
// Routes with some tasks on sale: where each could go, what that would be worth, and when all
// begin.
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

/// A member's route as it stands in the books, with what the member last said about it.
struct BookedRoute {
  MemberNumber member;
  std::vector<TaskNumber> tasks;
  std::uint32_t fixed = 0;  ///< so many at its beginning are not moved
  std::vector<Leg> legs;    ///< to each task, then to the end
  double free_from = 0;     ///< [s]
};

/// Where a task would go: with these members, each at this position of its route.
struct Placing {
  struct Spot {
    std::uint32_t route = 0;
    std::uint32_t position = 0;
  };
  std::uint32_t item = 0;
  std::vector<Spot> spots;
  Value value;  ///< of all routes with it
};

/// Winner determination works on one. A placing is judged without being tried, by the longest way
/// to and from it (as in job shops): exact, since a detour never shortens another way. Cost:
/// schedule() is linear; placings of one item: gaps, times groups if it is joint.
class Draft {
 public:
  /// What is outside of the draft only adds to cost and end. `catalogue` and offers outlive it.
  Draft(const Catalogue& catalogue, Aim aim, std::vector<TaskNumber> items);
  void add_rest(double cost, double end, std::uint32_t unsold);
  /// `offer`: of a member that was called; its route is the one of the call.
  void add(const BookedRoute& route, const Offer* offer);

  /// Back to the routes without the items, and their dates. False: they have none.
  bool restore();
  /// Dates of everything placed. False: a circle of waits, or a deadline that does not hold.
  bool schedule();
  /// Best first, at most `most`, and of different groups.
  std::vector<Placing> placings(std::uint32_t item, std::size_t most) const;
  /// Places an item and dates everything. False: it cannot be; nothing has changed.
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
  std::vector<Leg> legs(std::size_t route) const;

 private:
  struct Stop {
    std::uint32_t node;
    std::int32_t gap;  ///< of the call's route, after which it stands; -1: an item
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
    double spent = 0;          ///< energy of the items placed
    std::vector<Leg> in, out;  ///< item by gap; kNoWay: not offered
    std::vector<Leg> between;  ///< item by item
    std::vector<double> item_energy;
    std::vector<bool> willing;
  };
  struct Node {
    std::uint32_t task = 0;
    bool placed = false;
    double start = 0, tail = 0, latest = 0;
    std::uint32_t rank = 0, waiting = 0;
    std::vector<Placing::Spot> spots;
    std::vector<std::uint32_t> before, after;
  };
  // One gap of one route for an item.
  struct Gap {
    Placing::Spot spot;
    double arrival = 0;  ///< [s]
    double rest = 0;     ///< from the end of the item to the end of all after it [s]
    double by = 0;       ///< when the item must have ended
    double cost = 0;     ///< added
  };
  // The best gaps of one group.
  struct Best {
    bool found = false;
    Value value;
    std::vector<Gap> gaps;
    void consider(const std::optional<Value>& judged, std::span<const Gap> group);
    Placing placing(std::uint32_t item) const;
  };
  std::uint32_t node_of(TaskNumber task);
  void link(std::uint32_t node);
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
  double rest_cost_ = 0, rest_end_ = 0;
  std::uint32_t rest_unsold_ = 0;
  double cost_ = 0, end_ = 0;
  std::uint32_t unsold_ = 0;
};

}  // namespace skein::auction
