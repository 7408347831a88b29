// SPDX-License-Identifier: Apache-2.0
// Teams that their operators fly by elementary tasks, at degrees 1 to 3, rightly and wrongly.
#include <algorithm>
#include <tuple>
#include <utility>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kTroublesUntil = 400;  // of what goes wrong [s]
constexpr double kRunTime = 900;        // [s]

struct Craft {
  const char *name, *folder, *device;
  bool flies;
};
constexpr Craft kCrafts[]{{"marvin", "comets", "fire-sensor", true},
                          {"heliv", "comets", "visible", true},
                          {"karma", "comets", "mapping", true},
                          {"effibot", "action", "visible", false}};

class OrderDrawing {
 public:
  OrderDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random mission of orders"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = kRunTime;
    mission_.finish_after = -1;
    mission_.separation = kinds_.merged && random_.chance(0.6) ? "{merge: true}" : "";
    mission_.latency = random_.uniform(0.01, 0.3);
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.1";
    if (random_.chance(0.4)) mission_.hills = "{at: [250, 520], height: 60, radius: 200}";
    mission_.zones.push_back("Z1: " + draw_zone(random_));
    for (int i = 0; i < 3; ++i) places_.push_back(add_place(random_, mission_));
    if (kinds_.alarms && random_.chance(0.5))
      mission_.objects.push_back("hot: {kind: fire, position: " + point(200, 150) + ", radius: 5}");
    draw_team();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_flight(who, 5);
    for (std::size_t n = 1 + random_.below(5); n > 0; --n) draw_later();
    if (kinds_.air) draw_air();
    if (kinds_.faults && random_.chance(0.3)) draw_a_fault();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kTroublesUntil);
    if (kinds_.deaths) add_deaths(mission_, kTroublesUntil);
    return std::move(mission_);
  }

 private:
  void draw_team() {
    const std::size_t count = 1 + random_.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      models_.push_back(kCrafts[random_.below(std::size(kCrafts))]);
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = models_.back().name;
      one.folder = models_.back().folder;
      one.more = "start: " + point(45 * static_cast<double>(i), -60);
      one.altitude = 40 + 15 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      one.degree = 1 + static_cast<int>(random_.below(3));
      mission_.team.push_back(std::move(one));
      ids_.push_back(0);
      flights_.push_back(0);
    }
  }

  void act(const std::string& name, const std::string& when, double after, std::string action) {
    Step step;
    step.name = name + "-" + std::to_string(++acted_);
    step.when = when;
    step.after = after;
    step.action = std::move(action);
    mission_.steps.push_back(std::move(step));
  }

  // ---- elementary tasks ----

  bool errs() { return kinds_.changes && random_.chance(0.12); }

  std::string position(std::size_t who) {
    const double height = mission_.team[who].altitude;
    const double x = random_.uniform(-100, 500), y = random_.uniform(-150, 450);
    if (!errs()) {
      flown_to_.emplace_back(x, y);
      return "[" + whole(x) + ", " + whole(y) + ", " + whole(height) + "]";
    }
    switch (random_.below(4)) {
      case 0:
        return "[" + whole(x) + ", " + whole(y) + ", -30]";  // under the ground
      case 1:
        return "[" + whole(x) + ", " + whole(y) + ", 5000]";  // above any ceiling
      case 2:
        return "[99000, " + whole(y) + ", " + whole(height) + "]";  // outside the terrain
      default:
        return "[" + whole(x) + ", " + whole(y) + ", 0.2]";  // too low
    }
  }

  std::string motion(std::size_t who) {
    const std::string altitude = whole(mission_.team[who].altitude);
    switch (random_.below(6)) {
      case 0:
        return "goto, params: {to: " + places_[random_.below(places_.size())] +
               ", altitude: " + altitude + "}";
      case 1:
        return "goto, params: {over: {zone: Z1, spacing: 70, altitude: " + altitude + "}}";
      case 2:
        return "goto, params: {to: [" + position(who) + ", " + position(who) + "]}";
      case 3:
        return "wait, params: {duration: " + whole(random_.uniform(2, 60)) + "}";
      default:
        return "goto, params: {to: " + position(who) + "}";
    }
  }

  std::string look(std::size_t who) {
    const std::string device = std::string("params: {device: ") + models_[who].device;
    const std::string target = ", target: " + places_[random_.below(places_.size())];
    switch (random_.below(3)) {
      case 0:
        return "perceive, " + device + ", duration: " + whole(random_.uniform(2, 60)) + target +
               "}";
      case 1:
        return "takeshot, " + device + ", shots: " + whole(random_.uniform(1, 20)) + target + "}";
      default:
        return "takeshot, " + device + ", duration: " + whole(random_.uniform(2, 100)) + "}";
    }
  }

  std::string meeting(std::size_t who) {
    if (mission_.team.size() < 2) return motion(who);
    const std::size_t other =
        (who + 1 + random_.below(mission_.team.size() - 1)) % mission_.team.size();
    const std::string both = "[" + mission_.team[std::min(who, other)].name + ", " +
                             mission_.team[std::max(who, other)].name + "]";
    return std::string(random_.chance(0.5) ? "rendezvous" : "synchronise") +
           ", params: {id: " + std::to_string(500 + std::min(who, other) * 10) +
           ", senders: " + both + ", receivers: " + both +
           ", deadline: " + whole(random_.uniform(60, 500)) + "}";
  }

  std::string mode() {
    const char* const modes[]{"VUT", "NUT", "DEP", "SEQ"};
    return std::string(", mode: ") + (random_.chance(0.6) ? "DEP" : modes[random_.below(4)]);
  }

  std::string condition(std::size_t who) {
    const char* const states[]{"started", "running", "ended", "aborted"};
    switch (random_.below(3)) {
      case 0:
        return "{time: " + whole(random_.uniform(5, 500)) + ", is: passed}";
      case 1:
        return "{message: go}";
      default:
        return "{task: " + std::to_string(1 + random_.below(ids_[who] + 1)) +
               ", state: " + states[random_.below(4)] + ", modality: optional}";
    }
  }

  void add(std::vector<std::string>& tasks, std::size_t who, const std::string& type,
           const std::string& how) {
    std::string text = "{id: " + std::to_string(++ids_[who]) + how + ", type: " + type;
    if (random_.chance(0.1)) text += ", pre: [[" + condition(who) + "]]";
    if (random_.chance(0.1)) text += ", exit: [[" + condition(who) + "]]";
    tasks.push_back(text + "}");
  }

  // Takes off, flies, looks, and lands; where somebody errs, without the one or the other.
  void draw_flight(std::size_t who, double at) {
    std::vector<std::string> tasks;
    const bool first = flights_[who]++ == 0;
    if (models_[who].flies != errs() && (first || random_.chance(0.3)))
      add(tasks, who, "takeoff, params: {altitude: " + whole(mission_.team[who].altitude) + "}",
          ", mode: VUT");
    for (std::size_t n = 1 + random_.below(4); n > 0; --n) {
      const double drawn = random_.uniform();
      add(tasks, who, drawn < 0.6 ? motion(who) : drawn < 0.9 ? look(who) : meeting(who), mode());
    }
    if (random_.chance(0.5)) add(tasks, who, "land", mode());
    act("fly", "{time: " + whole(at + random_.uniform(0, 20)) + "}", 0,
        "plan: {uav: " + mission_.team[who].name + ", tasks: [" + joined(tasks, ", ") + "]}");
  }

  // ---- later ----

  std::string at_any_time() { return "{time: " + whole(random_.uniform(30, 500)) + "}"; }

  void draw_later() {
    const std::size_t who = random_.below(mission_.team.size());
    const std::string uav = "uav: " + mission_.team[who].name;
    const std::string id = std::to_string(1 + random_.below(ids_[who] + 2));
    switch (random_.below(kinds_.degrees ? 8 : 5)) {
      case 0:
      case 1:
        return draw_flight(who, random_.uniform(60, 500));
      case 2:
        return act("abort", at_any_time(), 0,
                   "abort: {" + uav + (random_.chance(0.5) ? "" : ", tasks: [" + id + "]") + "}");
      case 3:
        return act("update", at_any_time(), 0,
                   "update: {" + uav + ", id: " + id + ", pre: [[" + condition(who) + "]]}");
      case 4:
        return act("say", at_any_time(), 0, "message: {" + uav + ", text: go}");
      case 5:
        return act("degree", at_any_time(), 0,
                   "degree: {" + uav + ", to: " + std::to_string(1 + random_.below(4)) +
                       (random_.chance(0.5) ? ", interrupt: true" : "") +
                       (random_.chance(0.5) ? ", resume: true" : "") + "}");
      case 6:
        return draw_hand(uav);
      default:
        return draw_mission(who);
    }
  }

  void draw_hand(const std::string& uav) {
    const std::string interrupt = random_.chance(0.6) ? ", interrupt: true" : "";
    act("mine", at_any_time(), 0, "take_in_hand: {" + uav + interrupt + "}");
    const std::string mine = mission_.steps.back().name;
    act("yours", "{step: " + mine + "}", random_.uniform(10, 120), "give_back: {" + uav + "}");
  }

  // It is to plan from now on, if nobody takes that back.
  void draw_mission(std::size_t who) {
    const std::string& name = mission_.team[who].name;
    act("plans", at_any_time(), 0, "degree: {uav: " + name + ", to: 4, resume: true}");
    Step step;
    step.name = "mission-" + std::to_string(++acted_);
    step.when = "{degree: {uav: " + name + ", is: 4}}";
    step.after = 1;
    step.uav = name;
    step.mission = ++missions_;
    const int goal = 700 + 10 * missions_;
    step.tasks.push_back({goal, "[general-gotoxyz, " + places_[random_.below(3)] + "]", ""});
    if (random_.chance(0.6)) step.tasks.push_back({goal + 1, "[general-land]", ""});
    mission_.steps.push_back(std::move(step));
  }

  // ---- what goes wrong ----

  // Anywhere, or where somebody is sent to.
  void draw_air() {
    for (std::size_t n = random_.below(2); n > 0; --n) {
      double x = random_.uniform(100, 400), y = random_.uniform(50, 400);
      if (!flown_to_.empty() && random_.chance(0.6))
        std::tie(x, y) = flown_to_[random_.below(flown_to_.size())];
      const double half = random_.uniform(20, 60);
      act("close", at_any_time(), 0,
          "close_air: {name: smoke, polygon: " + rectangle(x, y, half, half) +
              ", floor: 0, ceiling: 150}");
    }
  }

  void draw_a_fault() {
    const std::size_t who = random_.below(mission_.team.size());
    mission_.faults.push_back(draw_fault(
        random_, mission_.team[who].name, [&](Random&) { return models_[who].device; },
        kTroublesUntil));
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<Craft> models_;                        ///< of each of the team
  std::vector<std::string> places_;                  ///< on the ground
  std::vector<std::pair<double, double>> flown_to_;  ///< x, y [m]
  std::vector<std::size_t> ids_;                     ///< the last task of each
  std::vector<std::size_t> flights_;                 ///< so many of each
  int acted_ = 0, missions_ = 0;
};

}  // namespace

Mission generate_orders(std::uint64_t seed, const Kinds& kinds) {
  return OrderDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
