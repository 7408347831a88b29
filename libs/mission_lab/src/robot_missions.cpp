// SPDX-License-Identifier: Apache-2.0
// Vehicles at degree 4 of which some keep to the ground, among hills that not all of them climb.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 400;  // of cuts, faults and what is asked for besides [s]
constexpr int kFirstMeeting = 500;
constexpr double kGentle = 0.02;  // height of a hill that even five at one place leave climbable

class RobotDrawing {
 public:
  RobotDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random robots"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 4000;
    mission_.finish_after = 20;
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.1";
    draw_hills();
    draw_vehicles();
    draw_meetings();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    for (std::size_t n = random_.below(4); n > 0; --n) draw_more();
    if (kinds_.air) draw_closings();
    if (kinds_.degrees && random_.chance(0.3)) draw_degrees();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatest);
    if (kinds_.faults && random_.chance(0.5)) draw_faults();
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  // From what all climb to what none does: too steep is as closed as closed air, and without that
  // all climb all of them.
  void draw_hills() {
    std::vector<std::string> hills;
    for (std::size_t n = random_.below(6); n > 0; --n) {
      const std::string at = point(random_.uniform(150, 500), random_.uniform(150, 500));
      const double drawn = random_.uniform(5, 50), radius = random_.uniform(60, 160);
      const double height = kinds_.air ? drawn : kGentle * radius;
      hills.push_back("{at: " + at + ", height: " + tenths(height) + ", radius: " + whole(radius) +
                      "}");
    }
    mission_.hills = joined(hills, ", ");
  }

  void draw_vehicles() {
    const std::size_t count = 2 + random_.below(5);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.folder = "action";
      const double drawn = i == 0 ? 1 : random_.uniform();
      one.model = drawn < 0.3 ? "ressac" : random_.chance(0.5) ? "mana" : "effibot";
      one.name = one.model + std::to_string(i + 1);
      const double turn =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      one.more = "start: " + point(-100 + 60 * std::cos(turn), -100 + 60 * std::sin(turn));
      if (kinds_.energy && random_.chance(0.15))
        one.more += ", energy: " + hundredths(random_.uniform(0.15, 0.5));
      one.altitude = 35 + 20 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
  }

  bool flies(std::size_t who) const { return mission_.team[who].model == "ressac"; }

  // Who hovers until one who drives is there may run short: only where energy may be short anyway.
  void draw_meetings() {
    for (std::size_t n = random_.below(4); n > 0; --n) {
      const std::size_t first = random_.below(mission_.team.size());
      const std::size_t second =
          (first + 1 + random_.below(mission_.team.size() - 1)) % mission_.team.size();
      if (!kinds_.energy && flies(first) != flies(second)) continue;
      meetings_.push_back({std::min(first, second), std::max(first, second)});
    }
  }

  std::string new_place() { return add_place(random_, mission_); }

  std::string a_task() {
    const std::string place = new_place();
    switch (random_.below(6)) {
      case 0:
        return "[general-gotoxyz, " + place + "]";
      case 1:
        return "[perform-tour, [" + place + ", " + new_place() + "]]";
      case 2:
        return "[perform-monitoring, " + place + ", " + whole(random_.uniform(30, 90)) + "]";
      case 3:
        return "[general-wait, " + whole(random_.uniform(5, 60)) + "]";
      default:
        return "[perceive, " + place + ", " + whole(random_.uniform(10, 90)) + "]";
    }
  }

  std::string by(double least, double most) {
    const bool bounded = kinds_.deadlines && random_.chance(0.15);
    return bounded ? "end_before: " + whole(random_.uniform(least, most)) : "";
  }

  void draw_work(std::size_t who) {
    const Member& one = mission_.team[who];
    Step step;
    step.name = "first-" + one.name;
    step.when = "{time: " + whole(random_.uniform(3, 40)) + "}";
    step.uav = one.name;
    step.mission = static_cast<int>(who + 1);
    step.placement = random_.chance(0.5) ? "last, achieve: any" : "";
    const int goal = 700 + 1000 * static_cast<int>(who);
    const auto add = [&](std::string words, std::string times = "") {
      step.tasks.push_back(
          {goal + static_cast<int>(step.tasks.size()), std::move(words), std::move(times)});
    };
    for (std::size_t i = 0; i < meetings_.size(); ++i) {
      const auto& [first, second] = meetings_[i];
      if (who != first && who != second) continue;
      for (std::size_t n = random_.below(2); n > 0; --n) add(a_task());
      const std::string both =
          "[" + mission_.team[first].name + ", " + mission_.team[second].name + "]";
      add("[synchro, " + std::to_string(kFirstMeeting + static_cast<int>(i)) + ", " + both + ", " +
              both + "]",
          by(300, 1500));
    }
    if (step.tasks.empty() || random_.chance(0.5)) add(a_task());
    if (random_.chance(0.7)) add("[general-land]", by(600, 2500));
    mission_.steps.push_back(std::move(step));
  }

  void draw_more() {
    static const std::vector<std::string> kPlacements{"",     "first",   "last",
                                                      "best", "in-time", "tour"};
    const std::size_t who = random_.below(mission_.team.size());
    Step step;
    step.name = "later-" + std::to_string(++more_);
    step.when = "{time: " + whole(random_.uniform(45, kLatest)) + "}";
    step.uav = mission_.team[who].name;
    step.mission = 10 + more_;
    step.placement = kPlacements[random_.below(kPlacements.size())];
    if (kinds_.changes && random_.chance(0.3)) step.placement = "first, interrupt: true";
    step.tasks.push_back({700 + 1000 * static_cast<int>(who) + 50 + more_, a_task(), ""});
    mission_.steps.push_back(std::move(step));
  }

  // Some down to the ground, some above the heads of those that drive; some only for a time.
  void draw_closings() {
    for (std::size_t n = random_.below(3); n > 0; --n) {
      const double x = random_.uniform(0, 400), y = random_.uniform(0, 400);
      const double half = random_.uniform(15, 60);
      std::string volume = "V" + std::to_string(n) + ": {polygon: " + rectangle(x, y, half, half) +
                           ", floor: " + (random_.chance(0.3) ? "60" : "0") + ", ceiling: 150";
      if (random_.chance(0.4)) {
        const double from = random_.uniform(50, kLatest);
        volume += ", from: " + whole(from) + ", until: " + whole(from + random_.uniform(50, 300));
      }
      mission_.volumes.push_back(volume + "}");
    }
  }

  void draw_degrees() {
    const std::string& who = mission_.team[random_.below(mission_.team.size())].name;
    const double at = random_.uniform(60, kLatest);
    const auto change = [&](const std::string& name, double when, const std::string& to) {
      Step step;
      step.name = name;
      step.when = "{time: " + whole(when) + "}";
      step.action = "degree: {uav: " + who + ", to: " + to + "}";
      mission_.steps.push_back(std::move(step));
    };
    change("down", at, std::to_string(1 + random_.below(3)));
    change("up", at + random_.uniform(10, 120), "4, resume: true");
  }

  void draw_faults() {
    for (std::size_t n = 1 + random_.below(2); n > 0; --n) {
      const std::string& who = mission_.team[random_.below(mission_.team.size())].name;
      mission_.faults.push_back(draw_fault(
          random_, who, [](Random&) { return std::string("visible"); }, kLatest));
    }
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<std::pair<std::size_t, std::size_t>> meetings_;
  int more_ = 0;
};

}  // namespace

Mission generate_robots(std::uint64_t seed, const Kinds& kinds) {
  return RobotDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
