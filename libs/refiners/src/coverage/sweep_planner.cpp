// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostEdges = 90;  ///< edges whose direction is tried, the longest
constexpr std::size_t kMostTried = 80;  ///< candidates looked at closely, if not convex
constexpr std::size_t kManyCorners = 300;
/// Candidates of an area of one corner that are still looked at once the time is up while none has
/// served; the more corners, the fewer.
constexpr std::size_t kTriedLate = 1200;
constexpr double kLanesInAll = 400'000;  ///< of all directions of the grid together

/// How the lanes of a direction are made.
enum class Cut : std::uint8_t {
  kWhole,  ///< one lane per strip, over what need not be swept too
  kSplit,  ///< cut where that saves more than a turn costs
  kApart,  ///< cut wherever nothing is to be swept
  kHull,   ///< as if the convex hull had to be swept
};

struct Candidate {
  double direction = 0;
  Cut cut = Cut::kWhole;
  double seconds = 0;  ///< or an estimate of them
};

double half_turn(double direction) {
  const double within = direction - kPi * std::floor(direction / kPi);
  return within >= kPi ? 0 : within;
}

Pass turned_out(const Pass& pass, const SweepFrame& frame, double direction) {
  return {frame.out(pass.from), frame.out(pass.to), world::wrapped(pass.heading + direction)};
}

class SweepPlanner {
 public:
  SweepPlanner(const SweepTask& task, const TurnModel& model, Countdown& countdown)
      : task_(task),
        model_(model),
        countdown_(countdown),
        hull_(convex_hull(task.region.outer)),
        convex_(task.region.holes.empty() && is_convex(task.region.outer)) {
    cuts_ = convex_ ? std::vector<Cut>{Cut::kWhole} : std::vector<Cut>{Cut::kWhole, Cut::kSplit};
    if (task.is_free) cuts_.push_back(Cut::kApart);
  }

  std::optional<Sweep> plan() {
    switch (task_.mode) {
      case SweepMode::kGiven:
        try_direction(task_.direction);
        break;
      case SweepMode::kLongestLine:
        try_direction(longest_line(task_.region));
        break;
      case SweepMode::kMinimumWidth:
        try_minimum_width();
        break;
      case SweepMode::kLeastTime:
        search();
    }
    if (!(best_.seconds < kInfinity)) return std::nullopt;
    return sweep_of(best_);
  }

 private:
  std::vector<Block> blocks_of(double direction, Cut cut) const {
    const SweepFrame frame(direction);
    if (cut == Cut::kSplit || cut == Cut::kApart) {
      const double gap =
          cut == Cut::kApart ? 0 : model_.speed() * (model_.beside(task_.swath) + model_.stop());
      return split_strips(frame.in(task_.region), task_.swath, gap);
    }
    std::vector<Block> blocks(1);
    Polygon turned;
    frame.turn(cut == Cut::kHull ? hull_ : task_.region.outer, turned);
    whole_strips(turned, task_.swath, blocks[0]);
    return blocks;
  }

  SweepEnds ends_in(double direction) const {
    const SweepFrame frame(direction);
    SweepEnds ends;
    if (task_.ends.start) ends.start = frame.in(*task_.ends.start);
    if (task_.ends.end) ends.end = frame.in(*task_.ends.end);
    return ends;
  }

  bool is_free(const std::vector<Block>& blocks, double direction) const {
    if (!task_.is_free) return true;
    const SweepFrame frame(direction);
    for (const Block& block : blocks)
      for (const Strip& strip : block)
        if (!task_.is_free(frame.out({strip.from, strip.y}), frame.out({strip.to, strip.y})))
          return false;
    return true;
  }

  double seconds_of(const Candidate& candidate) const {
    const std::vector<Block> blocks = blocks_of(candidate.direction, candidate.cut);
    if (!is_free(blocks, candidate.direction)) return kInfinity;
    return quick_seconds(blocks, model_at(candidate.direction), ends_in(candidate.direction));
  }

  TurnModel model_at(double direction) const {
    return task_.wind.isZero(0) ? model_ : model_.in_wind(SweepFrame(direction).in(task_.wind));
  }

  /// Nearly a lower bound, and cheap.
  double estimate(const Candidate& candidate) const {
    const std::vector<Block> blocks = blocks_of(candidate.direction, candidate.cut);
    const TurnModel model = model_at(candidate.direction);
    double sum = 0;
    for (const Block& block : blocks) sum += level_seconds(block, model);
    return sum;
  }

  void consider(Candidate candidate) {
    candidate.seconds = seconds_of(candidate);
    tried_.push_back(candidate);
    if (candidate.seconds < best_.seconds) best_ = candidate;
  }

  void try_direction(double direction) {
    countdown_.step();
    for (const Cut cut : cuts_)
      if (!gives_up()) consider({half_turn(direction), cut, 0});
    if (!convex_ && !gives_up()) consider({half_turn(direction), Cut::kHull, 0});
  }

  /// One edge of the hull lies along one side of its narrowest strip.
  void try_minimum_width() {
    double least = kInfinity;
    std::vector<std::pair<double, double>> widths;
    for (const double direction : edge_directions(hull_)) {
      widths.emplace_back(width_at(direction), direction);
      least = std::min(least, widths.back().first);
    }
    for (const auto& [width, direction] : widths)
      if (width <= least * (1 + 1e-9)) try_direction(direction);
  }

  double width_at(double direction) const {
    const double c = std::cos(direction), s = std::sin(direction);
    double low = kInfinity, high = -kInfinity;
    for (const Vector2& corner : hull_) {
      const double y = c * corner.y() - s * corner.x();
      low = std::min(low, y);
      high = std::max(high, y);
    }
    return high - low;
  }

  static std::vector<double> edge_directions(const Polygon& polygon) {
    std::vector<std::pair<double, double>> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
      edges.emplace_back(-edge.squaredNorm(), half_turn(std::atan2(edge.y(), edge.x())));
    }
    std::stable_sort(edges.begin(), edges.end());
    if (edges.size() > kMostEdges) edges.resize(kMostEdges);
    std::vector<double> directions;
    for (const auto& edge : edges) directions.push_back(edge.second);
    return directions;
  }

  /// What the hull alone would take, so that no region takes more than its hull.
  void try_hull() {
    SweepTask task = task_;
    task.region = {hull_, {}};
    SweepPlanner planner(task, model_, countdown_);
    planner.convex_ = true;
    planner.cuts_ = {Cut::kWhole};
    planner.best_.seconds = best_.seconds;  // only what may take less is looked at
    planner.search();
    if (planner.best_.seconds < best_.seconds)
      best_ = {planner.best_.direction, Cut::kHull, planner.best_.seconds};
  }

  bool is_late() const { return countdown_.over() || (task_.time_is_up && task_.time_is_up()); }

  /// Late, and what may still be looked at for a first answer has been, or there is one.
  bool gives_up() const {
    const std::size_t most = std::max<std::size_t>(1, kTriedLate / task_.region.outer.size());
    return (best_.seconds < kInfinity || tried_.size() >= most) && is_late();
  }

  std::vector<double> directions() const;
  void search();
  void search_near(double direction, double step);
  Sweep sweep_of(const Candidate& candidate) const;

  const SweepTask& task_;
  const TurnModel& model_;
  Countdown& countdown_;
  Polygon hull_;
  bool convex_;
  std::vector<Cut> cuts_;
  std::vector<Candidate> tried_;
  Candidate best_{0, Cut::kWhole, kInfinity};
};

/// The degrees; the edges; and where the area becomes just narrow enough for one lane less.
std::vector<double> SweepPlanner::directions() const {
  std::vector<double> found = edge_directions(task_.region.outer);
  for (const Polygon& hole : task_.region.holes)
    for (const double direction : edge_directions(hole)) found.push_back(direction);
  const auto lanes_at = [&](double direction) {
    return lane_count(width_at(direction), task_.swath);
  };
  const double most = static_cast<double>(lanes_at(0) + lanes_at(kPi / 2));
  const int count = static_cast<int>(std::clamp(kLanesInAll / most, 12.0, 180.0));
  const double step = kPi / count;
  for (int i = 0; i < count; ++i) {
    double a = i * step, b = (i + 1) * step;
    found.push_back(a);
    const std::size_t lanes_a = lanes_at(a), lanes_b = lanes_at(b);
    if (lanes_a == lanes_b) continue;
    for (int halving = 0; halving < 20; ++halving) {
      const double middle = a + (b - a) / 2;
      const bool few = lanes_at(middle) <= std::min(lanes_a, lanes_b);
      (few == (lanes_a < lanes_b) ? a : b) = middle;
    }
    found.push_back(half_turn(lanes_a < lanes_b ? a : b));
  }
  return found;
}

/// In the order of the estimate, so that most directions need not be looked at closely.
void SweepPlanner::search() {
  constexpr double kNearly = 0.97;
  // Even the estimates may take all of the time: an answer first.
  if (task_.time_is_up && task_.region.outer.size() > kManyCorners)
    for (const Cut cut : cuts_)
      if (!gives_up()) consider({directions().front(), cut, 0});
  std::vector<Candidate> candidates;
  for (const double direction : directions())
    for (const Cut cut : cuts_) {
      if (!candidates.empty() && is_late()) break;
      if (candidates.empty() && gives_up()) return;
      Candidate candidate{direction, cut, 0};
      candidate.seconds = estimate(candidate);
      candidates.push_back(candidate);
    }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
  if (!convex_ && candidates.size() > kMostTried) candidates.resize(kMostTried);
  for (const Candidate& candidate : candidates) {
    if (kNearly * candidate.seconds >= best_.seconds) break;
    countdown_.step();
    if (gives_up()) return;
    consider(candidate);
  }
  std::stable_sort(tried_.begin(), tried_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
  std::vector<double> near;
  for (const Candidate& candidate : tried_) {
    const auto is_near = [&](double direction) {
      const double apart = half_turn(direction - candidate.direction);
      return std::min(apart, kPi - apart) < kDegree;
    };
    if (near.size() < 3 && std::none_of(near.begin(), near.end(), is_near))
      near.push_back(candidate.direction);
  }
  for (const double direction : near) search_near(direction, kDegree / 2);
  if (!convex_ && !is_late()) try_hull();
}

void SweepPlanner::search_near(double direction, double step) {
  double least = kInfinity;
  for (; step > kDegree / 20; step /= 2)
    for (const double side : {-step, step}) {
      if (!countdown_.step()) return;
      for (const Cut cut : cuts_) {
        if (is_late()) return;
        Candidate candidate{half_turn(direction + side), cut, 0};
        candidate.seconds = seconds_of(candidate);
        if (candidate.seconds < best_.seconds) best_ = candidate;
        least = std::min(least, candidate.seconds);
      }
    }
}

Sweep SweepPlanner::sweep_of(const Candidate& candidate) const {
  const SweepFrame frame(candidate.direction);
  const std::vector<Block> blocks = blocks_of(candidate.direction, candidate.cut);
  const TurnModel model = model_at(candidate.direction);
  const Route route = order_blocks(blocks, model, ends_in(candidate.direction));
  Sweep sweep{candidate.direction, {}, route.seconds, blocks.size()};
  for (const Pass& pass : route.passes) {
    const double length = (pass.to - pass.from).norm();
    sweep.seconds -= model.lane(length, pass.heading == 0) - model.along(length);
    sweep.passes.push_back(turned_out(pass, frame, candidate.direction));
  }
  return sweep;
}

}  // namespace

std::optional<Sweep> plan_sweep(const SweepTask& task, const TurnModel& model,
                                Countdown& countdown) {
  return SweepPlanner(task, model, countdown).plan();
}

}  // namespace skein::refiners
