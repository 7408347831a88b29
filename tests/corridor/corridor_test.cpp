// SPDX-License-Identifier: Apache-2.0
// Vehicles stay in the air that libs/merging reserves for what they fly, whatever the wind, and
// half of the separation inside of it: the figures of its margins follow this simulator.
#include <gtest/gtest.h>

#include <cstdlib>

#include "skein/foundation/random.hpp"
#include "skein/merging/way.hpp"
#include "skein/world/separation.hpp"
#include "testing.hpp"

namespace skein::sim {
namespace {

using merging::Margins;
using merging::Volume;
using merging::Volumes;
using testing::a_config;
using testing::Flight;
using testing::way;
using world::Vector3;

/// How far out of the volume that holds it best [m]; negative inside.
double outside(const Volume& volume, const Vector3& at, const world::Separation& share) {
  const world::Vector2 along = volume.to - volume.from;
  const double length = along.squaredNorm();
  const double part =
      length > 0 ? std::clamp((at.head<2>() - volume.from).dot(along) / length, 0.0, 1.0) : 0;
  const double level =
      (at.head<2>() - volume.from - part * along).norm() - (volume.radius - share.level);
  const double height =
      std::max(volume.floor + share.height - at.z(), at.z() - (volume.ceiling - share.height));
  return std::max(level, height);
}

double outside(const Volumes& volumes, const Vector3& at, const world::Separation& share) {
  double least = 1e9;
  for (const Volume& one : volumes) least = std::min(least, outside(one, at, share));
  return least;
}

struct Sortie {
  std::string name;
  SimulatorConfig config;
  Margins margins;
  world::Separation share;
};

Sortie drawn(const std::string& name, Random& random) {
  Sortie sortie{name, a_config({name}), {}, {}};
  sortie.config.seed = random.bits();
  sortie.config.wind = {random.uniform(0, 6.28), random.uniform(0, 4), random.uniform(0, 0.8)};
  const world::VehicleModel& model = sortie.config.vehicles.front().model;
  sortie.margins = merging::margins_of(model, sortie.config.wind, model.cruise_speed);
  sortie.share = world::separation_share(model);
  return sortie;
}

std::vector<Vector3> points_from(const Vector3& start, Random& random) {
  std::vector<Vector3> points{start};
  const bool raised = random.chance(0.4);
  if (raised) points.push_back(start + Vector3(0, 0, random.uniform(10, 60)));
  for (std::size_t n = 1 + random.below(4); n > 0; --n) {
    points.emplace_back(random.uniform(-300, 500), random.uniform(-300, 500), points.back().z());
    if (random.chance(0.3)) points.back().z() += random.uniform(-10, 20);
  }
  if (raised) points.push_back({points.back().x(), points.back().y(), start.z()});
  return points;
}

int sorties() {
  const char* wanted = std::getenv("SKEIN_SORTIES");
  return wanted != nullptr ? std::atoi(wanted) : 15;
}

class Corridor : public ::testing::TestWithParam<const char*> {};

TEST_P(Corridor, HoldsTheVehicleOnItsWayAndWhereItEnds) {
  for (int seed = 1; seed <= sorties(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed), "corridor");
    Sortie sortie = drawn(GetParam(), random);
    const double ground_y = 10;
    Flight flight(sortie.config);
    Volumes held{column({0, ground_y}, 0, 60, sortie.margins)};
    double worst = -1e9;
    const auto watch = [&](int tenths) {
      for (int i = 0; i < tenths; ++i) {
        flight.run_for(0.1);
        worst = std::max(worst, outside(held, flight.state(sortie.name).position, sortie.share));
      }
    };
    flight.dispatch(sortie.name, 1, "takeoff", testing::altitude(60));
    for (int i = 0; i < 200 && !flight.terminal(1); ++i) watch(10);
    watch(300);
    EXPECT_LT(worst, 0) << "takeoff, seed " << seed;
    merging::Way along(points_from({0, ground_y, 60}, random), sortie.margins);
    std::vector<Vector3> sent(along.way_points().begin() + 1, along.way_points().end());
    const bool interrupted = random.chance(0.3);
    const int stops = 1 + static_cast<int>(random.below(44));
    flight.dispatch(sortie.name, 2, "goto", way(sent));
    worst = -1e9;
    for (int i = 0; i < 900 && !flight.terminal(2); ++i) {
      held = along.left();
      watch(10);
      along.passed(flight.state(sortie.name).position);
      if (interrupted && i == stops) flight.interrupt(sortie.name, 2);
    }
    watch(600);
    EXPECT_LT(worst, 0) << "way, seed " << seed << (interrupted ? ", interrupted" : "");
    const bool ended = flight.history(2) == "running ended";
    if (!ended) continue;
    held = {stay_at(along.points().back(), sortie.margins)};
    worst = -1e9;
    watch(600);
    EXPECT_LT(worst, 0) << "stay, seed " << seed;
    const Vector3 last = along.points().back();
    held = {column(last.head<2>(), 0, last.z(), sortie.margins)};
    flight.dispatch(sortie.name, 3, "land");
    worst = -1e9;
    for (int i = 0; i < 300 && flight.state(sortie.name).airborne; ++i) watch(10);
    EXPECT_LT(worst, 0) << "landing, seed " << seed;
  }
}

/// Lanes side by side, flown to and fro.
std::vector<Vector3> lanes(Random& random) {
  const double length = random.uniform(80, 250), apart = random.uniform(15, 60);
  std::vector<Vector3> points;
  for (int i = 0; i < 6; ++i) {
    const double x = 30 + apart * i, far = 10 + length;
    points.emplace_back(x, i % 2 == 0 ? 10 : far, 60);
    points.emplace_back(x, i % 2 == 0 ? far : 10, 60);
  }
  return points;
}

// What it keeps of the portion before it gives back once it has left some of the next.
TEST_P(Corridor, HoldsTheVehicleThatFliesOnFromPortionToPortion) {
  for (int seed = 1; seed <= sorties(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed), "corridor of portions");
    Sortie sortie = drawn(GetParam(), random);
    Flight flight(sortie.config);
    flight.dispatch(sortie.name, 1, "takeoff", testing::altitude(60));
    for (int i = 0; i < 200 && !flight.terminal(1); ++i) flight.run_for(1);
    flight.run_for(30);
    std::vector<Vector3> points = lanes(random);
    points.insert(points.begin(), {0, 10, 60});
    const auto cut = static_cast<std::ptrdiff_t>(2 + random.below(points.size() - 4));
    const std::vector<std::vector<Vector3>> portions{{points.begin(), points.begin() + cut + 1},
                                                     {points.begin() + cut, points.end()}};
    Volumes behind;
    double worst = -1e9;
    for (std::size_t n = 0; n < portions.size(); ++n) {
      merging::Way along(portions[n], sortie.margins, n == 0);
      std::vector<Vector3> sent(along.way_points().begin() + 1, along.way_points().end());
      flight.dispatch(sortie.name, 2 + n, "goto", way(sent));
      for (int i = 0; i < 9000 && !flight.terminal(2 + n); ++i) {
        Volumes held = along.left();
        if (along.is_whole()) held.insert(held.end(), behind.begin(), behind.end());
        flight.run_for(0.1);
        const Vector3 at = flight.state(sortie.name).position;
        worst = std::max(worst, outside(held, at, sortie.share));
        if (i % 10 == 0) along.passed(at);
      }
      ASSERT_EQ(flight.history(2 + n), "running ended") << "seed " << seed;
      behind = along.left();
    }
    EXPECT_LT(worst, 0) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, Corridor, ::testing::Values("marvin", "heliv", "karma"));

}  // namespace
}  // namespace skein::sim
