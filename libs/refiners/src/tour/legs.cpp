// SPDX-License-Identifier: Apache-2.0
#include "tour/legs.hpp"

#include <algorithm>
#include <cmath>

namespace skein::refiners {
namespace {

/// Ways looked for when it is to be told whether a stop can be reached at all.
constexpr std::size_t kMostProbes = 50;
/// Among as many gates all costs are known in some milliseconds; about what one takes [ns].
constexpr std::size_t kManyGates = 1000;
constexpr std::uint32_t kCost = 30;

TourCost to_cost(double seconds) {
  const double ns = seconds * 1e9;
  return ns < static_cast<double>(kNoWay) ? nearest_whole(ns) : kNoWay;
}

DurationInterval sum(const DurationInterval& a, const DurationInterval& b) {
  return {a.least + b.least, a.expected + b.expected, a.most + b.most};
}

}  // namespace

TourLegs::TourLegs(const TourQuery& query, Travel& travel)
    : query_(query), travel_(travel), start_(travel.add(query.start)) {
  if (query.end) end_ = travel.add(*query.end);
  for (std::size_t stop = 0; stop < query.stops.size(); ++stop)
    for (std::size_t k = 0; k < query.stops[stop].gates.size(); ++k) {
      const Gate& gate = query.stops[stop].gates[k];
      const Travel::Id entry = travel.add(gate.entry), exit = travel.add(gate.exit);
      entered_.resize(std::max(entered_.size(), std::max(entry, exit) + 1));
      left_.resize(entered_.size());
      entered_[entry].push_back(gates_.size());
      left_[exit].push_back(gates_.size());
      gates_.push_back({stop, k, entry, exit});
    }
}

std::optional<Refusal> TourLegs::find_closed() {
  if (auto why = travel_.closed(start_, "start")) return why;
  if (end_)
    if (auto why = travel_.closed(*end_, "end")) return why;
  std::optional<Refusal> first;  // of the stop
  bool open = false;
  for (std::size_t i = 0; i < gates_.size(); ++i) {
    GatePlaces& gate = gates_[i];
    if (gate.index == 0) open = false, first.reset();
    const std::string field =
        "stops." + std::to_string(gate.stop) + ".gates." + std::to_string(gate.index);
    auto why = travel_.closed(gate.entry, field + ".entry");
    if (!why && gate.exit != gate.entry) why = travel_.closed(gate.exit, field + ".exit");
    gate.open = !why;
    open = open || gate.open;
    if (!first) first = why;
    if (open || (i + 1 < gates_.size() && gates_[i + 1].stop == gate.stop)) continue;
    first->why = "stop " + named(gate.stop) + " has no gate that is open: " + first->why;
    return first;
  }
  return std::nullopt;
}

bool TourLegs::start_optimistic(const Budget& budget) {
  const std::size_t count = gates_.size();
  for (const GatePlaces& gate : gates_) {
    problem_.stop_of.push_back(gate.stop);
    problem_.inside.push_back(query_.stops[gate.stop].gates[gate.index].inside.count());
    problem_.turned.push_back(turned(gate));
  }
  problem_.between.assign(count * count, 0);
  problem_.from_start.assign(count, 0);
  problem_.to_end.assign(count, 0);
  Deadline deadline(count > kManyGates ? budget : Budget());
  late_ = !put_all(deadline);
  return !late_;
}

TourCost TourLegs::cost(Travel::Id from, Travel::Id to) const {
  return to_cost(travel_.seconds(from, to));
}

bool TourLegs::put_all(Deadline& deadline) {
  shut_off_ = travel_.shut_off();
  const std::size_t count = gates_.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (deadline.passed_after(kCost * static_cast<std::uint32_t>(count))) return false;
    const GatePlaces& gate = gates_[i];
    problem_.from_start[i] = gate.open ? cost(start_, gate.entry) : kNoWay;
    problem_.to_end[i] = !gate.open ? kNoWay : end_ ? cost(gate.exit, *end_) : 0;
    for (std::size_t to = 0; to < count; ++to)
      if (gates_[to].stop != gate.stop)
        problem_.between[i * count + to] =
            gate.open && gates_[to].open ? cost(gate.exit, gates_[to].entry) : kNoWay;
  }
  return true;
}

/// Wherever it is used.
void TourLegs::put(const Hop& hop) {
  const TourCost cost = this->cost(hop.first, hop.second);
  const auto at = [](const auto& gates_at, Travel::Id place) {
    return place < gates_at.size() ? gates_at[place] : std::vector<std::size_t>();
  };
  for (const std::size_t to : at(entered_, hop.second)) {
    if (!gates_[to].open) continue;
    if (hop.first == start_) problem_.from_start[to] = cost;
    for (const std::size_t from : at(left_, hop.first))
      if (gates_[from].open && gates_[from].stop != gates_[to].stop)
        problem_.between[from * gates_.size() + to] = cost;
  }
  if (end_ && hop.second == *end_)
    for (const std::size_t from : at(left_, hop.first))
      if (gates_[from].open) problem_.to_end[from] = cost;
}

std::vector<TourLegs::Hop> TourLegs::hops_of(const std::vector<std::size_t>& gates) const {
  std::vector<Hop> hops;
  Travel::Id at = start_;
  for (const std::size_t i : gates) {
    hops.emplace_back(at, gates_[i].entry);
    at = gates_[i].exit;
  }
  if (end_) hops.emplace_back(at, *end_);
  return hops;
}

bool TourLegs::settle(const std::vector<std::size_t>& gates) {
  bool all = true;
  for (const Hop& hop : hops_of(gates)) {
    if (travel_.is_known(hop.first, hop.second)) continue;
    all = travel_.settle(hop.first, hop.second) && all;
    put(hop);
    if (travel_.is_known(hop.second, hop.first)) put({hop.second, hop.first});
  }
  Deadline never{Budget()};
  if (travel_.shut_off() > shut_off_) put_all(never);
  return all;
}

bool TourLegs::are_known(const std::vector<std::size_t>& gates) const {
  const std::vector<Hop> hops = hops_of(gates);
  return std::all_of(hops.begin(), hops.end(),
                     [&](const Hop& hop) { return travel_.is_known(hop.first, hop.second); });
}

std::optional<TourProblem> TourLegs::known_only(const Budget& budget) const {
  TourProblem problem = problem_;
  Deadline deadline(gates_.size() > kManyGates ? budget : Budget());
  const Budget clock{budget.time_is_up};
  Countdown countdown(clock, 64);
  const auto close = [&](const Hop& hop, TourCost& cost) {
    if (cost >= kNoWay || travel_.is_known(hop.first, hop.second)) return;
    if (!countdown.step() || !travel_.can_go_straight(hop.first, hop.second)) cost = kNoWay;
  };
  for (std::size_t i = 0; i < gates_.size(); ++i) {
    if (deadline.passed_after(kCost * static_cast<std::uint32_t>(gates_.size())))
      return std::nullopt;
    close({start_, gates_[i].entry}, problem.from_start[i]);
    if (end_) close({gates_[i].exit, *end_}, problem.to_end[i]);
    for (std::size_t to = 0; to < gates_.size(); ++to)
      if (gates_[to].stop != gates_[i].stop)
        close({gates_[i].exit, gates_[to].entry}, problem.between[i * gates_.size() + to]);
  }
  return problem;
}

/// Every way to a stop, or on from it, with what it would take.
std::vector<std::pair<TourCost, TourLegs::Hop>> TourLegs::hops_at(std::size_t stop,
                                                                  bool entering) const {
  std::vector<std::pair<TourCost, Hop>> hops;
  for (std::size_t i = 0; i < gates_.size(); ++i) {
    const GatePlaces& own = gates_[i];
    if (own.stop != stop || !own.open) continue;
    if (entering) hops.push_back({problem_.from_start[i], {start_, own.entry}});
    if (!entering && end_) hops.push_back({problem_.to_end[i], {own.exit, *end_}});
    for (std::size_t other = 0; other < gates_.size(); ++other) {
      if (gates_[other].stop == stop || !gates_[other].open) continue;
      if (entering)
        hops.push_back({problem_.cost(other, i), {gates_[other].exit, own.entry}});
      else
        hops.push_back({problem_.cost(i, other), {own.exit, gates_[other].entry}});
    }
  }
  return hops;
}

/// Looks for the shortest of the ways not known, until one is open.
std::optional<Refusal> TourLegs::why_cut_off(std::size_t stop, bool entering) {
  if (!entering && !end_) return std::nullopt;
  auto hops = hops_at(stop, entering);
  const auto is_open = [&](const auto& hop) {
    return hop.first < kNoWay && travel_.is_known(hop.second.first, hop.second.second);
  };
  if (std::any_of(hops.begin(), hops.end(), is_open)) return std::nullopt;
  std::sort(hops.begin(), hops.end());
  std::size_t tried = 0;
  std::string why;
  for (const auto& [least, hop] : hops) {
    if (least < kNoWay && tried == kMostProbes) return std::nullopt;
    if (least < kNoWay && ++tried > 0 && !travel_.settle(hop.first, hop.second))
      return std::nullopt;
    if (cost(hop.first, hop.second) < kNoWay) return std::nullopt;
    if (why.empty()) why = travel_.why_closed(hop.first, hop.second);
  }
  return Refusal{RefusalKind::kUnreachable, "stops." + std::to_string(stop),
                 "stop " + named(stop) + " cannot be " + (entering ? "reached" : "left") +
                     ", neither " + (entering ? "from the start nor from" : "for the end nor for") +
                     " any other stop: " + why};
}

Refusal TourLegs::why_impossible() {
  late_ = late_ || travel_.cut_short();
  for (std::size_t stop = 0; stop < query_.stops.size() && !late_; ++stop)
    for (const bool entering : {true, false})
      if (auto why = why_cut_off(stop, entering)) return *why;
  if (late_ || travel_.cut_short())
    return {RefusalKind::kBudgetExhausted, "stops",
            "the time was up before ways that join all stops were found"};
  for (std::size_t i = 0; i < gates_.size(); ++i)
    if (gates_[i].open && problem_.from_start[i] >= kNoWay)
      return {
          RefusalKind::kUnreachable, "stops." + std::to_string(gates_[i].stop),
          "no order was found that visits all stops by open ways; stop " + named(gates_[i].stop) +
              " cannot be reached from the start: " + travel_.why_closed(start_, gates_[i].entry)};
  return {RefusalKind::kUnreachable, "stops",
          "no order was found that visits all stops by open ways"};
}

Refined<Tour> TourLegs::tour(const TourOrder& order) const {
  Refined<Tour> refined;
  refined.cost = static_cast<double>(order.cost) * 1e-9;
  refined.effort = order.effort;
  refined.task.exact = order.exact;
  Travel::Id at = start_;
  for (const std::size_t i : order.gates) {
    const GatePlaces& gate = gates_[i];
    refined.task.visits.push_back({gate.stop, gate.index, travel_.way(at, gate.entry)});
    fly(refined.task.visits.back().way, refined);
    stay(query_.stops[gate.stop].gates[gate.index].inside, refined);
    at = gate.exit;
  }
  if (end_) {
    refined.task.last = travel_.way(at, *end_);
    fly(refined.task.last, refined);
  }
  return refined;
}

std::string TourLegs::named(std::size_t stop) const {
  const std::string& name = query_.stops[stop].name;
  return name.empty() ? std::to_string(stop + 1) : "'" + name + "'";
}

/// The gate that goes through a stop the other way.
std::size_t TourLegs::turned(const GatePlaces& gate) const {
  const auto self = static_cast<std::size_t>(&gate - gates_.data());
  const std::size_t first = self - gate.index;
  for (std::size_t i = first; i < first + query_.stops[gate.stop].gates.size(); ++i)
    if (gates_[i].entry == gate.exit && gates_[i].exit == gate.entry) return i;
  return self;
}

void TourLegs::fly(const Way& way, Refined<Tour>& refined) const {
  const Flight flight = travel_.flight(way);
  refined.task.length += flight.length;
  refined.task.energy += flight.energy;
  refined.duration = sum(refined.duration, flight.duration);
}

/// What is done inside is flown at cruise speed.
void TourLegs::stay(Duration inside, Refined<Tour>& refined) const {
  refined.duration = sum(refined.duration, {inside, inside, inside});
  const double power = world::flight_power(query_.vehicle, query_.vehicle.cruise_speed, 0);
  refined.task.energy += inside.to_seconds() * power / query_.vehicle.energy.capacity;
}

}  // namespace skein::refiners
