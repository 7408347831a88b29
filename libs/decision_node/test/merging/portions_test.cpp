// SPDX-License-Identifier: Apache-2.0
// How a sweep is cut into portions: against a cutting by the words of decision 68, and a joining of
// what comes back that goes on until nothing changes.
#include "merging/portions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "skein/elementary/parameter_reader.hpp"

namespace skein::decision_node {
namespace {

using world::Vector2;
using world::Vector3;
using Points = std::vector<Vector3>;

/// A flight along way-points at a speed, from the origin.
struct Sweep {
  Points points;
  double speed = 5;  ///< [m/s]
  functional::Request request{functional::Verb::kDispatch, functional::TaskId(3), "goto", {}};

  std::optional<Portions> portions(double width) {
    request.parameters = {};
    request.parameters.add(elementary::points_parameter("waypoints", points));
    request.parameters.add("speed", speed);
    return Portions::of(request, {points, speed}, Vector3::Zero(), width);
  }
};

/// Lanes to the north and back, so far beside each other.
Sweep lanes(int count, double length, double beside) {
  Sweep sweep;
  for (int lane = 0; lane < count; ++lane) {
    const double x = beside * lane, near = lane % 2 == 0 ? 0 : length;
    if (lane > 0) sweep.points.emplace_back(x, near, 40);
    sweep.points.emplace_back(x, length - near, 40);
  }
  return sweep;
}

/// Of whole metres and at an odd speed: nothing lasts half a minute, or a whole one, to the last
/// bit, where sums of another order come out otherwise.
Sweep drawn_sweep() {
  Sweep sweep;
  sweep.speed = *rc::gen::inRange(3, 12) + 0.3717;
  Vector3 at = Vector3::Zero();
  for (int left = *rc::gen::inRange(1, 14); left > 0; --left) {
    at += Vector3(*rc::gen::inRange(-200, 400), *rc::gen::inRange(-300, 300), 0);
    sweep.points.push_back(at);
  }
  return sweep;
}

Points way_points(const functional::Request& request) {
  const std::vector<double>& numbers = request.parameters.find("waypoints")->numbers;
  Points points;
  for (std::size_t at = 0; at + 2 < numbers.size(); at += 3)
    points.emplace_back(numbers[at], numbers[at + 1], numbers[at + 2]);
  return points;
}

std::vector<Points> flown(Portions portions) {
  std::vector<Points> all;
  for (; !portions.is_last_taken(); portions.take()) all.push_back(way_points(portions.next()));
  return all;
}

// ---- the reference --------------------------------------------------------------------------

/// Numbers of way-points in each portion: at least a minute each, where half a minute is left.
std::vector<std::size_t> cut(const Sweep& sweep) {
  std::vector<double> lasts;
  Vector3 before = Vector3::Zero();
  for (const Vector3& point : sweep.points) {
    lasts.push_back((point - before).norm() / sweep.speed);
    before = point;
  }
  std::vector<std::size_t> counts;
  for (std::size_t first = 0; first < lasts.size();) {
    std::size_t end = first + 1;
    const auto sum = [&](std::size_t from, std::size_t to) {
      return std::accumulate(lasts.begin() + static_cast<std::ptrdiff_t>(from),
                             lasts.begin() + static_cast<std::ptrdiff_t>(to), 0.0);
    };
    while (end < lasts.size() && sum(first, end) < 60) ++end;
    if (sum(end, lasts.size()) < 30) end = lasts.size();
    counts.push_back(end - first);
    first = end;
  }
  return counts;
}

double to_segment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const double length = (b - a).squaredNorm();
  const double part = length > 0 ? std::clamp((point - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (point - a - part * (b - a)).norm();
}

double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Nothing where two segments cross, else from an end of one to the other.
double apart(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return 0;
  return std::min(
      {to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
}

/// The least distance over the ground between two parts of a way, whole segments.
double apart(const Points& one, const Points& other) {
  double least = 1e18;
  for (std::size_t i = 1; i < one.size(); ++i)
    for (std::size_t j = 1; j < other.size(); ++j)
      least = std::min(least, apart(one[i - 1].head<2>(), one[i].head<2>(), other[j - 1].head<2>(),
                                    other[j].head<2>()));
  return least;
}

/// Way-points of the portions once those are joined between which the way comes back.
std::vector<std::size_t> joined(const Sweep& sweep, double width) {
  const std::vector<std::size_t> counts = cut(sweep);
  std::vector<Points> parts;
  Points all{Vector3::Zero()};
  all.insert(all.end(), sweep.points.begin(), sweep.points.end());
  auto at = all.begin();
  for (const std::size_t count : counts) {
    parts.emplace_back(at, at + static_cast<std::ptrdiff_t>(count) + 1);
    at += static_cast<std::ptrdiff_t>(count);
  }
  std::vector<std::size_t> group(parts.size());
  std::iota(group.begin(), group.end(), 0U);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = i + 2; j < parts.size(); ++j) {
        if (group[i] == group[j] || apart(parts[i], parts[j]) >= width) continue;
        const std::size_t from = group[i], to = group[j];
        for (std::size_t& one : group)
          if (one >= from && one <= to) one = from;
        changed = true;
      }
  }
  std::vector<std::size_t> result;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (part > 0 && group[part] == group[part - 1])
      result.back() += counts[part];
    else
      result.push_back(counts[part]);
  }
  return result;
}

std::vector<std::size_t> sizes(const std::vector<Points>& portions) {
  std::vector<std::size_t> counts;
  for (const Points& portion : portions) counts.push_back(portion.size());
  return counts;
}

// ---- laws -----------------------------------------------------------------------------------

RC_GTEST_PROP(PortionsProperty, OfAMinuteEachIfTheWayNeverComesBack, ()) {
  Sweep sweep = drawn_sweep();
  const std::vector<std::size_t> expected = cut(sweep);

  const auto portions = sweep.portions(0);

  RC_ASSERT(portions.has_value() == (expected.size() > 1));
  if (portions) RC_ASSERT(sizes(flown(*portions)) == expected);
}

RC_GTEST_PROP(PortionsProperty, AreJoinedWhereTheWayComesBackToAirThatItLeft, ()) {
  Sweep sweep = drawn_sweep();
  const double width = *rc::gen::inRange(1, 120) + 0.3717;
  const std::vector<std::size_t> expected = joined(sweep, width);

  const auto portions = sweep.portions(width);

  RC_ASSERT(portions.has_value() == (expected.size() > 1));
  if (portions) RC_ASSERT(sizes(flown(*portions)) == expected);
}

RC_GTEST_PROP(PortionsProperty, AreTogetherTheWholeWayInItsOrder, ()) {
  Sweep sweep = drawn_sweep();
  const auto portions = sweep.portions(*rc::gen::inRange(0, 60));
  RC_PRE(portions.has_value());

  Points all;
  for (const Points& portion : flown(*portions))
    all.insert(all.end(), portion.begin(), portion.end());
  RC_ASSERT(all == sweep.points);
}

// ---- examples -------------------------------------------------------------------------------

TEST(Portions, OfLanesWideApartAreAsManyAsThereAreMinutes) {
  Sweep sweep = lanes(6, 300, 60);  // a lane lasts a minute, a turn 12 s

  const auto portions = sweep.portions(30);

  ASSERT_TRUE(portions);
  EXPECT_EQ(sizes(flown(*portions)), (std::vector<std::size_t>{1, 2, 2, 2, 2, 2}));
}

TEST(Portions, OfLanesCloseToEachOtherWouldWaitForTheirOwnAir) {
  EXPECT_FALSE(lanes(6, 300, 20).portions(50)) << "two lanes on is still within the width";
}

TEST(Portions, OfAShortSweepAreNone) {
  EXPECT_FALSE(lanes(1, 440, 50).portions(10)) << "one way-point cannot be cut";
  Sweep sweep;
  sweep.points = {{300, 0, 40}, {300, 149, 40}};
  EXPECT_FALSE(sweep.portions(10)) << "29.8 s are left: too short for a portion of its own";
  sweep.points.back() = {300, 150, 40};
  EXPECT_TRUE(sweep.portions(10));
}

TEST(Portions, KeepWhatElseTheFlightSays) {
  Sweep sweep = lanes(4, 300, 60);
  auto portions = sweep.portions(10);
  ASSERT_TRUE(portions);

  portions->take();
  const functional::Request next = portions->next(Vector3(1, 2, 3));

  EXPECT_EQ(portions->task(), functional::TaskId(3));
  EXPECT_EQ(next.id, functional::TaskId(3));
  EXPECT_EQ(next.type, "goto");
  EXPECT_EQ(next.parameters.find("speed")->numbers, std::vector<double>{5});
  EXPECT_EQ(next.parameters.all().size(), 2U);
  EXPECT_EQ(way_points(next).front(), Vector3(1, 2, 3)) << "past where the vehicle got aside";
  EXPECT_EQ(way_points(next).size(), way_points(portions->next()).size() + 1);
}

TEST(Portions, AskForTheNextTwentySecondsBeforeTheEnd) {
  const auto portions = lanes(4, 300, 60).portions(10);
  ASSERT_TRUE(portions);

  EXPECT_TRUE(portions->is_near_end(100));
  EXPECT_FALSE(portions->is_near_end(100.1));
}

TEST(Portions, RunOnceHoweverManyOfThemDo) {
  auto portions = lanes(4, 300, 60).portions(10);
  ASSERT_TRUE(portions);
  functional::Status status;
  status.state = functional::TaskState::kEnded;

  EXPECT_FALSE(portions->begins_to_run(status));
  status.state = functional::TaskState::kRunning;
  EXPECT_TRUE(portions->begins_to_run(status));
  EXPECT_FALSE(portions->begins_to_run(status));
}

}  // namespace
}  // namespace skein::decision_node
