// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour.hpp"

#include <cmath>

#include "skein/refiners/tour_problem.hpp"
#include "tour_checks.hpp"
#include "travel.hpp"

namespace skein::refiners {
namespace {

TourCost to_cost(double seconds) {
  const double ns = seconds * 1e9;
  return ns < static_cast<double>(kNoWay) ? std::llround(ns) : kNoWay;
}

/// From a query to the ordering problem, and back.
class TourPlan {
 public:
  TourPlan(const TourQuery& query, Travel& travel)
      : query_(query), travel_(travel), start_(travel.add(query.start)) {
    if (query.end) end_ = travel.add(*query.end);
    for (std::size_t stop = 0; stop < query.stops.size(); ++stop)
      for (std::size_t k = 0; k < query.stops[stop].gates.size(); ++k) {
        const Gate& gate = query.stops[stop].gates[k];
        gates_.push_back({stop, k, travel.add(gate.entry), travel.add(gate.exit)});
      }
  }

  /// A place where the vehicle cannot be; of a stop only when it has no other gate.
  std::optional<Refusal> find_blocked() const {
    const std::string why = " is in the ground, in a volume or outside the airspace";
    if (!travel_.is_free(start_)) return blocked("start", "the start" + why);
    if (end_ && !travel_.is_free(*end_)) return blocked("end", "the end" + why);
    for (std::size_t first = 0; first < gates_.size();) {
      const std::size_t stop = gates_[first].stop, count = query_.stops[stop].gates.size();
      bool open = false;
      for (std::size_t i = first; i < first + count; ++i) open = open || is_open(gates_[i]);
      if (!open)
        return blocked("stops." + std::to_string(stop) + ".gates.0." +
                           (travel_.is_free(gates_[first].entry) ? "exit" : "entry"),
                       "every gate of stop " + named(stop) + why);
      first += count;
    }
    return std::nullopt;
  }

  TourProblem problem() {
    TourProblem problem;
    for (const GatePlaces& gate : gates_) {
      const bool open = is_open(gate);
      problem.stop_of.push_back(gate.stop);
      problem.inside.push_back(query_.stops[gate.stop].gates[gate.index].inside.count());
      problem.from_start.push_back(open ? hop(start_, gate.entry) : kNoWay);
      problem.to_end.push_back(!open ? kNoWay : end_ ? hop(gate.exit, *end_) : 0);
      problem.turned.push_back(turned(gate));
      for (const GatePlaces& to : gates_)
        problem.between.push_back(to.stop == gate.stop  ? 0
                                  : open && is_open(to) ? hop(gate.exit, to.entry)
                                                        : kNoWay);
    }
    return problem;
  }

  /// Which stop cannot be reached or left, from and to anywhere.
  Refusal why_impossible(const TourProblem& problem) const {
    if (travel_.cut_short())
      return {RefusalKind::kBudgetExhausted, "stops",
              "the time was up before ways between all stops were looked for"};
    const std::size_t count = problem.stops();
    std::vector<bool> reached(count, false), left(count, false);
    for (std::size_t to = 0; to < gates_.size(); ++to) {
      if (problem.from_start[to] < kNoWay) reached[gates_[to].stop] = true;
      if (problem.to_end[to] < kNoWay) left[gates_[to].stop] = true;
      for (std::size_t from = 0; from < gates_.size(); ++from)
        if (gates_[from].stop != gates_[to].stop && problem.cost(from, to) < kNoWay)
          reached[gates_[to].stop] = left[gates_[from].stop] = true;
    }
    for (std::size_t stop = 0; stop < count; ++stop)
      if (!reached[stop] || !left[stop])
        return unreachable("stops." + std::to_string(stop),
                           "stop " + named(stop) + " cannot be " +
                               (reached[stop] ? "left" : "reached") + ": every way is closed");
    return unreachable("stops", "no order was found that visits all stops by open ways");
  }

  Refined<Tour> tour(const TourOrder& order) const {
    Refined<Tour> refined;
    refined.cost = static_cast<double>(order.cost) * 1e-9;
    refined.effort = order.effort;
    refined.effort.cut_short = order.effort.cut_short || travel_.cut_short();
    refined.task.exact = order.exact && !travel_.cut_short();
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

 private:
  struct GatePlaces {
    std::size_t stop, index;
    Travel::Id entry, exit;
  };

  static Refusal blocked(std::string field, std::string why) {
    return {RefusalKind::kBlocked, std::move(field), std::move(why)};
  }
  static Refusal unreachable(std::string field, std::string why) {
    return {RefusalKind::kUnreachable, std::move(field), std::move(why)};
  }
  std::string named(std::size_t stop) const {
    const std::string& name = query_.stops[stop].name;
    return name.empty() ? std::to_string(stop + 1) : "'" + name + "'";
  }
  bool is_open(const GatePlaces& gate) const {
    return travel_.is_free(gate.entry) && travel_.is_free(gate.exit);
  }
  TourCost hop(Travel::Id from, Travel::Id to) { return to_cost(travel_.seconds(from, to)); }

  /// The gate that goes through a stop the other way.
  std::size_t turned(const GatePlaces& gate) const {
    for (std::size_t i = 0; i < gates_.size(); ++i)
      if (gates_[i].stop == gate.stop && gates_[i].entry == gate.exit &&
          gates_[i].exit == gate.entry)
        return i;
    return static_cast<std::size_t>(&gate - gates_.data());
  }

  void fly(const Way& way, Refined<Tour>& refined) const {
    const Flight flight = travel_.flight(way);
    refined.task.length += flight.length;
    refined.task.energy += flight.energy;
    refined.duration.least = refined.duration.least + flight.duration.least;
    refined.duration.expected = refined.duration.expected + flight.duration.expected;
    refined.duration.most = refined.duration.most + flight.duration.most;
  }
  /// What is done inside is flown at cruise speed.
  void stay(Duration inside, Refined<Tour>& refined) const {
    refined.duration.least = refined.duration.least + inside;
    refined.duration.expected = refined.duration.expected + inside;
    refined.duration.most = refined.duration.most + inside;
    const double power = world::flight_power(query_.vehicle, query_.vehicle.cruise_speed, 0);
    refined.task.energy += inside.to_seconds() * power / query_.vehicle.energy.capacity;
  }

  const TourQuery& query_;
  Travel& travel_;
  Travel::Id start_;
  std::optional<Travel::Id> end_;
  std::vector<GatePlaces> gates_;
};

}  // namespace

Outcome<Tour> refine(const TourQuery& query, const Setting& setting) {
  if (auto problem = check(query)) return tl::unexpected(*problem);
  const Traveller who{query.vehicle, query.clearance, query.speed, query.depart};
  auto travel = Travel::over(who, setting, query.start, query.stops.front().gates.front().entry);
  if (!travel) return tl::unexpected(travel.error());

  TourPlan plan(query, *travel);
  if (auto problem = plan.find_blocked()) return tl::unexpected(*problem);
  const TourProblem problem = plan.problem();
  const TourOrder order = solve_tour(problem, setting.budget, setting.seed);
  if (order.cost >= kNoWay) return tl::unexpected(plan.why_impossible(problem));

  Refined<Tour> tour = plan.tour(order);
  if (auto too_much = check_energy(tour.task.energy, query.vehicle, "the best tour found"))
    return tl::unexpected(*too_much);
  return tour;
}

}  // namespace skein::refiners
