// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_lab/rough_ground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/random.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kHighest = 140, kClear = 25;  // [m]
constexpr int kTries = 30;

using Point = std::pair<double, double>;

bool is_home(const std::string& place) { return place.starts_with('H'); }

std::vector<Point> level_places(const Mission& mission) {
  std::vector<Point> all{{0, 0}, {-20, -20}};
  for (const Member& one : mission.team)
    if (const auto start = one.more.find("start: ["); start != std::string::npos)
      all.push_back(point_in(one.more.substr(start)));
  for (const std::string& place : mission.places)
    if (is_home(place)) all.push_back(point_in(place));
  return all;
}

bool reaches(const Point& hill, double radius, const std::vector<Point>& places) {
  for (const Point& place : places)
    if (std::hypot(place.first - hill.first, place.second - hill.second) < radius + kClear)
      return true;
  return false;
}

struct Hill {
  Point at;
  double height = 0, radius = 0;  // [m]
};

/// As scenarios have it: a full period of a cosine, and the heights of hills that overlap add up.
double height_of(const std::vector<Hill>& hills, const Point& at) {
  double height = 0;
  for (const Hill& hill : hills) {
    const double away = std::hypot(at.first - hill.at.first, at.second - hill.at.second);
    if (away < hill.radius)
      height += hill.height * (1 + std::cos(std::numbers::pi * away / hill.radius)) / 2;
  }
  return height;
}

/// "P1: [10, 20, 0]" without its height, "A1: [10, 20, 80]" as high above the ground there.
std::string lifted(const std::string& place, const std::vector<Hill>& hills) {
  const std::size_t comma = place.rfind(", "), end = place.rfind(']');
  if (place.find(", ") == comma) return place;  // it has none
  const double height = std::stod(place.substr(comma + 2, end - comma - 2));
  if (height == 0) return place.substr(0, comma) + "]";
  return place.substr(0, comma + 2) + whole(height + height_of(hills, point_in(place))) + "]";
}

std::vector<Hill> draw_hills(Random& random, const std::vector<Point>& level) {
  std::vector<Hill> hills;
  for (int i = 0; i < kTries; ++i) {
    Hill hill;
    hill.at = {std::round(random.uniform(-250, 1'100)), std::round(random.uniform(-250, 850))};
    hill.radius = std::round(random.uniform(60, 260));
    hill.height = std::round(std::min(kHighest, hill.radius * random.uniform(0.25, 0.9)));
    if (!reaches(hill.at, hill.radius, level)) hills.push_back(hill);
  }
  return hills;
}

}  // namespace

void roughen(Mission& mission) {
  Random random(mission.seed, "random mission: rough ground");
  const std::vector<Hill> hills = draw_hills(random, level_places(mission));
  std::vector<std::string> texts;
  for (const Hill& hill : hills)
    texts.push_back("{at: " + point(hill.at.first, hill.at.second) +
                    ", height: " + whole(hill.height) + ", radius: " + whole(hill.radius) + "}");
  mission.hills = joined(texts, ", ");
  for (std::string& place : mission.places) place = lifted(place, hills);
}

}  // namespace skein::mission_lab
