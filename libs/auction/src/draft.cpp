// SPDX-License-Identifier: Apache-2.0
#include "draft.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::auction {

Draft::Draft(const Catalogue& catalogue, Aim aim, std::vector<TaskNumber> items)
    : catalogue_(&catalogue),
      aim_(aim),
      items_(std::move(items)),
      node_of_task_(catalogue.size(), -1) {
  for (const TaskNumber item : items_) node_of(item);
}

std::uint32_t Draft::node_of(TaskNumber task) {
  std::int32_t& known = node_of_task_[catalogue_->index(task)];
  if (known < 0) {
    known = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().task = catalogue_->index(task);
    link(static_cast<std::uint32_t>(known));
  }
  return static_cast<std::uint32_t>(known);
}

// Precedences to and from the tasks that are here already.
void Draft::link(std::uint32_t node) {
  const auto join = [&](std::uint32_t first, std::uint32_t then) {
    const Delay delay = catalogue_->delay(nodes_[first].task, nodes_[then].task);
    nodes_[first].after.push_back({then, delay});
    nodes_[then].before.push_back({first, delay});
  };
  for (const std::uint32_t before : catalogue_->before(nodes_[node].task)) {
    if (const std::int32_t other = node_of_task_[before]; other >= 0)
      join(static_cast<std::uint32_t>(other), node);
  }
  for (const std::uint32_t after : catalogue_->after(nodes_[node].task)) {
    if (const std::int32_t other = node_of_task_[after]; other >= 0)
      join(node, static_cast<std::uint32_t>(other));
  }
}

void Draft::add(const BookedRoute& booked, const Offer* offer) {
  const std::vector<Leg>& legs = offer != nullptr ? offer->legs : booked.legs;
  SKEIN_EXPECTS(legs.size() == booked.tasks.size() + 1);
  Route& route = routes_.emplace_back();
  route.member = booked.member;
  route.free_from = offer != nullptr ? offer->free_from : booked.free_from;
  for (std::size_t i = 0; i < booked.tasks.size(); ++i) {
    route.base.push_back({node_of(booked.tasks[i]), static_cast<std::int32_t>(i), legs[i]});
    nodes_[route.base.back().node].placed = true;
  }
  route.base_home = legs.back();
  if (offer == nullptr) return;
  route.called = true;
  route.abilities = offer->abilities;
  route.energy = offer->energy;
  route.between = offer->between;
  const std::size_t width = legs.size();
  route.in.assign(items_.size() * width, kNoWay);
  route.out = route.in;
  for (std::size_t item = 0; item < items_.size(); ++item) {
    const ItemPrice& price = offer->items[item];
    route.item_energy.push_back(price.energy);
    route.willing.push_back(!price.gaps.empty());
    for (const GapPrice& gap : price.gaps) {
      route.in[item * width + gap.gap] = gap.in;
      route.out[item * width + gap.gap] = gap.out;
    }
  }
}

bool Draft::restore() {
  for (std::size_t item = 0; item < items_.size(); ++item) nodes_[item].placed = false;
  for (Route& route : routes_) {
    route.stops = route.base;
    route.home = route.base_home;
    route.spent = 0;
  }
  return schedule();
}

// Each pass puts something off for what may not come long after it. Where that moves in a circle it
// does not end: a longest path passes each such delay once.
bool Draft::schedule() {
  std::size_t passes = 1;
  for (Node& node : nodes_) {
    node.put_off = 0;
    for (const Arc& arc : node.before) passes += arc.delay.bounds_above() ? 1 : 0;
  }
  for (; forward(); --passes) {
    if (!put_off()) return backward();
    if (passes == 0) return false;
  }
  return false;
}

bool Draft::put_off() {
  bool moved = false;
  for (const std::uint32_t then : order_) {
    for (const Arc& arc : nodes_[then].before) {
      Node& first = nodes_[arc.node];
      const double sooner = nodes_[then].start - arc.delay.most - task_of(first).duration;
      if (!first.placed || first.start >= sooner) continue;
      first.put_off = sooner;
      moved = true;
    }
  }
  return moved;
}

// The way to what keeps a delay is flown when the first has ended.
double Draft::begins_after(const Arc& before, double way) const {
  const Node& first = nodes_[before.node];
  const double end = first.start + task_of(first).duration;
  return before.delay.bounds() ? end + before.delay.least + way : end;
}

// The longest to be flown to it, with an item in the gaps of the group.
double Draft::way_to(std::uint32_t node, std::span<const Gap> group) const {
  double way = 0;
  for (const auto& [r, p] : nodes_[node].spots) {
    const auto before = std::find_if(group.begin(), group.end(), [r = r, p = p](const Gap& gap) {
      return gap.spot.route == r && gap.spot.position == p;
    });
    way = std::max(way, before == group.end() ? routes_[r].stops[p].leg.seconds : before->out);
  }
  return way;
}

// Earliest dates, from what waits for nothing on (Kahn's order).
bool Draft::forward() {
  std::size_t placed = 0;
  for (Node& node : nodes_) {
    node.spots.clear();
    node.waiting = 0;
    placed += node.placed ? 1 : 0;
  }
  for (std::uint32_t r = 0; r < routes_.size(); ++r) {
    const auto& stops = routes_[r].stops;
    for (std::uint32_t p = 0; p < stops.size(); ++p) {
      nodes_[stops[p].node].spots.push_back({r, p});
      if (p > 0) ++nodes_[stops[p].node].waiting;
    }
  }
  order_.clear();
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (!nodes_[n].placed) continue;
    for (const Arc& b : nodes_[n].before) nodes_[n].waiting += nodes_[b.node].placed ? 1 : 0;
    if (nodes_[n].waiting == 0) order_.push_back(n);
  }
  for (std::size_t done = 0; done < order_.size(); ++done) {
    Node& node = nodes_[order_[done]];
    const Task& task = task_of(node);
    node.rank = static_cast<std::uint32_t>(done);
    node.start = std::max(task.earliest, node.put_off);
    const auto end_of = [&](std::uint32_t n) {
      return nodes_[n].start + task_of(nodes_[n]).duration;
    };
    for (const auto& [r, p] : node.spots) {
      const auto& stops = routes_[r].stops;
      const double free = p == 0 ? routes_[r].free_from : end_of(stops[p - 1].node);
      node.start = std::max(node.start, free + stops[p].leg.seconds);
      if (p + 1 < stops.size() && --nodes_[stops[p + 1].node].waiting == 0) {
        order_.push_back(stops[p + 1].node);
      }
    }
    const double way = way_to(order_[done]);
    for (const Arc& b : node.before) {
      if (nodes_[b.node].placed) node.start = std::max(node.start, begins_after(b, way));
    }
    for (const Arc& a : node.after) {
      if (nodes_[a.node].placed && --nodes_[a.node].waiting == 0) order_.push_back(a.node);
    }
    if (node.start + task.duration > task.deadline) return false;
  }
  return order_.size() == placed;
}

// What comes after each, and how late it may begin; cost and end of all.
bool Draft::backward() {
  for (auto n = order_.rbegin(); n != order_.rend(); ++n) {
    Node& node = nodes_[*n];
    const double duration = task_of(node).duration;
    node.tail = 0;
    node.latest = task_of(node).deadline - duration;
    for (const auto& [r, p] : node.spots) {
      const auto& stops = routes_[r].stops;
      if (p + 1 == stops.size()) {
        node.tail = std::max(node.tail, routes_[r].home.seconds);
        continue;
      }
      const Node& next = nodes_[stops[p + 1].node];
      const double way = stops[p + 1].leg.seconds;
      node.tail = std::max(node.tail, way + task_of(next).duration + next.tail);
      node.latest = std::min(node.latest, next.latest - way - duration);
    }
    for (const Arc& arc : node.after) {
      const Node& next = nodes_[arc.node];
      if (!next.placed) continue;
      const double apart = arc.delay.bounds() ? arc.delay.least + way_to(arc.node) : 0;
      node.tail = std::max(node.tail, apart + task_of(next).duration + next.tail);
      node.latest = std::min(node.latest, next.latest - apart - duration);
    }
  }
  unsold_ = rest_.unsold;
  for (std::size_t item = 0; item < items_.size(); ++item) unsold_ += nodes_[item].placed ? 0 : 1;
  cost_ = rest_.cost;
  end_ = rest_.end;
  ends_ = rest_.ends;
  for (const std::uint32_t n : order_) ends_ += nodes_[n].start + task_of(nodes_[n]).duration;
  for (std::size_t r = 0; r < routes_.size(); ++r) {
    if (routes_[r].stops.empty()) continue;
    for (const Stop& stop : routes_[r].stops) cost_ += stop.leg.cost;
    cost_ += routes_[r].home.cost;
    end_ = std::max(end_, end(r));
  }
  return true;
}

double Draft::end(std::size_t route) const {
  const Route& r = routes_[route];
  if (r.stops.empty()) return 0;
  const Node& last = nodes_[r.stops.back().node];
  return last.start + task_of(last).duration + r.home.seconds;
}

double Draft::cost(std::size_t route) const {
  const Route& r = routes_[route];
  double cost = r.stops.empty() ? 0 : r.home.cost;
  for (const Stop& stop : r.stops) cost += stop.leg.cost;
  return cost;
}

std::vector<Leg> Draft::legs(std::size_t route) const {
  std::vector<Leg> legs;
  for (const Stop& stop : routes_[route].stops) legs.push_back(stop.leg);
  legs.push_back(routes_[route].home);
  return legs;
}

double Draft::ends(std::size_t route) const {
  double ends = 0;
  for (const Stop& stop : routes_[route].stops) {
    ends += nodes_[stop.node].start + task_of(nodes_[stop.node]).duration;
  }
  return ends;
}

Value Draft::value() const {
  Value value = value_of(aim_, unsold_, cost_, end_);
  value.ends = ends_;
  return value;
}

std::vector<TaskNumber> Draft::tasks(std::size_t route) const {
  std::vector<TaskNumber> tasks;
  for (const Stop& stop : routes_[route].stops) tasks.push_back(task_of(nodes_[stop.node]).number);
  return tasks;
}

double Draft::start(TaskNumber task) const {
  const std::int32_t node = node_of_task_[catalogue_->index(task)];
  SKEIN_EXPECTS(node >= 0);
  return nodes_[static_cast<std::size_t>(node)].start;
}

void Draft::insert(const Placing& placing) {
  for (const auto& [r, position] : placing.spots) {
    Route& route = routes_[r];
    const Leg in = way_in(route, placing.item, position);
    const Leg out = way_out(route, placing.item, position);
    const Leg replaced = leg_at(route, position);
    route.spent += route.item_energy[placing.item] + in.energy + out.energy - replaced.energy;
    (position < route.stops.size() ? route.stops[position].leg : route.home) = out;
    route.stops.insert(route.stops.begin() + position, {placing.item, -1, in});
  }
  nodes_[placing.item].placed = true;
}

bool Draft::place(const Placing& placing) {
  std::vector<Route> before;
  for (const auto& spot : placing.spots) before.push_back(routes_[spot.route]);
  insert(placing);
  if (schedule()) return true;
  for (std::size_t i = 0; i < before.size(); ++i) {
    routes_[placing.spots[i].route] = std::move(before[i]);
  }
  nodes_[placing.item].placed = false;
  schedule();
  return false;
}

}  // namespace skein::auction
