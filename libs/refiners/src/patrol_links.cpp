// SPDX-License-Identifier: Apache-2.0
#include "patrol_links.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "skein/refiners/dubins.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

constexpr double kNoWay = std::numeric_limits<double>::infinity();
/// Detours go over that many of the nearest blocks at each step.
constexpr std::size_t kNeighbours = 24;

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
  near_.resize(visits_);
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
  if (radius_ > 0) return curve_cost(exit(from), heading(from), to, false);
  return space_.is_open(exit(from), entry(to)) ? (entry(to) - exit(from)).norm() : kNoWay;
}

std::vector<Vector2> PatrolLinks::curve(const Vector2& from, double heading_from, Visit to) const {
  return DubinsCurve::shortest({from, heading_from}, {entry(to), heading(to)}, radius_)
      .sampled(tolerance_);
}

double PatrolLinks::curve_cost(const Vector2& from, double heading_from, Visit to,
                               bool may_start_outside) const {
  const DubinsCurve shortest =
      DubinsCurve::shortest({from, heading_from}, {entry(to), heading(to)}, radius_);
  if (space_.is_simple()) return shortest.length();
  return is_open(shortest.sampled(tolerance_), may_start_outside) ? shortest.length() : kNoWay;
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

const std::vector<Visit>& PatrolLinks::neighbours(Visit from) const {
  std::vector<Visit>& near = near_[from];
  if (!near.empty()) return near;
  std::vector<std::pair<double, Visit>> by_distance;
  for (Visit to = 0; to < visits_; ++to)
    if (to / 2 != from / 2) by_distance.emplace_back((entry(to) - exit(from)).norm(), to);
  std::sort(by_distance.begin(), by_distance.end());
  for (const auto& [distance, to] : by_distance) {
    if (near.size() >= kNeighbours) break;
    if (direct(from, to) < kNoWay) near.push_back(to);
  }
  return near;
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

void PatrolLinks::append_way(Visit from, Visit to, std::vector<Vector2>& way) const {
  if (plain_) return;
  if (direct(from, to) == kNoWay) {
    std::vector<Visit> over;
    for (Visit at = detours(from).before[to]; at != from; at = detours(from).before[at])
      over.push_back(at);
    Visit at = from;
    for (auto next = over.rbegin(); next != over.rend(); ++next) {
      append_way(at, *next, way);
      append_track(*next, way);
      at = *next;
    }
    append_way(at, to, way);
    return;
  }
  if (radius_ == 0) return;
  const std::vector<Vector2> points = curve(exit(from), heading(from), to);
  if (points.size() > 2) way.insert(way.end(), points.begin() + 1, points.end() - 1);
}

double PatrolLinks::cost_from(const Vector2& start, double heading_from, Visit to) const {
  if (radius_ > 0) return curve_cost(start, heading_from, to, true);
  return space_.is_clear(start, entry(to)) ? (entry(to) - start).norm() : kNoWay;
}

void PatrolLinks::append_way_from(const Vector2& start, double heading_from, Visit to,
                                  std::vector<Vector2>& way) const {
  if (radius_ == 0) return;
  const std::vector<Vector2> points = curve(start, heading_from, to);
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
