// SPDX-License-Identifier: Apache-2.0
#include "patrol/walk_times.hpp"

#include <algorithm>

namespace skein::refiners {
namespace {

/// A place that a walk leaves out waits as many times as long as the walk takes, and counts as much
/// as a gap that is too long by that: where much is too long, leaving places out would pay.
constexpr double kLeftOut = 8, kLeftOutTooLong = 3;
/// A gap that is so much of the longest allowed may become too long by a change elsewhere.
constexpr double kNearlyTooLong = 0.9;

}  // namespace

/// The part of a walk that a change is about, before and after.
struct WalkTimes::Stretch {
  double length;             ///< now, from the visit before it to the one behind [m]
  double longer;             ///< what the change adds [m]
  std::array<double, 4> at;  ///< of what is put in, from the visit before it [m]
};

WalkTimes::WalkTimes(const WalkGraph& graph)
    : graph_(graph), visits_(graph.places.size()), shares_(graph.places.size()) {}

double WalkTimes::too_long(double top, double gap) const {
  const double over = top * gap / measure_.worst_risk_idleness - 1;
  return over > 0 ? measure_.too_long * over * over : 0;
}

void WalkTimes::add_gap(const WalkGraph::Place& place, double gap, Share& share) const {
  share.squares += place.risk * gap * gap;
  share.late += too_long(place.top, gap);
}

void WalkTimes::add_left_out(const WalkGraph::Place& place, double period, Share& share) const {
  add_gap(place, kLeftOut * period, share);
  if (measure_.looks_elsewhere) share.late += measure_.too_long * kLeftOutTooLong * kLeftOutTooLong;
}

double WalkTimes::weighed(const Share& share, double period) const {
  return share.squares / (2 * period * graph_.total_risk * measure_.mean_idleness) + share.late;
}

void WalkTimes::measure_by(const WalkMeasure& measure) {
  measure_ = measure;
  if (!walk_.empty()) note_gaps();
}

void WalkTimes::take(Walk walk) {
  walk_ = std::move(walk);
  note_times();
  note_gaps();
}

void WalkTimes::note_times() {
  const std::size_t n = walk_.size();
  times_.resize(n);
  for (auto& visits : visits_) visits.clear();
  double now = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t next = walk_[ahead(i, 1)];
    const double half = graph_.detour(walk_[ahead(i, n - 1)], walk_[i], next) / 2;
    times_[i] = now + half;
    now += 2 * half + graph_.length(walk_[i], next);
    visits_[walk_[i]].push_back(i);
  }
  period_ = now;
}

void WalkTimes::note_gaps() {
  all_ = {};
  long_gaps_.clear();
  const bool counts_long = measure_.looks_elsewhere && measure_.too_long > 0;
  growth_.assign(walk_.size(), 0);
  double open = 0;  // before the first visit
  for (std::size_t p = 0; p < visits_.size(); ++p) {
    const WalkGraph::Place& place = graph_.places[p];
    const std::vector<std::size_t>& visits = visits_[p];
    Share& share = shares_[p] = {};
    if (visits.empty()) add_left_out(place, period_, share);
    for (std::size_t k = 0; k < visits.size(); ++k) {
      const bool wraps = k + 1 == visits.size();
      const std::size_t next = visits[wraps ? 0 : k + 1];
      const double gap = times_[next] - times_[visits[k]] + (wraps ? period_ : 0);
      add_gap(place, gap, share);
      if (counts_long && place.top * gap > kNearlyTooLong * measure_.worst_risk_idleness)
        long_gaps_.push_back({static_cast<std::uint32_t>(p), visits[k], next, gap});
      growth_[visits[k]] += place.risk * gap;
      growth_[next] -= place.risk * gap;
      if (wraps) open += place.risk * gap;
    }
    all_.squares += share.squares;
    all_.late += share.late;
  }
  for (double& growth : growth_) growth = open += growth;
  badness_ = weighed(all_, period_);
}

WalkTimes::Stretch WalkTimes::stretch(const WalkChange& change) const {
  const std::size_t n = walk_.size(), behind = ahead(change.after, change.taken + 1);
  const std::uint32_t a = walk_[change.after], b = walk_[behind];
  const std::uint32_t before = walk_[ahead(change.after, n - 1)], then = walk_[ahead(behind, 1)];
  const auto put = [&](std::size_t k) { return k < change.puts ? change.put[k] : b; };
  Stretch stretch{times_[behind] - times_[change.after], 0, {}};
  if (stretch.length <= 0) stretch.length += period_;
  const double begin = graph_.detour(before, a, put(0));
  double now = begin / 2 + graph_.length(a, put(0));
  for (std::size_t k = 0; k < change.puts; ++k) {
    const double detour = graph_.detour(k > 0 ? change.put[k - 1] : a, change.put[k], put(k + 1));
    stretch.at[k] = now + detour / 2;
    now += detour + graph_.length(change.put[k], put(k + 1));
  }
  const double end = graph_.detour(change.puts > 0 ? change.put[change.puts - 1] : a, b, then);
  now += end / 2;
  // The first half of the turn at the beginning, and the second at the end, lie outside.
  stretch.longer = now - stretch.length +
                   (begin - graph_.detour(before, a, walk_[ahead(change.after, 1)])) / 2 +
                   (end - graph_.detour(walk_[ahead(change.after, change.taken)], b, then)) / 2;
  return stretch;
}

WalkTimes::Share WalkTimes::share_after(std::uint32_t place, const WalkChange& change,
                                        const Stretch& stretch) const {
  // Visits in their order from the one before the change.
  const std::vector<std::size_t>& visits = visits_[place];
  const std::size_t n = walk_.size();
  scratch_.clear();
  if (walk_[change.after] == place) scratch_.push_back(0);
  for (std::size_t k = 0; k < change.puts; ++k)
    if (change.put[k] == place) scratch_.push_back(stretch.at[k]);
  const auto first = static_cast<std::size_t>(
      std::upper_bound(visits.begin(), visits.end(), change.after) - visits.begin());
  for (std::size_t k = 0; k < visits.size(); ++k) {
    const std::size_t visit = visits[(first + k) % visits.size()];
    const std::size_t later = (visit + n - change.after) % n;
    if (later <= change.taken) continue;
    const double time = times_[visit] - times_[change.after];
    scratch_.push_back((time < 0 ? time + period_ : time) + stretch.longer);
  }
  Share share;
  const double period = period_ + stretch.longer;
  if (scratch_.empty()) add_left_out(graph_.places[place], period, share);
  for (std::size_t k = 0; k < scratch_.size(); ++k)
    add_gap(graph_.places[place],
            k + 1 < scratch_.size() ? scratch_[k + 1] - scratch_[k]
                                    : scratch_[0] + period - scratch_[k],
            share);
  return share;
}

double WalkTimes::open_gap(std::uint32_t place, std::size_t visit) const {
  const std::vector<std::size_t>& visits = visits_[place];
  if (visits.empty()) return 0;
  const auto next = std::upper_bound(visits.begin(), visits.end(), visit);
  const bool wraps = next == visits.begin() || next == visits.end();
  const std::size_t from = next == visits.begin() ? visits.back() : *(next - 1);
  const std::size_t to = next == visits.end() ? visits.front() : *next;
  return times_[to] - times_[from] + (wraps ? period_ : 0);
}

/// What gaps elsewhere that are open at a change add to what is too long as they grow by it.
double WalkTimes::later(const WalkChange& change, double longer, const std::uint32_t* judged,
                        std::size_t count) const {
  double sum = 0;
  for (const LongGap& gap : long_gaps_) {
    const bool wraps = gap.to <= gap.from;
    const bool is_open = wraps ? change.after >= gap.from || change.after < gap.to
                               : change.after >= gap.from && change.after < gap.to;
    if (!is_open || std::find(judged, judged + count, gap.place) != judged + count) continue;
    const double top = graph_.places[gap.place].top;
    sum += too_long(top, gap.gap + longer) - too_long(top, gap.gap);
  }
  return sum;
}

double WalkTimes::badness_after(const WalkChange& change) const {
  const Stretch changed = stretch(change);
  Share then = all_;
  std::array<std::uint32_t, 16> judged{};
  std::size_t count = 0;
  double growth = growth_[change.after], risk = graph_.total_risk;  // of the places not judged
  const auto judge = [&](std::uint32_t place) {
    const auto end = judged.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::find(judged.begin(), end, place) != end) return;
    judged[count++] = place;
    const Share share = share_after(place, change, changed);
    then.squares += share.squares - shares_[place].squares;
    then.late += share.late - shares_[place].late;
    growth -= graph_.places[place].risk * open_gap(place, change.after);
    risk -= graph_.places[place].risk;
  };
  for (std::size_t k = 1; k <= change.taken; ++k) judge(walk_[ahead(change.after, k)]);
  for (std::size_t k = 0; k < change.puts; ++k) judge(change.put[k]);
  // Every gap that is open there grows.
  then.late += later(change, changed.longer, judged.data(), count);
  then.squares += changed.longer * (2 * growth + changed.longer * risk);
  return weighed(then, period_ + changed.longer);
}

Walk WalkTimes::changed(const WalkChange& change) const {
  Walk walk;
  walk.reserve(walk_.size() + change.puts);
  for (std::size_t k = change.taken + 1; k <= walk_.size(); ++k)
    walk.push_back(walk_[ahead(change.after, k)]);
  for (std::size_t k = 0; k < change.puts; ++k) walk.push_back(change.put[k]);
  return walk;
}

double WalkTimes::badness_of(const Walk& walk) const {
  const std::size_t n = walk.size();
  first_.assign(graph_.places.size(), -1);
  last_.resize(graph_.places.size());
  Share share;
  double now = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = walk[i], next = walk[(i + 1) % n];
    const double half = graph_.detour(walk[(i + n - 1) % n], place, next) / 2;
    now += half;
    if (first_[place] < 0)
      first_[place] = now;
    else
      add_gap(graph_.places[place], now - last_[place], share);
    last_[place] = now;
    now += half + graph_.length(place, next);
  }
  for (std::size_t p = 0; p < first_.size(); ++p)
    if (first_[p] < 0)
      add_left_out(graph_.places[p], now, share);
    else
      add_gap(graph_.places[p], first_[p] + now - last_[p], share);
  return weighed(share, now);
}

}  // namespace skein::refiners
