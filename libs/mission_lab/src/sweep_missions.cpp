// SPDX-License-Identifier: Apache-2.0
// Several UAVs at degree 4 that search or map areas which lie beside or over each other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 400;                        // of cuts [s]
constexpr double kMiddle = 350;                        // of the areas [m]
constexpr double kWest = kMiddle - 300, kEast = 1180;  // of their row: the terrain ends at 1200

class SweepDrawing {
 public:
  SweepDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random sweeping mission"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 4000;
    mission_.finish_after = 20;
    mission_.separation = kinds_.merged ? "{merge: true}" : "{merge: false}";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) +
                    ", gusts: " + tenths(random_.uniform(0, 0.5));
    const std::size_t sweepers = 2 + random_.below(3), passers = random_.below(3);
    width_ = random_.uniform(180, 420);
    step_ = std::min(width_ * random_.uniform(0.3, 1.1),
                     (kEast - kWest - width_) / static_cast<double>(sweepers - 1));
    const bool one_height = random_.chance(0.7);
    for (std::size_t i = 0; i < sweepers + passers; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sweepers + passers);
      add_uav(i, angle, one_height ? 40 : 35 + 15 * static_cast<double>(random_.below(3)));
      i < sweepers ? add_sweep(i) : add_passage(i, angle);
    }
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatest);
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  static std::string on_ring(double angle, double radius) {
    return whole(kMiddle + radius * std::cos(angle)) + ", " +
           whole(kMiddle + radius * std::sin(angle));
  }

  void add_uav(std::size_t i, double angle, double height) {
    Member one;
    one.name = "uav" + std::to_string(i + 1);
    const double drawn = random_.uniform();
    one.model = drawn < 0.2   ? "heron"
                : drawn < 0.4 ? "wren"
                : drawn < 0.6 ? "swift"
                : drawn < 0.8 ? "marvin"
                : drawn < 0.9 ? "heliv"
                              : "karma";
    if (drawn < 0.6) one.folder = "area-sharing";
    one.more = "start: [" + on_ring(angle, random_.uniform(330, 380)) + "]";
    one.altitude = height;
    one.first_id = 1000 * static_cast<int>(i + 1);
    mission_.team.push_back(std::move(one));
  }

  std::string new_place(const std::string& at) {
    mission_.places.push_back("A" + std::to_string(mission_.places.size() + 1) + ": [" + at + "]");
    return "A" + std::to_string(mission_.places.size());
  }

  void give(std::size_t i, const std::vector<std::string>& tasks) {
    Step step;
    step.name = "first-" + mission_.team[i].name;
    step.when = "{time: " + whole(random_.uniform(3, 40)) + "}";
    step.uav = mission_.team[i].name;
    step.mission = static_cast<int>(i + 1);
    for (const std::string& words : tasks)
      step.tasks.push_back(
          {700 + 1000 * static_cast<int>(i) + static_cast<int>(step.tasks.size()), words, ""});
    mission_.steps.push_back(std::move(step));
  }

  /// The areas stand in a row, one over the next, beside it or a little apart.
  void add_sweep(std::size_t i) {
    const double west = kWest + step_ * static_cast<double>(i), east = west + width_;
    const double south = kMiddle - random_.uniform(50, 220),
                 north = kMiddle + random_.uniform(50, 220);
    const std::string zone = "Z" + std::to_string(mission_.zones.size() + 1);
    mission_.zones.push_back(zone + ": [[" + whole(west) + ", " + whole(south) + "], [" +
                             whole(east) + ", " + whole(south) + "], [" + whole(east) + ", " +
                             whole(north) + "], [" + whole(west) + ", " + whole(north) + "]]");
    const Member& one = mission_.team[i];
    if (one.model == "karma" || one.folder == "area-sharing")
      return give(i, {"[perform-mapping, " + zone + "]", "[general-land]"});
    const std::string middle =
        new_place(whole((west + east) / 2) + ", " + whole((south + north) / 2) + ", 0");
    give(i, {"[perform-detection, " + zone + ", " + middle + ", " +
                 whole(random_.uniform(150, 400)) + "]",
             "[general-land]"});
  }

  /// Through the areas, to the other side and back.
  void add_passage(std::size_t i, double angle) {
    const std::string height = whole(mission_.team[i].altitude);
    const std::string there =
        new_place(on_ring(angle + std::numbers::pi, random_.uniform(300, 360)) + ", " + height);
    const std::string back = new_place(on_ring(angle, random_.uniform(280, 320)) + ", " + height);
    give(i,
         {"[general-gotoxyz, " + there + "]", "[general-gotoxyz, " + back + "]", "[general-land]"});
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  double width_ = 0, step_ = 0;  ///< of areas, and from one to the next [m]
};

}  // namespace

Mission generate_sweeps(std::uint64_t seed, const Kinds& kinds) {
  return SweepDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
