// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "path/string_puller.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using world::Vector3;

constexpr std::size_t kMostLegs = 200'000;  // looked at for the first choice
constexpr std::size_t kNearReach = 30;      // way-points that one leg may leave out later
constexpr int kRounds = 60;                 // at most
constexpr double kLeastGain = 1e-5;         // of the cost in a round, to go on
constexpr double kTiny = 1e-9;              // relative gain that counts
constexpr double kLeastPart = 1.0 / 64;     // of a way to a better place that is tried

/// Where on a line along an axis the detour from a to b over it is shortest: where the mirrored
/// straight line crosses.
double shortest_detour(const Vector3& a, const Vector3& corner, const Vector3& b,
                       Eigen::Index axis) {
  const auto off_axis = [&](const Vector3& end) {
    Vector3 offset = end - corner;
    offset[axis] = 0;
    return offset.norm();
  };
  const double from = off_axis(a), to = off_axis(b);
  if (from + to <= 0)
    return std::clamp(corner[axis], std::min(a[axis], b[axis]), std::max(a[axis], b[axis]));
  return (a[axis] * to + b[axis] * from) / (from + to);
}

}  // namespace

std::optional<double> StringPuller::cost(const Vector3& a, const Vector3& b) const {
  if (!even_) return airspace_.cost(a, b);
  if (!airspace_.is_free(a, b)) return std::nullopt;
  return rate_ * (b - a).norm();
}

double StringPuller::leg_cost(const Vector3& a, const Vector3& b) const {
  return cost(a, b).value_or(std::numeric_limits<double>::infinity());
}

double StringPuller::cost(const Way& way) const {
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += leg_cost(way[i - 1], way[i]);
  return sum;
}

Way StringPuller::best_choice(const Way& way, std::size_t reach) const {
  const std::size_t count = way.size();
  std::vector<double> costs(count, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(count, 0);
  costs[0] = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (budget_.expired()) return way;
    for (std::size_t j = i; j-- > (i > reach ? i - reach : 0);) {
      // Looked at only where it could pay.
      if (costs[j] + rate_ * (way[i] - way[j]).norm() >= costs[i]) continue;
      const double sum = costs[j] + leg_cost(way[j], way[i]);
      if (sum >= costs[i]) continue;
      costs[i] = sum;
      before[i] = j;
    }
  }
  Way chosen;
  for (std::size_t i = count - 1; i > 0; i = before[i]) chosen.push_back(way[i]);
  chosen.push_back(way[0]);
  std::reverse(chosen.begin(), chosen.end());
  return chosen;
}

double StringPuller::try_at(Way& way, std::size_t corner, const Vector3& place) const {
  const Vector3 &a = way[corner - 1], &b = way[corner + 1];
  const double now = leg_cost(a, way[corner]) + leg_cost(way[corner], b);
  if (rate_ * ((place - a).norm() + (b - place).norm()) >= now * (1 - kTiny)) return -1;
  const double first = leg_cost(a, place);
  if (first >= now) return -1;
  const double then = first + leg_cost(place, b);
  if (then >= now * (1 - kTiny)) return -1;
  way[corner] = place;
  return now - then;
}

double StringPuller::slide_toward(Way& way, std::size_t corner, Eigen::Index axis,
                                  double goal) const {
  const double side = airspace_.grid().voxel, here = way[corner][axis];
  const double sign = goal > here ? 1 : -1;
  Vector3 place = way[corner];
  double gain = -1;
  for (double part = 1; part > kLeastPart && gain < 0; part /= 2) {
    place[axis] = here + part * (goal - here);
    gain = try_at(way, corner, place);
    if (part == 1 && gain > 0) return gain;
  }
  // What stopped it has a face somewhere ahead: just before the next one is where it can go.
  const double along = sign * (way[corner][axis] - airspace_.grid().origin[axis]) / side;
  const double before = std::floor(along + 2 * kInset) + 1 - kInset;
  place[axis] = airspace_.grid().origin[axis] + sign * before * side;
  if ((goal - place[axis]) * sign > 0) gain = std::max(0.0, gain) + try_at(way, corner, place);
  return std::max(0.0, gain);
}

double StringPuller::slide(Way& way, std::size_t corner, Eigen::Index axis) const {
  const double goal = shortest_detour(way[corner - 1], way[corner], way[corner + 1], axis);
  double gain = 0;
  if (std::abs(goal - way[corner][axis]) > 1e-6 * airspace_.grid().voxel)
    gain += slide_toward(way, corner, axis, goal);
  if (even_) return gain;
  for (const double step : {1.0, -1.0, 0.2, -0.2}) {
    Vector3 place = way[corner];
    place[axis] += step * airspace_.grid().voxel;
    gain += std::max(0.0, try_at(way, corner, place));
  }
  return gain;
}

double StringPuller::slide_corners(Way& way) const {
  double gain = 0;
  for (std::size_t i = 1; i + 1 < way.size() && !budget_.expired(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis) gain += slide(way, i, axis);
  return gain;
}

double StringPuller::cut_corners(Way& way) const {
  Way cut = {way.front()};
  double gain = 0;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const Vector3 corner = way[i], a = cut.back(), b = way[i + 1];
    bool done = false;
    for (double part = 1; part > 0.02 && !done; part /= 2) {
      const Vector3 p = corner + part * (a - corner), q = corner + part * (b - corner);
      const double now = leg_cost(p, corner) + leg_cost(corner, q);
      if (rate_ * (q - p).norm() >= now * (1 - 1e-6)) break;
      const double then = leg_cost(p, q);
      if (then >= now * (1 - kTiny)) continue;
      gain += now - then;
      if (part < 1) {
        cut.push_back(p);
        cut.push_back(q);
      }
      done = true;
    }
    if (!done) cut.push_back(corner);
  }
  cut.push_back(way.back());
  way = std::move(cut);
  return gain;
}

Way StringPuller::pulled(Way way) const {
  if (way.size() < 3) return way;
  way = best_choice(way, std::clamp<std::size_t>(kMostLegs / way.size(), 40, 400));
  double now = cost(way);
  for (int round = 0; round < kRounds && way.size() > 2 && !budget_.expired(); ++round) {
    slide_corners(way);
    cut_corners(way);
    way = best_choice(way, kNearReach);
    const double then = cost(way);
    if (now - then < kLeastGain * now) break;
    now = then;
  }
  return way;
}

Way pull_straight(const world::Airspace& airspace, const Way& way, const Budget& budget) {
  return StringPuller(airspace, budget).pulled(way);
}

}  // namespace skein::refiners
