// SPDX-License-Identifier: Apache-2.0
#include "patrol/cycle.hpp"

#include "patrol/ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skein::refiners {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoise = 1e-4;      ///< [m] costs are kept as floats
constexpr double kLeastGain = 1e-6;  ///< of a change
constexpr double kPassGain = 1e-3;   ///< of a pass, to make another
constexpr int kPasses = 12;
constexpr std::size_t kLongestLeftOut = 40, kLongestPutIn = 8, kLongestMoved = 3;
/// How far away runs are put in, in mean ways per block.
constexpr double kReach = 3;
/// What a gap too long by its whole length counts, beside the mean.
constexpr double kTooLong = 5;
/// About what it takes to look at one visit of a round [ns].
constexpr std::uint32_t kVisit = 10;

using Round = std::vector<Visit>;

Round::iterator place(Round& round, std::size_t i) {
  return round.begin() + static_cast<std::ptrdiff_t>(i);
}

void turn_round(Round::iterator first, Round::iterator end) {
  std::reverse(first, end);
  for (auto visit = first; visit != end; ++visit) *visit ^= 1U;
}

/// Local search over one round.
class CycleSearch {
 public:
  CycleSearch(const LapGround& ground, const CycleGoal& goal, const CycleTime& time)
      : links_(ground.links),
        whole_(ground.whole),
        speed_(ground.speed),
        goal_(goal),
        time_(time),
        risk_(ground.blocks.size(), 0),
        top_(ground.blocks.size(), 0),
        first_(ground.blocks.size()),
        last_(ground.blocks.size()) {
    for (std::size_t b = 0; b < risk_.size(); ++b)
      for (const std::uint32_t cell : ground.blocks[b].cells) {
        risk_[b] += ground.field.risk[cell];
        top_[b] = std::max(top_[b], ground.field.risk[cell]);
      }
    total_ = ground.field.total_risk;
    reach_ = kReach * round_length(whole_, links_) / static_cast<double>(whole_.size());
  }

  /// Freely first, then with less and less that is too long.
  Round shaped(Round round) {
    round_ = std::move(round);
    descend(0);
    // What the mean cannot reach, the worst need not either: both count alike.
    goal_.worst_risk_idleness *= std::max(1.0, badness_);
    descend(kTooLong / 25);
    descend(kTooLong);
    return round_;
  }

  Round improved(Round round) {
    round_ = std::move(round);
    descend(kTooLong);
    return round_;
  }

 private:
  bool is_over() const { return time_.deadline.is_over() || time_.countdown.over(); }

  /// To where no change makes it better; `weight`: of what is too long.
  void descend(double weight) {
    weight_ = weight;
    badness_ = badness(round_);
    for (int pass = 0; pass < kPasses && !is_over(); ++pass) {
      const double before = badness_;
      leave_out();
      put_in();
      turn_parts();
      move_parts();
      if (before - badness_ < kPassGain) return;
    }
  }

  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : round_.size() - 1; }

  /// Of waiting that long for a block.
  double weighed(std::size_t block, double gap) const { return risk_[block] * gap * gap / 2; }
  double too_long(std::size_t block, double gap) const {
    const double over = top_[block] * gap / goal_.worst_risk_idleness - 1;
    return over > 0 ? weight_ * over * over : 0;
  }
  double mean_part(double sum, double period) const {
    return sum / (period * total_ * goal_.mean_idleness);
  }

  double badness(const Round& round) {
    std::fill(first_.begin(), first_.end(), -1.0);
    double now = 0, sum = 0, late = 0;
    Visit from = round.back();
    for (const Visit visit : round) {
      const double length = links_.length(visit);
      now += (links_.cost(from, visit) + length / 2) / speed_;
      const std::size_t b = visit / 2;
      if (first_[b] < 0) {
        first_[b] = now;
      } else {
        sum += weighed(b, now - last_[b]);
        late += too_long(b, now - last_[b]);
      }
      last_[b] = now;
      now += length / 2 / speed_;
      from = visit;
    }
    for (std::size_t b = 0; b < first_.size(); ++b) {
      if (first_[b] < 0) return kInfinity;
      const double gap = first_[b] + now - last_[b];
      sum += weighed(b, gap);
      late += too_long(b, gap);
    }
    time_.deadline.passed_after(kVisit * static_cast<std::uint32_t>(round.size()));
    time_.countdown.step();
    return mean_part(sum, now) + late;
  }

  bool take_if_better(Round& round) {
    const double then = badness(round);
    if (!(then < badness_ - kLeastGain)) return false;
    round_.swap(round);
    badness_ = then;
    return true;
  }

  /// When each visit is, how long its block waited before, and will wait after.
  struct Stop {
    double at, waited, waits;
  };

  void survey() {
    const std::size_t n = round_.size();
    stops_.assign(n, {});
    times_.assign(risk_.size(), {});
    double now = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double half = links_.length(round_[i]) / 2;
      now += (links_.cost(round_[before(i)], round_[i]) + half) / speed_;
      stops_[i].at = now;
      times_[round_[i] / 2].push_back(i);
      now += half / speed_;
    }
    period_ = now;
    sum_ = 0;
    weighing_ = 0;
    for (std::size_t b = 0; b < risk_.size(); ++b)
      for (std::size_t k = 0; k < times_[b].size(); ++k) {
        const std::size_t i = times_[b][k], j = times_[b][(k + 1) % times_[b].size()];
        double gap = stops_[j].at - stops_[i].at;
        if (gap <= 0) gap += period_;
        stops_[i].waits = stops_[j].waited = gap;
        sum_ += weighed(b, gap);
        if (j <= i) weighing_ += risk_[b] * gap;
      }
    // Of the blocks that wait just before each visit.
    growth_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      growth_[i] = weighing_;
      weighing_ += risk_[round_[i] / 2] * (stops_[i].waits - stops_[i].waited);
    }
  }

  /// What the badness would become by as much time more (or less, below 0) before the i-th visit,
  /// and what is else added to the sum and to what is too long.
  double estimate(std::size_t i, double time, double sum, double late) const {
    const double then = sum_ + time * growth_[i] + time * time * total_ / 2 + sum;
    return mean_part(then, period_ + time) - mean_part(sum_, period_) + late;
  }

  /// Segments that are worth less than the time they take.
  void leave_out() {
    survey();
    Round fewer;
    for (std::size_t i = 1; i + 2 < round_.size() && !is_over(); ++i) {
      const std::size_t count = best_left_out(i);
      if (count == 0) continue;
      fewer = round_;
      fewer.erase(place(fewer, i), place(fewer, i + count));
      if (take_if_better(fewer)) survey();
    }
  }

  std::size_t best_left_out(std::size_t i) const {
    const Visit from = round_[i - 1];
    double length = links_.cost(from, round_[i]), sum = 0, late = 0, least = -kLeastGain;
    std::size_t best = 0;
    for (std::size_t j = i; j + 1 < round_.size() && j < i + kLongestLeftOut; ++j) {
      const std::size_t b = round_[j] / 2;
      // Not its only visit, nor two of one block.
      if (stops_[j].waits >= period_ || stops_[j].waits <= stops_[j].at - stops_[i].at ||
          stops_[j].waited <= stops_[j].at - stops_[i].at)
        break;
      const double waited = stops_[j].waited, waits = stops_[j].waits;
      sum += risk_[b] * waited * waits;
      late += too_long(b, waited + waits) - too_long(b, waited) - too_long(b, waits);
      length += links_.length(round_[j]) + links_.cost(round_[j], round_[j + 1]);
      const double saved = (length - links_.cost(from, round_[j + 1])) / speed_;
      const double change = estimate(i, -saved, sum, late);
      if (!(change < least)) continue;
      least = change;
      best = j + 1 - i;
    }
    return best;
  }

  /// Runs of the whole round where they are worth more than the time they take.
  void put_in() {
    survey();
    Round more;
    const std::size_t n = whole_.size();
    for (std::size_t k = 0; k < n && !is_over(); ++k)
      for (const bool turned : {false, true}) {
        const auto [at, count] = best_put_in(k, turned);
        if (count == 0) continue;
        more = round_;
        Round run;
        for (std::size_t c = 0; c < count; ++c) run.push_back(of_whole(k, c, turned));
        more.insert(place(more, at), run.begin(), run.end());
        if (take_if_better(more)) survey();
      }
  }

  Visit of_whole(std::size_t k, std::size_t count, bool turned) const {
    const std::size_t n = whole_.size();
    return turned ? whole_[(k + n - count) % n] ^ 1U : whole_[(k + count) % n];
  }

  struct Put {
    std::size_t at, count;
  };

  Put best_put_in(std::size_t k, bool turned) const {
    Put best{0, 0};
    double least = -kLeastGain;
    const Visit first = of_whole(k, 0, turned);
    const double reach = waits_too_long(first / 2) ? kInfinity : reach_;
    for (std::size_t i = 1; i < round_.size(); ++i) {
      if (time_.deadline.passed_after(kVisit)) return {0, 0};
      const Visit from = round_[i - 1], to = round_[i];
      if (links_.cost(from, first) > reach) continue;
      double length = links_.cost(from, first) - links_.cost(from, to), sum = 0, late = 0;
      for (std::size_t c = 0; c < std::min(kLongestPutIn, whole_.size()); ++c) {
        const Visit visit = of_whole(k, c, turned);
        if (c > 0) length += links_.cost(of_whole(k, c - 1, turned), visit);
        length += links_.length(visit);
        const double added = (length + links_.cost(visit, to)) / speed_;
        const auto [waited, waits] = waiting_at(visit / 2, stops_[i].at, added);
        sum -= risk_[visit / 2] * waited * waits;
        late += too_long(visit / 2, waited) + too_long(visit / 2, waits) -
                too_long(visit / 2, waited + waits);
        const double change = estimate(i, added, sum, late);
        if (change < least) {
          least = change;
          best = {i, c + 1};
        }
      }
    }
    return best;
  }

  bool waits_too_long(std::size_t block) const {
    return std::any_of(times_[block].begin(), times_[block].end(),
                       [&](std::size_t visit) { return too_long(block, stops_[visit].waits) > 0; });
  }

  /// How long a block will have waited at an instant, and how long it will have to wait.
  std::pair<double, double> waiting_at(std::size_t block, double at, double added) const {
    const std::vector<std::size_t>& stops = times_[block];
    std::size_t next = 0;
    while (next < stops.size() && stops_[stops[next]].at < at) ++next;
    const bool wraps = next == stops.size();
    const Stop& stop = stops_[stops[wraps ? 0 : next]];
    const double waits = stop.at - at + (wraps ? period_ : 0);
    return {std::max(0.0, stop.waited - waits) + added / 2, waits + added / 2};
  }

  void turn_parts() {
    Round other;
    const std::size_t n = round_.size();
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t j = i + 1; j + 1 < n; ++j) {
        if (time_.deadline.passed_after(kVisit)) return;
        const double now =
            links_.cost(round_[i], round_[i + 1]) + links_.cost(round_[j], round_[j + 1]);
        const double then =
            links_.cost(round_[i], round_[j] ^ 1U) + links_.cost(round_[i + 1] ^ 1U, round_[j + 1]);
        if (!(then < now - kNoise)) continue;
        other = round_;
        turn_round(place(other, i + 1), place(other, j + 1));
        take_if_better(other);
      }
  }

  void move_parts() {
    for (std::size_t length = 1; length <= kLongestMoved; ++length)
      for (std::size_t i = 1; i + length < round_.size() && !is_over(); ++i) move_part(i, length);
  }

  void move_part(std::size_t i, std::size_t length) {
    const std::size_t n = round_.size();
    const Visit first = round_[i], last = round_[i + length - 1];
    const double saved = links_.cost(round_[i - 1], first) + links_.cost(last, round_[i + length]) -
                         links_.cost(round_[i - 1], round_[i + length]);
    if (!(saved > kNoise)) return;
    Round other;
    for (std::size_t j = 0; j + 1 < n; ++j) {
      if (time_.deadline.passed_after(kVisit)) return;
      if (j + 1 >= i && j < i + length) continue;
      const double gap = links_.cost(round_[j], round_[j + 1]);
      const double same = links_.cost(round_[j], first) + links_.cost(last, round_[j + 1]) - gap;
      const double turned =
          links_.cost(round_[j], last ^ 1U) + links_.cost(first ^ 1U, round_[j + 1]) - gap;
      if (!(std::min(same, turned) < saved - kNoise)) continue;
      other = round_;
      if (turned < same) turn_round(place(other, i), place(other, i + length));
      if (j < i)
        std::rotate(place(other, j + 1), place(other, i), place(other, i + length));
      else
        std::rotate(place(other, i), place(other, i + length), place(other, j + 1));
      if (take_if_better(other)) return;
    }
  }

  const PatrolLinks& links_;
  const Round& whole_;
  double speed_;
  CycleGoal goal_;
  CycleTime time_;
  std::vector<double> risk_, top_;  ///< per block: of all its cells, and the greatest
  double total_ = 0, reach_ = 0;
  Round round_;
  double badness_ = kInfinity, weight_ = kTooLong;
  std::vector<double> first_, last_;
  std::vector<Stop> stops_;                      ///< per visit
  std::vector<std::vector<std::size_t>> times_;  ///< per block: its visits
  std::vector<double> growth_;                   ///< per visit: of the sum, by time before it
  double period_ = 0, sum_ = 0, weighing_ = 0;
};

}  // namespace

std::vector<Visit> weighted_cycle(const LapGround& ground, const CycleGoal& goal, std::size_t times,
                                  const CycleTime& time) {
  Round round;
  for (std::size_t i = 0; i < times; ++i)
    round.insert(round.end(), ground.whole.begin(), ground.whole.end());
  return CycleSearch(ground, goal, time).shaped(std::move(round));
}

std::vector<Visit> improved_cycle(const LapGround& ground, const CycleGoal& goal,
                                  std::vector<Visit> cycle, const CycleTime& time) {
  return CycleSearch(ground, goal, time).improved(std::move(cycle));
}

}  // namespace skein::refiners
