// SPDX-License-Identifier: Apache-2.0
// Teams at degree 4 whose ways cross, from pads that some share.
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 250;  // of cuts [s]
constexpr double kMiddle = 220;  // where ways cross [m]

class CrossingDrawing {
 public:
  CrossingDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random crossing mission"),
        sweeps_(seed, "random crossing mission: sweeps"),
        kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = 20;
    mission_.separation = kinds_.merged ? "{merge: true}" : "{merge: false}";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) +
                    ", gusts: " + tenths(random_.uniform(0, 0.5));
    draw_uavs();
    for (const Member& one : mission_.team) draw_work(one);
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 5, kLatest);
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  /// Around the middle: who starts at one side goes to the other.
  std::string on_ring(double angle, double radius) {
    return whole(kMiddle + radius * std::cos(angle)) + ", " +
           whole(kMiddle + radius * std::sin(angle));
  }

  // Pads lie on the ring; some have two UAVs, a few metres apart. Half of the missions are flown at
  // one height by all, so that nothing but their order keeps UAVs apart.
  void draw_uavs() {
    const std::size_t count = 2 + random_.below(7);
    const double turn = random_.uniform(0, 2 * std::numbers::pi);
    const bool one_height = random_.chance(0.5);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      const double drawn = random_.uniform();
      one.model = drawn < 0.6 ? "marvin" : drawn < 0.9 ? "heliv" : "karma";
      const bool shares = i > 0 && random_.chance(0.3);
      if (!shares) {
        pad_ = turn + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        radius_ = random_.uniform(100, 220);
      }
      mission_.shared_pads += shares ? 1 : 0;
      const double apart = shares ? random_.uniform(5, 9) : 0;
      pads_.push_back(pad_);
      one.more = "start: [" + on_ring(pad_, radius_ + apart) + "]";
      one.altitude = one_height ? 40 : 35 + 15 * static_cast<double>(random_.below(4));
      one.first_id = 1000 * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
  }

  std::string new_place(std::size_t who, double height) {
    const std::string name = "A" + std::to_string(mission_.places.size() + 1);
    const double across = pads_[who] + std::numbers::pi + random_.uniform(-0.6, 0.6);
    mission_.places.push_back(name + ": [" + on_ring(across, random_.uniform(20, 220)) + ", " +
                              whole(height) + "]");
    return name;
  }

  /// A zone of the middle is mapped by a blimp, or searched for some minutes.
  std::string new_sweep(const std::string& model) {
    const std::string zone = "Z" + std::to_string(mission_.zones.size() + 1);
    const double x = kMiddle + sweeps_.uniform(-120, 40), y = kMiddle + sweeps_.uniform(-120, 40);
    const double east = x + sweeps_.uniform(60, 120), north = y + sweeps_.uniform(60, 120);
    mission_.zones.push_back(zone + ": [[" + whole(x) + ", " + whole(y) + "], [" + whole(east) +
                             ", " + whole(y) + "], [" + whole(east) + ", " + whole(north) + "], [" +
                             whole(x) + ", " + whole(north) + "]]");
    if (model == "karma") return "[perform-mapping, " + zone + "]";
    mission_.places.push_back("A" + std::to_string(mission_.places.size() + 1) + ": [" +
                              whole((x + east) / 2) + ", " + whole((y + north) / 2) + ", 0]");
    return "[perform-detection, " + zone + ", A" + std::to_string(mission_.places.size()) + ", " +
           whole(sweeps_.uniform(60, 300)) + "]";
  }

  // To the other side, once or more, with a look now and then, and home.
  void draw_work(const Member& one) {
    const std::size_t who = next_++;
    Step step;
    step.name = "first-" + one.name;
    step.when = "{time: " + whole(random_.uniform(3, 15)) + "}";
    step.uav = one.name;
    step.mission = static_cast<int>(who + 1);
    const int goal = 700 + 1000 * static_cast<int>(who);
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) {
      const bool looks = random_.chance(0.4);
      const std::string place = new_place(who, looks ? 0 : one.altitude);
      step.tasks.push_back({goal + static_cast<int>(step.tasks.size()),
                            looks
                                ? "[perceive, " + place + ", " + whole(random_.uniform(5, 20)) + "]"
                                : "[general-gotoxyz, " + place + "]",
                            ""});
    }
    if (kinds_.sweeps && sweeps_.chance(0.4))
      step.tasks.push_back({goal + static_cast<int>(step.tasks.size()), new_sweep(one.model), ""});
    step.tasks.push_back({goal + static_cast<int>(step.tasks.size()), "[general-land]", ""});
    mission_.steps.push_back(std::move(step));
  }

  Random random_, sweeps_;  ///< what is drawn of others does not depend on sweeps
  Kinds kinds_;
  Mission mission_;
  double pad_ = 0, radius_ = 0;
  std::vector<double> pads_;
  std::size_t next_ = 0;
};

}  // namespace

Mission generate_crossing(std::uint64_t seed, const Kinds& kinds) {
  return CrossingDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
