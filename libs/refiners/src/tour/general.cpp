// SPDX-License-Identifier: Apache-2.0
// Iterated local search for any costs and gates: other gates, pieces moved, turned or exchanged;
// then the best gates along the order.
#include <algorithm>
#include <utility>

#include "skein/foundation/random.hpp"
#include "tour/search.hpp"

namespace skein::refiners {
namespace {

constexpr std::size_t kNear = 6;            // stops that a piece is exchanged for
constexpr std::size_t kLongestPiece = 3;    // that is moved elsewhere whole
constexpr std::size_t kLongestBridge = 30;  // piece of a perturbation
constexpr double kAllowance = 1.0;          // of the mean hop
constexpr double kOtherGate = 0.3;          // how often a perturbation is another gate

/// Costs of going from one gate to the next, with the visit there. Two more numbers stand for the
/// start and the end.
class Hops {
 public:
  explicit Hops(const TourProblem& problem)
      : gates_(problem.gates()), width_(gates_ + 2), cost_(width_ * width_, kNoWay) {
    for (std::size_t from = 0; from < gates_; ++from) {
      for (std::size_t to = 0; to < gates_; ++to)
        cost_[from * width_ + to] = problem.cost(from, to) + problem.inside[to];
      cost_[start() * width_ + from] = problem.from_start[from] + problem.inside[from];
      cost_[from * width_ + end()] = problem.to_end[from];
    }
  }
  std::size_t start() const { return gates_; }
  std::size_t end() const { return gates_ + 1; }
  TourCost operator()(std::size_t from, std::size_t to) const { return cost_[from * width_ + to]; }

 private:
  std::size_t gates_, width_;
  std::vector<TourCost> cost_;
};

class GeneralSearch {
 public:
  GeneralSearch(const TourProblem& problem, const std::vector<std::size_t>& gates,
                Countdown& countdown, std::uint64_t seed)
      : problem_(problem),
        gates_of_(problem),
        hop_(problem),
        countdown_(countdown),
        random_(seed, "tour"),
        turned_(problem.turned),
        position_(problem.stops()),
        waits_(problem.stops(), false) {
    if (turned_.empty())
      for (std::size_t gate = 0; gate < problem.gates(); ++gate) turned_.push_back(gate);
    list_near();
    take({gates.begin(), gates.end()});
  }

  std::vector<std::size_t> run() {
    for (std::size_t stop = 0; stop < problem_.stops(); ++stop) wake(stop);
    std::vector<std::size_t> current = descended(), best = current;
    TourCost current_cost = cost_of(problem_, current), best_cost = current_cost;
    while (!countdown_.over() && stops() > 1) {
      perturb();
      std::vector<std::size_t> found = descended();
      const TourCost cost = cost_of(problem_, found);
      const double worse = static_cast<double>(cost - best_cost);
      if (cost > current_cost && worse > allowance(best_cost)) {
        take(current);
        continue;
      }
      current = std::move(found);
      current_cost = cost;
      if (cost < best_cost) best = current, best_cost = cost;
    }
    return best;
  }

 private:
  std::size_t stops() const { return problem_.stops(); }
  double allowance(TourCost best) {
    return kAllowance * random_.uniform() * static_cast<double>(best) /
           static_cast<double>(stops());
  }
  std::size_t stop_at(std::size_t position) const { return problem_.stop_of[order_[position]]; }

  void list_near() {
    near_.resize(problem_.gates());
    for (std::size_t gate = 0; gate < problem_.gates(); ++gate) {
      std::vector<std::pair<TourCost, std::size_t>> others;
      for (std::size_t stop = 0; stop < stops(); ++stop) {
        if (stop == problem_.stop_of[gate]) continue;
        TourCost least = hop_(gate, gates_of_.begin(stop));
        for (std::size_t to = gates_of_.begin(stop); to < gates_of_.end(stop); ++to)
          least = std::min(least, hop_(gate, to));
        others.emplace_back(least, stop);
      }
      const std::size_t count = std::min(kNear, others.size());
      std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
                        others.end());
      for (std::size_t i = 0; i < count; ++i) near_[gate].push_back(others[i].second);
    }
  }

  /// Makes it the order searched from, with the start before it and the end behind.
  void take(const std::vector<std::size_t>& gates) {
    order_.assign(1, hop_.start());
    order_.insert(order_.end(), gates.begin(), gates.end());
    order_.push_back(hop_.end());
    refresh();
  }

  /// Positions, and the sums along the order and against it.
  void refresh() {
    along_.assign(order_.size(), 0);
    against_.assign(order_.size(), 0);
    for (std::size_t i = 1; i + 1 < order_.size(); ++i) {
      position_[stop_at(i)] = i;
      if (i == 1) continue;
      along_[i] = along_[i - 1] + hop_(order_[i - 1], order_[i]);
      against_[i] = against_[i - 1] + hop_(turned_[order_[i]], turned_[order_[i - 1]]);
    }
  }

  void wake(std::size_t stop) {
    if (waits_[stop]) return;
    waits_[stop] = true;
    queue_.push_back(stop);
  }
  void wake_at(std::size_t position) {
    if (position > 0 && position <= stops()) wake(stop_at(position));
  }

  /// The order from which no move, and no choice of gates, improves any more.
  std::vector<std::size_t> descended() {
    while (true) {
      descend();
      std::vector<std::size_t> gates(order_.begin() + 1, order_.end() - 1);
      if (problem_.gates() == stops() || countdown_.over()) return gates;
      std::vector<std::size_t> visits;
      for (const std::size_t gate : gates) visits.push_back(problem_.stop_of[gate]);
      const std::vector<std::size_t> better = choose_gates(problem_, visits);
      if (cost_of(problem_, better) >= cost_of(problem_, gates)) return gates;
      take(better);
      for (std::size_t i = 0; i < gates.size(); ++i)
        if (better[i] != gates[i]) wake(visits[i]);
    }
  }

  void descend() {
    for (std::size_t i = 0; i < queue_.size() && countdown_.step(); ++i) {
      const std::size_t stop = queue_[i];
      waits_[stop] = false;
      if (improve(position_[stop])) wake(stop);
    }
    for (const std::size_t stop : queue_) waits_[stop] = false;
    queue_.clear();
  }

  bool improve(std::size_t at) {
    return change_gate(at) || move_piece(at) || turn_piece(at) || exchange_pieces(at);
  }

  bool change_gate(std::size_t at) {
    const std::size_t before = order_[at - 1], after = order_[at + 1], stop = stop_at(at);
    std::size_t best = order_[at];
    const auto cost = [&](std::size_t gate) { return hop_(before, gate) + hop_(gate, after); };
    for (std::size_t gate = gates_of_.begin(stop); gate < gates_of_.end(stop); ++gate)
      if (cost(gate) < cost(best)) best = gate;
    if (best == order_[at]) return false;
    order_[at] = best;
    for (const std::size_t i : {at - 1, at + 1}) wake_at(i);
    refresh();
    return true;
  }

  /// [first, last] to behind another position; as it is, turned, or, when it is one stop, by any
  /// of its gates.
  struct PieceMove {
    TourCost gain = 0;
    std::size_t to = 0;
    bool turn = false;
    std::size_t gate = 0;
  };

  bool move_piece(std::size_t first) {
    for (std::size_t last = first; last < first + kLongestPiece && last <= stops(); ++last) {
      PieceMove best;
      const TourCost saved = hop_(order_[first - 1], order_[first]) + along_[last] - along_[first] +
                             hop_(order_[last], order_[last + 1]) -
                             hop_(order_[first - 1], order_[last + 1]);
      for (std::size_t to = 0; to <= stops(); ++to)
        if (to + 1 < first || to > last) look_at_place(first, last, to, saved, best);
      if (best.gain <= 0) continue;
      apply(first, last, best);
      return true;
    }
    return false;
  }

  void look_at_place(std::size_t first, std::size_t last, std::size_t to, TourCost saved,
                     PieceMove& best) const {
    const std::size_t before = order_[to], after = order_[to + 1];
    const TourCost left = saved + hop_(before, after);
    const auto offer = [&](TourCost cost, bool turn, std::size_t gate) {
      if (left - cost > best.gain) best = {left - cost, to, turn, gate};
    };
    if (first == last) {
      const std::size_t stop = stop_at(first);
      for (std::size_t gate = gates_of_.begin(stop); gate < gates_of_.end(stop); ++gate)
        offer(hop_(before, gate) + hop_(gate, after), false, gate);
      return;
    }
    offer(hop_(before, order_[first]) + along_[last] - along_[first] + hop_(order_[last], after),
          false, order_[first]);
    const std::size_t head = turned_[order_[last]], tail = turned_[order_[first]];
    offer(hop_(before, head) + against_[last] - against_[first] + hop_(tail, after), true,
          order_[first]);
  }

  void apply(std::size_t first, std::size_t last, const PieceMove& move) {
    for (const std::size_t i : {first - 1, first, last, last + 1, move.to, move.to + 1}) wake_at(i);
    if (first == last) order_[first] = move.gate;
    if (move.turn) turn(first, last);
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (move.to < first)
      std::rotate(at(move.to + 1), at(first), at(last + 1));
    else
      std::rotate(at(first), at(last + 1), at(move.to + 1));
    refresh();
  }

  /// Without refresh.
  void turn(std::size_t first, std::size_t last) {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    std::reverse(begin, end);
    for (auto gate = begin; gate != end; ++gate) *gate = turned_[*gate];
  }

  bool turn_piece(std::size_t at) {
    TourCost best = 0;
    std::pair<std::size_t, std::size_t> piece;
    for (std::size_t other = 1; other <= stops(); ++other) {
      if (other == at) continue;
      const auto [first, last] = std::minmax(at, other);
      const std::size_t before = order_[first - 1], after = order_[last + 1];
      const TourCost gain = hop_(before, order_[first]) + along_[last] - along_[first] +
                            hop_(order_[last], after) - hop_(before, turned_[order_[last]]) -
                            against_[last] + against_[first] - hop_(turned_[order_[first]], after);
      if (gain > best) best = gain, piece = {first, last};
    }
    if (best <= 0) return false;
    for (const std::size_t i : {piece.first - 1, piece.first, piece.second, piece.second + 1})
      wake_at(i);
    turn(piece.first, piece.second);
    refresh();
    return true;
  }

  /// Cuts behind `at`, goes on to a near stop further on, and comes back to what was left out.
  bool exchange_pieces(std::size_t at) {
    for (const std::size_t stop : near_[order_[at]]) {
      const std::size_t middle = position_[stop];
      if (middle <= at + 1) continue;
      const TourCost saved = hop_(order_[at], order_[at + 1]) +
                             hop_(order_[middle - 1], order_[middle]) -
                             hop_(order_[at], order_[middle]);
      for (std::size_t last = middle; last <= stops(); ++last) {
        const TourCost gain = saved + hop_(order_[last], order_[last + 1]) -
                              hop_(order_[last], order_[at + 1]) -
                              hop_(order_[middle - 1], order_[last + 1]);
        if (gain <= 0) continue;
        exchange(at + 1, middle, last + 1);
        return true;
      }
    }
    return false;
  }

  /// [first, middle) and [middle, end) change places.
  void exchange(std::size_t first, std::size_t middle, std::size_t end) {
    for (const std::size_t i : {first - 1, first, middle - 1, middle, end - 1, end}) wake_at(i);
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::rotate(at(first), at(middle), at(end));
    refresh();
  }

  void perturb() {
    if (problem_.gates() > stops() && random_.chance(kOtherGate)) {
      const std::size_t at = 1 + random_.below(stops()), stop = stop_at(at);
      const std::size_t count = gates_of_.end(stop) - gates_of_.begin(stop);
      order_[at] = gates_of_.begin(stop) + random_.below(count);
      for (const std::size_t i : {at - 1, at + 1}) wake_at(i);
      refresh();
      return;
    }
    const std::size_t first = 1 + random_.below(stops() - 1);
    const std::size_t room = stops() + 1 - first;  // stops from `first` on, at least two
    const std::size_t one = 1 + random_.below(std::min(kLongestBridge, room - 1));
    const std::size_t two = 1 + random_.below(std::min(kLongestBridge, room - one));
    exchange(first, first + one, first + one + two);
  }

  const TourProblem& problem_;
  StopGates gates_of_;
  Hops hop_;
  Countdown& countdown_;
  Random random_;
  std::vector<std::size_t> turned_;
  std::vector<std::vector<std::size_t>> near_;  // of each gate: stops, nearest first
  std::vector<std::size_t> order_;              // gates, the start and the end
  std::vector<std::size_t> position_;           // of each stop in the order
  std::vector<TourCost> along_, against_;       // sums up to a position, from the first stop on
  std::vector<bool> waits_;
  std::vector<std::size_t> queue_;
};

}  // namespace

void improve_any(const TourProblem& problem, TourOrder& order, Countdown& countdown,
                 std::uint64_t seed) {
  order.gates = GeneralSearch(problem, order.gates, countdown, seed).run();
}

}  // namespace skein::refiners
