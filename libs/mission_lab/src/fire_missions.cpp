// SPDX-License-Identifier: Apache-2.0
// UAVs at degree 4 over fires that spread, whose fronts the ground station follows.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatestTrouble = 400;  // of troubles [s]

class FireDrawing {
 public:
  FireDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random fires"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = std::round(random_.uniform(20, 60));
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) +
                    ", gusts: " + tenths(random_.uniform(0, 0.5));
    if (random_.chance(0.3)) mission_.hills = "{at: [250, 520], height: 60, radius: 220}";
    for (std::size_t n = 1 + random_.below(2); n > 0; --n) draw_fire();
    draw_team();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_first(who);
    if (kinds_.joint && random_.chance(0.5)) draw_joint();
    for (Step& step : mission_.steps)
      if (random_.chance(0.8)) add(step, "[general-land]");
    for (std::size_t n = random_.below(3); n > 0; --n) draw_later();
    if (kinds_.alarms && random_.chance(0.4)) draw_alarm();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatestTrouble);
    if (kinds_.faults && random_.chance(0.3)) draw_trouble();
    if (kinds_.deaths) add_deaths(mission_, kLatestTrouble);
    return std::move(mission_);
  }

 private:
  struct Fire {
    double x = 0, y = 0, radius = 0;
    std::string number;
    std::string name(const std::string& what) const { return what + number; }
  };

  std::string beside(const Fire& fire, double distance) {
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    return whole(fire.x + distance * std::cos(angle)) + ", " +
           whole(fire.y + distance * std::sin(angle));
  }

  // Some are seen for the first time long after they were lit. Where the front is thought to be at
  // first may be as far off as the ground station looks for it.
  void draw_fire() {
    Fire fire{random_.uniform(120, 450), random_.uniform(0, 350),
              std::round(random_.uniform(5, 45)), std::to_string(fires_.size() + 1)};
    const bool later = random_.chance(0.2);
    mission_.objects.push_back(
        "fire" + fire.number + ": {kind: fire, position: " + point(fire.x, fire.y) + ", radius: " +
        whole(fire.radius) + ", spread: {rate: " + hundredths(random_.uniform(0.01, 0.06)) +
        ", gain: " + hundredths(random_.uniform(0, 0.4)) + "}" +
        (later ? ", appears: " + whole(random_.uniform(20, 200)) : "") + "}");
    const double off = fire.radius + random_.uniform(-5, 30);
    mission_.places.push_back(fire.name("F") + ": [" + beside(fire, std::max(off, 0.0)) + ", 0]");
    mission_.places.push_back(fire.name("C") + ": " + point(fire.x, fire.y));
    mission_.places.push_back(fire.name("K") + ": [" +
                              beside(fire, fire.radius + random_.uniform(50, 90)) + ", 0]");
    mission_.followed.push_back(fire.name("F") + ": {kind: fire, reach: 60, drift: " +
                                tenths(random_.uniform(0.3, 1)) + "}");
    const double a = random_.uniform(50, 110), b = random_.uniform(50, 90);
    mission_.zones.push_back(fire.name("Z") + ": [" + point(fire.x - a, fire.y - b) + ", " +
                             point(fire.x + a, fire.y - b) + ", " + point(fire.x + a, fire.y + b) +
                             ", " + point(fire.x - a, fire.y + b) + "]");
    fires_.push_back(std::move(fire));
  }

  void draw_team() {
    std::vector<Member> all{{"marvin", "marvin", "start: [0, 0]", 40, 100},
                            {"heliv", "heliv", "start: [-40, 40]", 60, 1100},
                            {"karma", "karma", "start: [0, -100]", 90, 2100},
                            {"marvin2", "marvin", "start: [-60, -40]", 75, 3100}};
    for (std::size_t count = 1 + random_.below(4); count > 0; --count) {
      const auto one = all.begin() + static_cast<std::ptrdiff_t>(random_.below(all.size()));
      mission_.team.push_back(std::move(*one));
      all.erase(one);
    }
    next_goal_.resize(mission_.team.size());
    for (std::size_t i = 0; i < next_goal_.size(); ++i)
      next_goal_[i] = 700 + 1000 * static_cast<int>(i);
  }

  void add(Step& step, const std::string& words) {
    step.tasks.push_back({next_goal_[member_of(mission_, step)]++, words, ""});
  }

  const Fire& any_fire() { return fires_[random_.below(fires_.size())]; }

  std::string draw_task(const Member& one) {
    const Fire& fire = any_fire();
    const std::string front = fire.name("F"), zone = fire.name("Z");
    switch (random_.below(one.model == "karma" ? 5 : 4)) {
      case 0:
        return "[perform-monitoring, " + front + ", " + whole(random_.uniform(40, 200)) + "]";
      case 1:
        return "[perceive, " + front + ", " + whole(random_.uniform(20, 200)) + "]";
      case 2:
        return "[perform-detection, " + zone + ", " + front + ", " +
               whole(random_.uniform(60, 240)) + "]";
      case 3:
        return "[general-combined-goto-and-takeshot, " + front + ", " +
               whole(random_.uniform(10, 90)) + "]";
      default:
        return "[perform-mapping, " + zone + "]";
    }
  }

  void draw_first(std::size_t who) {
    const Member& one = mission_.team[who];
    Step step;
    step.name = "first-" + one.name;
    step.when = "{time: " + whole(random_.uniform(3, 30)) + "}";
    step.uav = one.name;
    step.mission = 1;
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) add(step, draw_task(one));
    mission_.steps.push_back(std::move(step));
  }

  // Two who hover watch a front, one of them as a relay.
  void draw_joint() {
    std::vector<Step*> able;
    for (Step& step : mission_.steps)
      if (mission_.team[member_of(mission_, step)].model != "karma" && able.size() < 2)
        able.push_back(&step);
    if (able.size() < 2) return;
    const Fire& fire = any_fire();
    mission_.joint = true;
    const std::string words = "[monitoring-with-relay, " + fire.name("F") + ", " + fire.name("C") +
                              ", " + fire.name("K") + ", " + whole(random_.uniform(60, 400)) +
                              ", [" + able[0]->uav + ", " + able[1]->uav + "]]";
    for (Step* step : able) add(*step, words);
  }

  void draw_later() {
    const std::size_t who = random_.below(mission_.team.size());
    Step step;
    step.name = "later-" + std::to_string(++later_);
    step.when = "{time: " + whole(random_.uniform(60, kLatestTrouble)) + "}";
    step.uav = mission_.team[who].name;
    step.mission = 10 + later_;
    step.placement = random_.chance(0.5) ? "best" : "first";
    add(step, draw_task(mission_.team[who]));
    mission_.steps.push_back(std::move(step));
  }

  // Somebody goes to what perceptions take for an alarm.
  void draw_alarm() {
    const std::size_t who = random_.below(mission_.team.size());
    Step step;
    step.name = "alarm-1";
    step.when = "{alarm: {state: raised, id: 1}}";
    step.after = 1;
    step.uav = mission_.team[who].name;
    step.mission = 20;
    add(step, "[perceive, alarm:1, " + whole(random_.uniform(10, 90)) + "]");
    mission_.steps.push_back(std::move(step));
  }

  void draw_trouble() {
    const Member& one = mission_.team[random_.below(mission_.team.size())];
    mission_.faults.push_back(draw_fault(random_, one, kLatestTrouble));
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<Fire> fires_;
  std::vector<int> next_goal_;
  int later_ = 0;
};

}  // namespace

Mission generate_fires(std::uint64_t seed, const Kinds& kinds) {
  return FireDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
