// SPDX-License-Identifier: Apache-2.0
// Closed tours to try a solver on: TSPLIB files, and places like theirs. For tests and benches.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/tour_problem.hpp"

namespace skein::refiners::test {

using Place = std::pair<double, double>;

struct TourCase {
  std::string name;
  std::string metric = "EUC_2D";
  std::vector<Place> places;
};

/// Source: TSPLIB 95, 2.1, 2.4 and 2.5.
inline TourCost tsplib_distance(const TourCase& c, const Place& a, const Place& b) {
  const double dx = a.first - b.first, dy = a.second - b.second;
  if (c.metric == "ATT") {
    const double r = std::sqrt((dx * dx + dy * dy) / 10);
    const double t = std::round(r);
    return static_cast<TourCost>(t < r ? t + 1 : t);
  }
  if (c.metric != "GEO") return std::llround(std::hypot(dx, dy));
  const auto radians = [](double x) {
    const double degrees = std::trunc(x);
    return 3.141592 * (degrees + 5 * (x - degrees) / 3) / 180;
  };
  const double q1 = std::cos(radians(a.second) - radians(b.second));
  const double q2 = std::cos(radians(a.first) - radians(b.first));
  const double q3 = std::cos(radians(a.first) + radians(b.first));
  return static_cast<TourCost>(6378.388 * std::acos(0.5 * ((1 + q1) * q2 - (1 - q1) * q3)) + 1);
}

/// The first place is the start and the end.
inline TourProblem closed_tour(const TourCase& c) {
  const std::size_t stops = c.places.size() - 1;
  TourProblem problem;
  problem.inside.assign(stops, 0);
  problem.between.assign(stops * stops, 0);
  for (std::size_t i = 0; i < stops; ++i) {
    problem.stop_of.push_back(i);
    problem.from_start.push_back(tsplib_distance(c, c.places[0], c.places[i + 1]));
    for (std::size_t j = 0; j < stops; ++j)
      if (i != j)
        problem.between[i * stops + j] = tsplib_distance(c, c.places[i + 1], c.places[j + 1]);
  }
  problem.to_end = problem.from_start;
  return problem;
}

inline TourCase read_tsplib(const std::filesystem::path& file) {
  TourCase c{file.stem().string(), "EUC_2D", {}};
  std::ifstream in(file);
  bool coordinates = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word.starts_with("EDGE_WEIGHT_TYPE")) {
      c.metric = line.substr(line.find(':') + 1);
      c.metric.erase(0, c.metric.find_first_not_of(' '));
      c.metric.erase(c.metric.find_last_not_of(" \r") + 1);
    } else if (word == "NODE_COORD_SECTION") {
      coordinates = true;
    } else if (word == "EOF") {
      break;
    } else if (Place place; coordinates && words >> place.first >> place.second) {
      c.places.push_back(place);
    }
  }
  return c;
}

/// By name, from `tsplib_optima.txt`.
inline std::map<std::string, TourCost> read_optima(const std::filesystem::path& file) {
  std::map<std::string, TourCost> optima;
  std::ifstream in(file);
  std::string name, colon;
  for (TourCost best = 0; in >> name >> colon >> best;) optima[name] = best;
  return optima;
}

namespace detail {

inline double whole(double x) { return std::round(x); }

/// Uniform in a square, as kroA100 or ch130.
inline std::vector<Place> scattered(std::size_t count, Random& random) {
  std::vector<Place> places;
  while (places.size() < count)
    places.emplace_back(whole(random.uniform(0, 4000)), whole(random.uniform(0, 2000)));
  return places;
}

/// Normal heaps of unlike size, as cities in a country.
inline std::vector<Place> heaped(std::size_t count, Random& random) {
  const std::vector<Place> middles = scattered(6, random);
  std::vector<Place> places;
  while (places.size() < count) {
    const Place& middle = middles[random.below(random.below(middles.size()) + 1)];
    places.emplace_back(whole(middle.first + 120 * random.normal()),
                        whole(middle.second + 120 * random.normal()));
  }
  return places;
}

/// Holes to be drilled: the same small pattern again and again on a wide raster (pr107 … pr152).
inline std::vector<Place> drilled(std::size_t count, Random& random) {
  std::vector<Place> pattern;
  for (std::size_t i = 0; i < 8 + random.below(9); ++i)
    pattern.emplace_back(100.0 * static_cast<double>(random.below(12)),
                         100.0 * static_cast<double>(random.below(20)));
  const std::size_t across = 2 + random.below(3);
  std::set<Place> places;
  for (std::size_t block = 0; places.size() < count; ++block)
    for (const Place& hole : pattern)
      if (places.size() < count)
        places.emplace(hole.first + 4000.0 * static_cast<double>(block % across),
                       hole.second + 3000.0 * static_cast<double>(block / across));
  return {places.begin(), places.end()};
}

/// Two or three long columns of pins with gaps, as pr124, pr144 and lin105.
inline std::vector<Place> in_columns(std::size_t count, Random& random) {
  std::vector<double> columns;
  for (std::size_t i = 0; i < 4 + random.below(5); ++i)
    columns.push_back(whole(random.uniform(0, 12000)));
  std::set<Place> places;
  while (places.size() < count)
    places.emplace(columns[random.below(columns.size())],
                   100.0 * static_cast<double>(random.below(120)));
  return {places.begin(), places.end()};
}

/// A raster, each point off it by a little, as rat99 and rat195.
inline std::vector<Place> rattled(std::size_t count, Random& random) {
  const auto across = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  std::vector<Place> places;
  for (std::size_t i = 0; places.size() < count; ++i)
    places.emplace_back(whole(20.0 * static_cast<double>(i % across) + random.uniform(-5, 5)),
                        whole(20.0 * static_cast<double>(i / across) + random.uniform(-5, 5)));
  return places;
}

/// A part of a regular raster, with many equal distances, as u159 and tsp225.
inline std::vector<Place> on_a_raster(std::size_t count, Random& random) {
  std::set<Place> places;
  while (places.size() < count)
    places.emplace(100.0 * static_cast<double>(random.below(20)),
                   100.0 * static_cast<double>(random.below(16)));
  return {places.begin(), places.end()};
}

/// Few on a wide plain, most in one small heap far off, as d198 and bier127.
inline std::vector<Place> lopsided(std::size_t count, Random& random) {
  std::vector<Place> places = scattered(count / 4, random);
  while (places.size() < count)
    places.emplace_back(whole(5000 + 8.0 * static_cast<double>(random.below(40))),
                        whole(500 + 8.0 * static_cast<double>(random.below(60))));
  return places;
}

/// Two columns or rows of pins each, in blocks far from each other, some joined by single pins: a
/// place's nearest are all of its own block (pr226, pr264).
inline std::vector<Place> in_far_blocks(std::size_t count, Random& random) {
  std::set<Place> places;
  while (places.size() < count) {
    const double x = 1000.0 * static_cast<double>(random.below(16));
    const double y = 1000.0 * static_cast<double>(random.below(12));
    const bool across = random.chance(0.5);
    const std::size_t length = 5 + random.below(8), width = 1 + random.below(2);
    for (std::size_t i = 0; i < length && places.size() < count; ++i)
      for (std::size_t j = 0; j < width && places.size() < count; ++j) {
        const double along = 100.0 * static_cast<double>(i),
                     beside = 100.0 * static_cast<double>(j);
        places.emplace(x + (across ? along : beside), y + (across ? beside : along));
      }
    if (random.chance(0.5) && places.size() < count)
      places.emplace(x + whole(random.uniform(-2000, 2000)),
                     y + whole(random.uniform(-2000, 2000)));
  }
  return {places.begin(), places.end()};
}

/// Dense rasters in the corners of a board, each point of every other row between two of the next,
/// and few places between them (fl417).
inline std::vector<Place> on_a_board(std::size_t count, Random& random) {
  std::set<Place> places;
  const double pitch = 12;
  for (const double left : {500.0, 1500.0})
    for (const double top : {150.0, 2030.0})
      for (std::size_t i = 0; i < count / 6; ++i)
        places.emplace(left + pitch * static_cast<double>(i / 4) + (i % 2 == 0 ? 0 : pitch / 2),
                       top + pitch / 2 * static_cast<double>(i % 4));
  while (places.size() < count)
    places.emplace(whole(random.uniform(500, 1900)), whole(random.uniform(500, 2000)));
  return {places.begin(), places.end()};
}

}  // namespace detail

/// Kinds of places that TSPLIB has up to 200: `each` of every kind, 60 to 200 places.
inline std::vector<TourCase> cases_like_tsplib(std::size_t each, std::uint64_t seed) {
  using Maker = std::vector<Place> (*)(std::size_t, Random&);
  const std::array<std::pair<const char*, Maker>, 7> kinds = {{{"scattered", detail::scattered},
                                                               {"heaped", detail::heaped},
                                                               {"drilled", detail::drilled},
                                                               {"columns", detail::in_columns},
                                                               {"rattled", detail::rattled},
                                                               {"raster", detail::on_a_raster},
                                                               {"lopsided", detail::lopsided}}};
  std::vector<TourCase> cases;
  for (const auto& [kind, make] : kinds) {
    Random random(seed, kind);
    for (std::size_t i = 0; i < each; ++i) {
      const std::size_t count = i == 0 ? 200 : 60 + random.below(141);
      cases.push_back({std::string(kind) + std::to_string(count), "EUC_2D", make(count, random)});
    }
  }
  return cases;
}

/// Places in heaps far from each other, 180 to 300 of them.
inline std::vector<TourCase> cases_of_heaps(std::size_t each, std::uint64_t seed) {
  std::vector<TourCase> cases;
  for (std::uint64_t i = seed; i < seed + each; ++i) {
    Random random(i, "far");
    const std::size_t count = 180 + random.below(121);
    const std::string name = std::to_string(count) + "." + std::to_string(i);
    cases.push_back({"blocks" + name, "EUC_2D", detail::in_far_blocks(count, random)});
    cases.push_back({"board" + name, "EUC_2D", detail::on_a_board(count, random)});
  }
  return cases;
}

}  // namespace skein::refiners::test
