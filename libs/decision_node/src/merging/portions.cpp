// SPDX-License-Identifier: Apache-2.0
#include "merging/portions.hpp"

#include <algorithm>
#include <utility>

#include "skein/elementary/parameter_reader.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/world/segment.hpp"

namespace skein::decision_node {

namespace {

using world::Vector3;

constexpr double kPortion = 60;    // [s] of flight, and on to the next way-point
constexpr double kLeast = 30;      // [s] a shorter rest belongs to the portion before
constexpr double kAsksAhead = 20;  // [s] before its end the next is asked for

using Points = std::vector<Vector3>;

/// As rows of way-points, each from where the one before ends.
std::vector<Points> parts_of(const Points& points, double speed) {
  double left = 0;
  for (std::size_t i = 1; i < points.size(); ++i) left += (points[i] - points[i - 1]).norm();
  std::vector<Points> parts;
  Points part{points.front()};
  double flown = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    part.push_back(points[i]);
    flown += length / speed;
    left -= length;
    if (flown < kPortion || left < kLeast * speed) continue;
    parts.push_back(std::exchange(part, {points[i]}));
    flown = 0;
  }
  if (part.size() > 1) parts.push_back(std::move(part));
  return parts;
}

bool come_near(const Points& some, const Points& others, double distance) {
  for (std::size_t i = 1; i < some.size(); ++i) {
    for (std::size_t j = 1; j < others.size(); ++j) {
      const double apart = world::between_segments(some[i - 1].head<2>(), some[i].head<2>(),
                                                   others[j - 1].head<2>(), others[j].head<2>());
      if (apart < distance) return true;
    }
  }
  return false;
}

/// Parts between which the way comes back to air that it has left are one.
std::vector<Points> left_for_good(const std::vector<Points>& parts, double distance) {
  std::vector<Points> all;
  for (std::size_t first = 0, last = 0; first < parts.size(); first = last = last + 1) {
    for (std::size_t i = first; i <= last; ++i) {
      for (std::size_t later = parts.size() - 1; later > std::max(last, i + 1); --later)
        if (come_near(parts[i], parts[later], distance)) last = later;
    }
    Points one(parts[first].begin() + 1, parts[first].end());
    for (std::size_t i = first + 1; i <= last; ++i)
      one.insert(one.end(), parts[i].begin() + 1, parts[i].end());
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

std::optional<Portions> Portions::of(const functional::Request& flight,
                                     const elementary::GotoTask& task, const Vector3& from,
                                     double width) {
  Points points{from};
  points.insert(points.end(), task.waypoints.begin(), task.waypoints.end());
  Portions all;
  all.whole_ = flight;
  all.speed_ = task.speed;
  all.parts_ = left_for_good(parts_of(points, task.speed), width);
  return all.parts_.size() > 1 ? std::optional(std::move(all)) : std::nullopt;
}

functional::Request Portions::next(const std::optional<Vector3>& by) const {
  SKEIN_EXPECTS(taken_ < parts_.size());
  std::vector<Vector3> points = parts_[taken_];
  if (by) points.insert(points.begin(), *by);
  functional::Request request = whole_;
  request.parameters = functional::Parameters{elementary::points_parameter("waypoints", points)};
  for (const functional::Parameter& one : whole_.parameters.all())
    if (one.name != "waypoints") request.parameters.add(one);
  return request;
}

bool Portions::begins_to_run(const functional::Status& status) {
  const bool runs = status.state == functional::TaskState::kRunning;
  return runs && !std::exchange(running, true);
}

bool Portions::is_near_end(double left) const { return left <= kAsksAhead * speed_; }

}  // namespace skein::decision_node
