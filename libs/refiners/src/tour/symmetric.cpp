// SPDX-License-Identifier: Apache-2.0
// Iterated 3-opt: sequential exchanges of two or three edges among near places, from each place
// that changed, and small double bridges to get away. Source: Lin and Kernighan 1973; Martin, Otto
// and Felten 1991.
#include <algorithm>
#include <numeric>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/random.hpp"
#include "tour/ring.hpp"
#include "tour/ring_costs.hpp"
#include "tour/search.hpp"

namespace skein::refiners {
namespace {

constexpr City kLongestBridge = 50;  // piece of a double bridge
constexpr double kAllowance = 0.4;   // of the mean hop

class SymmetricSearch {
 public:
  SymmetricSearch(const RingCosts& cost, std::vector<City> ring, std::uint64_t seed)
      : cost_(cost), ring_(std::move(ring)), random_(seed, "tour"), waits_(cost.size(), false) {}

  std::vector<City> run(Countdown& countdown) {
    for (const City city : ring_.order()) wake(city);
    TourCost expected = ring_cost() - descend();
    measure_hop();
    std::vector<City> best = ring_.order();
    TourCost lead = 0;  // of the best over the present ring
    while (cost_.size() >= kLeastRing && countdown.step()) {
      ring_.forget_turns();
      const TourCost change = bridge() + descend();
      if (change < 0 && static_cast<double>(lead - change) > allowance()) {
        ring_.take_back(0);
        continue;
      }
      lead -= change;
      expected -= change;
      if (lead < 0) best = ring_.order(), lead = 0;
    }
    SKEIN_ENSURES(ring_cost() == expected);  // every move gained what it said
    return best;
  }

 private:
  static constexpr City kLeastRing = 8;

  TourCost ring_cost() const {
    TourCost total = 0;
    for (const City city : ring_.order()) total += cost_(city, ring_.next(city));
    return total;
  }

  void wake(City city) {
    if (waits_[city]) return;
    waits_[city] = true;
    queue_.push_back(city);
  }

  void measure_hop() {
    double total = 0;
    for (const City city : ring_.order())
      total += static_cast<double>(std::max<TourCost>(0, cost_(city, ring_.next(city))));
    mean_hop_ = total / cost_.size();
  }
  /// How much worse than the best a ring may be and still be searched on from; another each time.
  double allowance() { return kAllowance * mean_hop_ * random_.uniform(); }

  /// Until no place can be improved; gives the gain.
  TourCost descend() {
    TourCost gain = 0;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      waits_[queue_[i]] = false;
      while (true) {
        const TourCost step = improve(queue_[i]);
        if (step <= 0) break;
        gain += step;
      }
    }
    queue_.clear();
    return gain;
  }

  /// One improvement around a place, in either sense; 0 when there is none.
  TourCost improve(City city) {
    TourCost gain = improve_onwards(city);
    if (gain > 0) return gain;
    ring_.mirror();
    gain = improve_onwards(city);
    ring_.mirror();
    return gain;
  }
  /// Cuts between `t1` and its next, and looks for one or two more cuts after which joining each
  /// end to a near place pays. The names are those of the paper.
  TourCost improve_onwards(City t1) {
    const City t2 = ring_.next(t1);
    best_ = {};
    const TourCost cut = cost_(t1, t2);
    for (const auto& [joined, t3] : cost_.near(t2)) {
      const TourCost left = cut - joined;
      if (left <= 0) break;
      const City before = ring_.previous(t3);
      if (t3 != t1 && before != t2) look_across(t1, t2, t3, before, left + cost_(t3, before));
      const City after = ring_.next(t3);
      if (t3 != t1) look_inside(t1, t2, t3, after, left + cost_(t3, after));
    }
    if (best_.gain > 0) apply(t1, t2);
    return best_.gain;
  }

  /// t4 before t3: closing gives a ring; a third cut anywhere does too.
  void look_across(City t1, City t2, City t3, City t4, TourCost gain) {
    offer({gain - cost_(t4, t1), Kind::kTwo, t3, t4, t3, t4});
    for (const auto& [joined, t5] : cost_.near(t4)) {
      const TourCost left = gain - joined;
      if (left <= best_.gain) break;
      const bool turned = is_between(t2, t5, t4);
      const City t6 = turned ? ring_.next(t5) : ring_.previous(t5);
      if (t5 == t3 || t6 == t4) continue;
      offer({left + cost_(t5, t6) - cost_(t6, t1), Kind::kAcross, t3, t4, t5, t6});
    }
  }

  /// t4 after t3: a ring and a way are left; the third cut must open the ring, at either side.
  void look_inside(City t1, City t2, City t3, City t4, TourCost gain) {
    for (const auto& [joined, t5] : cost_.near(t4)) {
      const TourCost left = gain - joined;
      if (left <= best_.gain) break;
      if (!is_between(t2, t5, t3)) continue;
      for (const bool onwards : {true, false}) {
        if (t5 == (onwards ? t3 : t2)) continue;
        const City t6 = onwards ? ring_.next(t5) : ring_.previous(t5);
        offer({left + cost_(t5, t6) - cost_(t6, t1), onwards ? Kind::kExchange : Kind::kTurnBoth,
               t3, t4, t5, t6});
      }
    }
  }

  enum class Kind { kTwo, kAcross, kExchange, kTurnBoth };
  struct Move {
    TourCost gain = 0;
    Kind kind = Kind::kTwo;
    City t3 = 0, t4 = 0, t5 = 0, t6 = 0;
  };
  void offer(const Move& move) {
    if (move.gain > best_.gain) best_ = move;
  }

  void apply(City t1, City t2) {
    const auto [gain, kind, t3, t4, t5, t6] = best_;
    if (kind == Kind::kTwo || kind == Kind::kAcross) {
      ring_.turn(t2, t4);
      if (kind == Kind::kAcross) ring_.turn(t4, t6);
    } else if (kind == Kind::kExchange) {
      ring_.turn(t2, t3);
      ring_.turn(t3, t6);
      ring_.turn(t5, t2);
    } else {
      ring_.turn(t2, t6);
      ring_.turn(t5, t3);
    }
    for (const City end : {t1, t2, t3, t4, t5, t6}) wake(end);
  }

  /// True when `city` is met on the way from `first` on to `last`, both included.
  bool is_between(City first, City city, City last) const {
    if (!ring_.reads_forwards()) std::swap(first, last);
    const City a = ring_.position(first), b = ring_.position(city), c = ring_.position(last);
    return a <= c ? a <= b && b <= c : a <= b || b <= c;
  }

  /// Exchanges two neighbouring pieces; gives the gain, mostly negative.
  TourCost bridge() {
    const City most = std::min<City>(kLongestBridge, (cost_.size() - 2) / 2);
    const City at = static_cast<City>(random_.below(cost_.size()));
    const City length = 1 + static_cast<City>(random_.below(most));
    const City length2 = 1 + static_cast<City>(random_.below(most));
    const City before = ring_.at(at), first = ring_.at(at + 1), last = ring_.at(at + length);
    const City first2 = ring_.at(at + length + 1), last2 = ring_.at(at + length + length2);
    const City after = ring_.at(at + length + length2 + 1);
    const TourCost gain = cost_(before, first) + cost_(last, first2) + cost_(last2, after) -
                          cost_(before, first2) - cost_(last2, first) - cost_(last, after);
    const bool forwards = ring_.reads_forwards();
    if (!forwards) ring_.mirror();
    ring_.turn(first, last2);
    ring_.turn(last2, first2);
    ring_.turn(last, first);
    if (!forwards) ring_.mirror();
    for (const City end : {before, first, last, first2, last2, after}) wake(end);
    return gain;
  }

  const RingCosts& cost_;
  TourRing ring_;
  Random random_;
  std::vector<bool> waits_;
  std::vector<City> queue_;
  Move best_;
  double mean_hop_ = 0;
};

}  // namespace

void improve_symmetrical(const TourProblem& problem, TourOrder& order, Countdown& countdown,
                         std::uint64_t seed) {
  const RingCosts cost(problem, order.gates);
  std::vector<City> ring(cost.size());
  std::iota(ring.begin(), ring.end(), City{0});
  ring = SymmetricSearch(cost, std::move(ring), seed).run(countdown);

  // The start first; the end, where there is one, last.
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), cost.start()), ring.end());
  if (!cost.closed() && ring[1] == cost.end_place()) std::reverse(ring.begin() + 1, ring.end());
  ring.erase(ring.begin());
  if (!cost.closed()) ring.pop_back();
  const std::vector<std::size_t> first = std::move(order.gates);
  order.gates.clear();
  for (const City city : ring) order.gates.push_back(first[city]);
}

}  // namespace skein::refiners
