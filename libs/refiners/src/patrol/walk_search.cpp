// SPDX-License-Identifier: Apache-2.0
#include "patrol/walk_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "patrol/walk_times.hpp"
#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

using Place = std::uint32_t;

/// About what it takes to try a change [ns].
constexpr std::uint32_t kChange = 250;
constexpr std::uint64_t kChangesAStep = 64, kParts = 128;
/// What a gap too long by its whole length counts at the end, beside the mean, and where gaps
/// elsewhere are looked at; nothing before a
/// fifth of the changes are tried, and all of it from four fifths on.
constexpr double kTooLong = 1, kTooLongElsewhere = 3, kCountsFrom = 0.2, kCountsWholly = 0.8;
/// No walk is made shorter than that many visits; one of few places may always grow to so many.
constexpr std::size_t kShortest = 8, kMostOfFew = 100;
/// What is so much worse, in temperatures, is never taken.
constexpr double kNever = 14;

class WalkSearch {
 public:
  WalkSearch(const WalkGraph& graph, const WalkMeasure& measure, const Cooling& cooling)
      : graph_(graph),
        measure_(measure),
        cooling_(cooling),
        random_(cooling.seed, "walk"),
        now_(graph) {}

  Walk run(const CycleTime& time) {
    now_.take(begin());
    measure(0);
    const std::uint64_t changes = cooling_.changes_a_place * graph_.places.size();
    for (std::uint64_t i = 0; i < changes; ++i) {
      if (i % kChangesAStep == 0) {
        if (!time.countdown.step() || time.deadline.passed_after(kChangesAStep * kChange)) break;
        const double part = static_cast<double>(i) / static_cast<double>(changes);
        temperature_ = cooling_.from * std::pow(cooling_.to / cooling_.from, part);
      }
      if (i % (changes / kParts + 1) == 0)
        measure(static_cast<double>(i) / static_cast<double>(changes));
      try_something();
    }
    return visits_all(best_) ? best_ : Walk{};
  }

 private:
  /// Everything in turn, a few times where that is short.
  Walk begin() const {
    const Walk round = walk_in_turn(graph_);
    Walk walk = round;
    while (walk.size() < 2 * kShortest) walk.insert(walk.end(), round.begin(), round.end());
    return walk;
  }

  /// What is too long counts more and more; the best so far is judged anew.
  void measure(double part) {
    const double counts =
        std::clamp((part - kCountsFrom) / (kCountsWholly - kCountsFrom), 0.0, 1.0);
    WalkMeasure measure = measure_;
    measure.too_long *= counts * counts;
    now_.measure_by(measure);
    least_ = now_.badness();
    best_ = now_.walk();
  }

  bool visits_all(const Walk& walk) const {
    std::vector<bool> visited(graph_.places.size(), false);
    for (const Place place : walk) visited[place] = true;
    return std::find(visited.begin(), visited.end(), false) == visited.end();
  }

  bool is_taken(double badness) {
    const double worse = badness - now_.badness();
    if (worse < 0) return true;
    return worse < kNever * temperature_ && random_.uniform() < std::exp(-worse / temperature_);
  }

  void take(Walk walk) {
    now_.take(std::move(walk));
    if (!(now_.badness() < least_ - 1e-9)) return;
    least_ = now_.badness();
    best_ = now_.walk();
  }

  void try_change(const WalkChange& change) {
    const std::size_t n = now_.walk().size();
    if (n < change.taken + kShortest) return;
    if (n + change.puts > std::max(kMostOfFew, cooling_.visits_a_place * graph_.places.size()))
      return;
    if (is_taken(now_.badness_after(change))) take(now_.changed(change));
  }

  void try_walk(Walk walk) {
    if (is_taken(now_.badness_of(walk))) take(std::move(walk));
  }

  std::size_t any_visit() { return random_.below(now_.walk().size()); }
  Place at(std::size_t visit, std::size_t later) const {
    return now_.walk()[(visit + later) % now_.walk().size()];
  }
  Place beside(Place place) {
    const auto& links = graph_.places[place].links;
    return links[random_.below(links.size())].to;
  }
  /// A place linked to both, other than one.
  std::optional<Place> between(Place a, Place b, Place other) {
    std::optional<Place> chosen;
    std::uint64_t found = 0;
    for (const WalkGraph::Link& link : graph_.places[a].links)
      if (link.to != other && graph_.are_linked(link.to, b) && random_.below(++found) == 0)
        chosen = link.to;
    return chosen;
  }

  void try_something() {
    const std::uint64_t kind = random_.below(100);
    if (kind < 40) return cut_corner();
    if (kind < 64) return leave_out();
    if (kind < 92) return put_in();
    if (kind < 96) return turn_part();
    move_round();
  }

  void cut_corner() {
    const std::size_t i = any_visit();
    if (const auto other = between(at(i, 0), at(i, 2), at(i, 1))) try_change({i, 1, {*other}, 1});
  }

  /// A part between two visits of one place, or of two that are linked or nearly so.
  void leave_out() {
    constexpr std::array<std::size_t, 8> kCounts = {1, 1, 2, 2, 3, 4, 4, 6};
    const std::size_t i = any_visit(), count = kCounts[random_.below(kCounts.size())];
    if (now_.walk().size() < count + kShortest) return;
    const Place here = at(i, 0), behind = at(i, count + 1);
    if (at(i, count) == here || graph_.are_linked(here, behind)) {
      try_change({i, count, {}, 0});
    } else if (count >= 3) {
      if (const auto middle = between(here, behind, here)) try_change({i, count, {*middle}, 1});
    }
  }

  void put_in() {
    const std::size_t i = any_visit();
    const Place here = at(i, 0), next = at(i, 1), aside = beside(here);
    switch (random_.below(9)) {
      case 0:
      case 1:
        return try_change({i, 0, {aside, here}, 2});
      case 2:
        return put_in_round(i, here, aside, true);
      case 3:
        return put_in_round(i, here, aside, false);
      case 4:
        return put_in_bulge(i, here, next, aside, true);
      default:
        return put_in_bulge(i, here, next, aside, false);
    }
  }

  /// There and back by two places, or a round of four.
  void put_in_round(std::size_t i, Place here, Place aside, bool same_way_back) {
    const Place far = beside(aside);
    if (far == here) return;
    const std::optional<Place> back = same_way_back ? aside : between(far, here, aside);
    if (back) try_change({i, 0, {aside, far, *back, here}, 4});
  }

  /// Beside the way from one place to the next, one place aside or two.
  void put_in_bulge(std::size_t i, Place here, Place next, Place aside, bool deep) {
    if (aside == next) return;
    const auto back = between(aside, next, here);
    if (!back) return;
    if (!deep) return try_change({i, 0, {aside, *back}, 2});
    const Place far = beside(aside);
    if (far == here || far == *back) return;
    const auto far_back = between(far, *back, aside);
    if (far_back && *far_back != next) try_change({i, 0, {aside, far, *far_back, *back}, 4});
  }

  /// Between two visits of one place, or of two that are linked and whose next ones are.
  void turn_part() {
    const std::size_t n = now_.walk().size(), i = any_visit();
    const Place here = at(i, 0), there = random_.chance(0.5) ? here : beside(here);
    const auto& visits = now_.visits(there);
    if (visits.empty()) return;
    const std::size_t length = (visits[random_.below(visits.size())] + n - i) % n;
    if (length < 3 || n - length < 3) return;
    if (there != here && !graph_.are_linked(at(i, 1), at(i, length + 1))) return;
    Walk walk = rotated(i);
    const auto end = static_cast<std::ptrdiff_t>(there == here ? length : length + 1);
    std::reverse(walk.begin() + 1, walk.begin() + end);
    try_walk(std::move(walk));
  }

  /// A part that comes back to where it began, to a later visit of any of its places.
  void move_round() {
    const std::size_t n = now_.walk().size(), i = any_visit();
    const auto& again = now_.visits(at(i, 0));
    const std::size_t length = (again[random_.below(again.size())] + n - i) % n;
    if (length < 2 || length > n / 2) return;
    const std::size_t begin = random_.below(length);
    const auto& there = now_.visits(at(i, begin));
    const std::size_t to = (there[random_.below(there.size())] + n - i) % n;
    if (to <= length) return;
    const bool turned = random_.chance(0.5);
    const Walk old = rotated(i);
    Walk walk(old.begin() + static_cast<std::ptrdiff_t>(length),
              old.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    for (std::size_t k = 1; k <= length; ++k)
      walk.push_back(old[(begin + (turned ? length - k : k)) % length]);
    walk.insert(walk.end(), old.begin() + static_cast<std::ptrdiff_t>(to) + 1, old.end());
    try_walk(std::move(walk));
  }

  Walk rotated(std::size_t first) const {
    Walk walk = now_.walk();
    std::rotate(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(first), walk.end());
    return walk;
  }

  const WalkGraph& graph_;
  WalkMeasure measure_;
  Cooling cooling_;
  Random random_;
  WalkTimes now_;
  Walk best_;
  double least_ = 0, temperature_ = 0;
};

}  // namespace

Walk annealed_walk(const WalkGraph& graph, const CycleGoal& goal, double speed,
                   const Cooling& cooling, const CycleTime& time) {
  const WalkMeasure measure{goal.mean_idleness * speed, goal.worst_risk_idleness * speed,
                            cooling.looks_elsewhere ? kTooLongElsewhere : kTooLong,
                            cooling.looks_elsewhere};
  return WalkSearch(graph, measure, cooling).run(time);
}

}  // namespace skein::refiners
