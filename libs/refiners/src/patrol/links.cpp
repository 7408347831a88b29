// SPDX-License-Identifier: Apache-2.0
#include "patrol/links.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

constexpr double kNoWay = std::numeric_limits<double>::infinity();
/// Detours go over that many of the nearest visits at each step, and from those that count it among
/// their own nearest: what leads there leads back.
constexpr std::size_t kNeighbours = 24;
/// About what it takes to find out whether a direct link is open [ns].
constexpr std::uint32_t kDirect = 20'000;

/// From a point on it once around and back to it; `side` 1: counter-clockwise. Chords are at most
/// `tolerance` from the arc.
std::vector<Vector2> circle(const Vector2& centre, const Vector2& from, double side,
                            double tolerance) {
  const Vector2 out = from - centre;
  const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / out.norm()));
  const int parts = std::max(4, static_cast<int>(std::ceil(2 * std::numbers::pi / step)));
  std::vector<Vector2> round = {from};
  for (int i = 1; i < parts; ++i) {
    const double angle = side * 2 * std::numbers::pi * i / parts;
    round.emplace_back(centre.x() + std::cos(angle) * out.x() - std::sin(angle) * out.y(),
                       centre.y() + std::sin(angle) * out.x() + std::cos(angle) * out.y());
  }
  round.push_back(from);
  return round;
}

}  // namespace

PatrolLinks::PatrolLinks(const std::vector<PatrolBlock>& blocks, const PatrolSpace& space,
                         double radius, double tolerance)
    : blocks_(blocks),
      space_(space),
      radius_(radius),
      tolerance_(tolerance),
      plain_(radius == 0 && space.is_simple()),
      visits_(2 * blocks.size()) {
  known_.assign(visits_ * visits_, std::numeric_limits<float>::quiet_NaN());
  if (plain_) return;
  direct_ = known_;
  detours_.resize(visits_);
}

const Vector2& PatrolLinks::entry(Visit visit) const {
  const PatrolBlock& block = blocks_[visit / 2];
  return visit % 2 == 0 ? block.track.front() : block.track.back();
}

double PatrolLinks::heading(Visit visit) const {
  return blocks_[visit / 2].heading + (visit % 2 == 0 ? 0 : std::numbers::pi);
}

double PatrolLinks::find_cost(Visit from, Visit to) const {
  double cost = kNoWay;
  if (plain_) {
    cost = (entry(to) - exit(from)).norm();
  } else {
    cost = direct(from, to);
    if (cost == kNoWay) cost = static_cast<double>(detours(from).cost[to]);
  }
  known_[from * visits_ + to] = known_[(to ^ 1U) * visits_ + (from ^ 1U)] =
      static_cast<float>(cost);
  return cost;
}

double PatrolLinks::direct(Visit from, Visit to) const {
  float& known = direct_[from * visits_ + to];
  if (std::isnan(known)) {
    known = static_cast<float>(direct_cost(from, to));
    direct_[(to ^ 1U) * visits_ + (from ^ 1U)] = known;
  }
  return static_cast<double>(known);
}

double PatrolLinks::direct_cost(Visit from, Visit to) const {
  if (radius_ > 0 && is_point_again(from, to))
    return round_over(from).empty() ? kNoWay : 2 * std::numbers::pi * radius_;
  if (radius_ > 0) {
    const double length = shortest(exit(from), heading(from), to).length();
    return space_.is_simple() || is_open(link(from, to), false) ? length : kNoWay;
  }
  return space_.is_open(exit(from), entry(to)) ? (entry(to) - exit(from)).norm() : kNoWay;
}

/// Over the same point in the same sense: the shortest curve has no length and cannot be flown.
bool PatrolLinks::is_point_again(Visit from, Visit to) const {
  return from == to && blocks_[from / 2].track.size() == 1;
}

/// A full circle from there and back again, left or right; empty: both are closed.
std::vector<Vector2> PatrolLinks::round_over(Visit visit) const {
  const double ahead = heading(visit);
  for (const double side : {1.0, -1.0}) {
    const Vector2 centre =
        entry(visit) + side * radius_ * Vector2(-std::sin(ahead), std::cos(ahead));
    std::vector<Vector2> round = circle(centre, entry(visit), side, tolerance_);
    if (is_open(round, false)) return round;
  }
  return {};
}

std::vector<Vector2> PatrolLinks::small_round(const Vector2& at, double most, double least) const {
  constexpr int kSides = 8;
  for (double radius = most; radius >= least; radius /= 2)
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      const Vector2 centre = at + radius * Vector2(std::cos(angle), std::sin(angle));
      std::vector<Vector2> round = circle(centre, at, 1, radius / 8);
      bool open = true;
      for (std::size_t k = 1; open && k < round.size(); ++k)
        open = space_.is_open(round[k - 1], round[k]);
      if (open) return round;
    }
  return {};
}

DubinsCurve PatrolLinks::shortest(const Vector2& from, double heading_from, Visit to) const {
  return DubinsCurve::shortest({from, heading_from}, {entry(to), heading(to)}, radius_);
}

/// The same curve there and back: of several that are as short only one may be open.
std::vector<Vector2> PatrolLinks::link(Visit from, Visit to) const {
  const std::pair<Visit, Visit> back{to ^ 1U, from ^ 1U};
  if (is_point_again(from, to)) return round_over(from);
  if (std::pair{from, to} <= back)
    return shortest(exit(from), heading(from), to).sampled(tolerance_);
  std::vector<Vector2> points =
      shortest(exit(back.first), heading(back.first), back.second).sampled(tolerance_);
  std::reverse(points.begin(), points.end());
  return points;
}

bool PatrolLinks::is_open(const std::vector<Vector2>& curve, bool may_start_outside) const {
  if (!space_.is_clear(curve.front())) return false;
  const double room = kTurningRoom * radius_;
  bool was_inside = !may_start_outside || space_.outside(curve.front()) <= room;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Vector2& a = curve[i - 1];
    const Vector2& b = curve[i];
    if (!space_.closed().empty() && !space_.is_clear(a, b)) return false;
    // A long chord is looked at every turn radius.
    const int parts = 1 + static_cast<int>((b - a).norm() / radius_);
    for (int k = 1; k <= parts; ++k) {
      const bool inside = space_.outside(a + static_cast<double>(k) / parts * (b - a)) <= room;
      if (!inside && was_inside) return false;
      was_inside = was_inside || inside;
    }
  }
  return true;
}

std::vector<Visit> PatrolLinks::nearest(Visit from, Deadline& deadline) const {
  std::vector<std::pair<double, Visit>> by_distance;
  for (Visit to = 0; to < visits_; ++to)
    by_distance.emplace_back((entry(to) - exit(from)).norm(), to);
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<Visit> near;
  // Turning back over its own block counts: a dead end is left as it was entered.
  for (const auto& [distance, to] : by_distance) {
    if (near.size() >= kNeighbours || deadline.passed_after(kDirect)) break;
    if (to != from && direct(from, to) < kNoWay) near.push_back(to);
  }
  return near;
}

bool PatrolLinks::prepare(Deadline& deadline) {
  if (plain_) return !deadline.passed();
  near_.assign(visits_, {});
  for (Visit visit = 0; visit < visits_; ++visit) {
    for (const Visit to : nearest(visit, deadline)) {
      near_[visit].push_back(to);
      near_[to ^ 1U].push_back(visit ^ 1U);
    }
    if (deadline.passed()) return false;
  }
  for (std::vector<Visit>& near : near_) {
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
  return true;
}

const PatrolLinks::Detours& PatrolLinks::detours(Visit from) const {
  Detours& found = detours_[from];
  if (!found.cost.empty()) return found;
  found.cost.assign(visits_, std::numeric_limits<float>::infinity());
  found.before.assign(visits_, from);
  using Entry = std::pair<float, Visit>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto expand = [&](Visit at, double so_far) {
    for (const Visit to : neighbours(at)) {
      const auto cost = static_cast<float>(so_far + direct(at, to));
      if (cost >= found.cost[to]) continue;
      found.cost[to] = cost;
      found.before[to] = at;
      open.emplace(cost, to);
    }
  };
  expand(from, 0);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost == found.cost[at]) expand(at, static_cast<double>(cost) + length(at));
  }
  return found;
}

bool PatrolLinks::leads_there_and_back(Visit from, Visit to) const {
  if (plain_ || from == to) return true;
  const auto there = [&](Visit a, Visit b) {
    return static_cast<double>(detours(a).cost[b]) < kNoWay;
  };
  // Back from `to` is what its reverse reaches: links are reversible.
  return there(from, to) && there(from ^ 1U, to ^ 1U);
}

void PatrolLinks::append_way(Visit from, Visit to, std::vector<Vector2>& way) const {
  if (plain_) return;
  if (direct(from, to) < kNoWay) return append_direct(from, to, way);
  const Detours& known = detours(from);
  SKEIN_EXPECTS(static_cast<double>(known.cost[to]) < kNoWay);
  std::vector<Visit> over;
  for (Visit at = known.before[to]; at != from; at = known.before[at]) over.push_back(at);
  Visit at = from;
  for (auto next = over.rbegin(); next != over.rend(); ++next) {
    append_direct(at, *next, way);
    append_track(*next, way);
    at = *next;
  }
  append_direct(at, to, way);
}

void PatrolLinks::append_direct(Visit from, Visit to, std::vector<Vector2>& way) const {
  if (radius_ == 0) return;
  const std::vector<Vector2> points = link(from, to);
  if (points.size() > 2) way.insert(way.end(), points.begin() + 1, points.end() - 1);
}

double PatrolLinks::cost_from(const Vector2& start, double heading_from, Visit to) const {
  if (radius_ > 0) {
    const DubinsCurve curve = shortest(start, heading_from, to);
    const bool open = space_.is_simple() || is_open(curve.sampled(tolerance_), true);
    return open ? curve.length() : kNoWay;
  }
  return space_.is_clear(start, entry(to)) ? (entry(to) - start).norm() : kNoWay;
}

void PatrolLinks::append_way_from(const Vector2& start, double heading_from, Visit to,
                                  std::vector<Vector2>& way) const {
  if (radius_ == 0) return;
  const std::vector<Vector2> points = shortest(start, heading_from, to).sampled(tolerance_);
  if (points.size() > 2) way.insert(way.end(), points.begin() + 1, points.end() - 1);
}

void PatrolLinks::append_track(Visit visit, std::vector<Vector2>& way) const {
  const std::vector<Vector2>& track = blocks_[visit / 2].track;
  if (visit % 2 == 0)
    way.insert(way.end(), track.begin(), track.end());
  else
    way.insert(way.end(), track.rbegin(), track.rend());
}

}  // namespace skein::refiners
