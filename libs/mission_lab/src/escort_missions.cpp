// SPDX-License-Identifier: Apache-2.0
// UAVs that watch, escort or pursue something together, each at a place that they agree on, while
// what they watch moves; the ground station plays for a member below degree 4.
#include <array>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kEscortsGiven = 15;       // by then most have their missions [s]
constexpr double kLatestForEscorts = 700;  // of troubles [s]
constexpr int kGoalsOfOne = 1000;

/// A shipped interaction model with the teams that it is for.
struct EscortModel {
  const char* file;
  std::size_t least, most;  ///< members
  bool by_ground;           ///< the ground station may play a role of it
  bool follows;             ///< what moves is followed
};
constexpr std::array kEscortModels{EscortModel{"monitoring-around", 2, 4, false, false},
                                   EscortModel{"monitoring-by-chain", 2, 4, false, false},
                                   EscortModel{"monitoring-with-relay", 2, 2, false, false},
                                   EscortModel{"monitoring-with-ground", 2, 2, true, false},
                                   EscortModel{"escorting", 2, 4, true, true},
                                   EscortModel{"vehicle-pursuit", 4, 4, false, true}};

class EscortDrawing {
 public:
  EscortDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random escorts"),
        kinds_(kinds),
        model_(kEscortModels[random_.below(kEscortModels.size())]) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = kinds_.deaths ? -1 : 60;  // the goals of who dies are never settled
    mission_.partner_lease = random_.chance(0.3) ? 600 : random_.uniform(60, 400);
    mission_.separation = kinds_.merged ? "{merge: true}" : "";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 3)) + ", gusts: 0.1";
    mission_.joint = true;
    mission_.interaction = model_.file;
    if (random_.chance(0.4)) mission_.hills = a_hill();
    draw_team();
    draw_places();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    if (random_.chance(0.6)) move_target();
    draw_troubles();
    return std::move(mission_);
  }

 private:
  std::string a_hill() {
    return "{at: " + point(random_.uniform(150, 400), random_.uniform(-100, 350)) +
           ", height: " + whole_between(random_, 15, 45) +
           ", radius: " + whole_between(random_, 80, 180) + "}";
  }

  void draw_team() {
    const std::size_t count = model_.least + random_.below(model_.most - model_.least + 1);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = a_vehicle(i);
      one.folder = "mref";
      one.more = "start: " + point(-30, 40 * static_cast<double>(i) - 60);
      if (random_.chance(0.5)) one.more += contact_loss("return", 300);
      if (kinds_.energy && random_.chance(0.1))
        one.more += ", energy: " + hundredths(random_.uniform(0.4, 0.8));
      one.altitude = 40 + 20 * static_cast<double>(i);
      one.first_id = kGoalsOfOne * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
    if (model_.by_ground && random_.chance(0.5)) mission_.team.back().degree = 2;
  }

  // Who sees nothing can only relay, and the slow one pursues nothing.
  std::string a_vehicle(std::size_t place_in_team) {
    const std::string file = model_.file;
    if (file == "vehicle-pursuit" || place_in_team == 0) return "hawk";
    if (file == "monitoring-around") return random_.chance(0.7) ? "hawk" : "crow";
    const double drawn = random_.uniform();
    return drawn < 0.6 ? "hawk" : drawn < 0.8 ? "crow" : "owl";
  }

  // What is watched, its other side, and where the control centre is: a relay reaches 100 m to each
  // side.
  void draw_places() {
    double x = random_.uniform(60, 180), y = random_.uniform(-80, 160);
    if (std::string(model_.file).starts_with("monitoring-with")) x *= 0.6, y *= 0.6;
    const double turn = random_.uniform(0, 2 * std::numbers::pi);
    target_ = {x, y};
    mission_.places = {"T: " + on_ground(x, y),
                       "B: " + on_ground(x + 30 * std::cos(turn), y + 30 * std::sin(turn)),
                       "H: [0, 0, 0]"};
    std::vector<std::string> names;
    for (const Member& one : mission_.team) names.push_back(one.name);
    const std::string length =
        model_.follows ? whole_between(random_, 30, 420) : whole_between(random_, 20, 200);
    const bool pursuit = std::string(model_.file) == "vehicle-pursuit";
    joint_ = (pursuit ? "[vehicle-pursuit, T, H, " : "[monitoring-with-relay, T, B, H, ") + length +
             ", [" + joined(names, ", ") + "]]";
  }

  static std::string on_ground(double x, double y) {
    return "[" + whole(x) + ", " + whole(y) + ", 0]";
  }

  void draw_work(std::size_t who) {
    if (mission_.team[who].degree == 2) return let_ground_play(who);
    Step step;
    step.name = "first-" + mission_.team[who].name;
    const double latest = random_.chance(0.2) ? 150 : kEscortsGiven;
    step.when = "{time: " + whole(random_.uniform(3, latest)) + "}";
    step.uav = mission_.team[who].name;
    step.mission = static_cast<int>(who + 1);
    const auto add = [&](std::string words) {
      const int goal =
          700 + kGoalsOfOne * static_cast<int>(who) + static_cast<int>(step.tasks.size());
      step.tasks.push_back({goal, std::move(words), ""});
    };
    if (random_.chance(0.25)) add("[general-gotoxyz, " + an_air_place(who) + "]");
    add(joint_);
    if (random_.chance(0.25)) add("[general-gotoxyz, " + an_air_place(who) + "]");
    add("[general-land]");
    mission_.steps.push_back(std::move(step));
  }

  std::string an_air_place(std::size_t who) {
    const std::string name = "A" + std::to_string(mission_.places.size() + 1);
    mission_.places.push_back(name + ": [" + whole_between(random_, -50, 250) + ", " +
                              whole_between(random_, -100, 250) + ", " +
                              whole(mission_.team[who].altitude) + "]");
    return name;
  }

  // An operator has it take off, lets the ground station play, and brings it home.
  void let_ground_play(std::size_t who) {
    const Member& one = mission_.team[who];
    const std::string plan = "plan: {uav: " + one.name + ", tasks: [";
    const auto task = [&](int which) {
      return std::to_string(kGoalsOfOne * static_cast<int>(who) + which);
    };
    const std::string high = ", params: {altitude: " + whole(one.altitude) + "}}]}";
    add_action(mission_, "rises", "{time: " + whole_between(random_, 3, kEscortsGiven) + "}", 0,
               plan + "{id: " + task(1) + ", type: takeoff" + high);
    add_action(mission_, "ground-plays",
               "{task: {uav: " + one.name + ", id: " + task(1) + ", state: ended}}", 0,
               "play: {uav: " + one.name + ", id: " + task(2) + ", task: " + joint_ + "}");
    const std::string played = "{task: {uav: " + one.name + ", id: " + task(2) + ", state: ";
    add_action(mission_, "comes-home", "{any: [" + played + "ended}}, " + played + "aborted}}]}", 2,
               plan + "{id: " + task(3) + ", type: goto, mode: VUT, params: {to: [-30, " +
                   whole(40 * static_cast<double>(who) - 60) + ", " + whole(one.altitude) +
                   "]}}, {id: " + task(4) + ", type: land, mode: DEP}]}");
  }

  // Its driver, or who watches the fire, says every while where it is.
  void move_target() {
    const double turn = random_.uniform(0, 2 * std::numbers::pi);
    const double step = random_.uniform(4, 24), every = random_.uniform(15, 60);
    double at = random_.uniform(20, 300);
    for (std::size_t i = 2 + random_.below(8); i > 0; --i, at += every) {
      target_.first += step * std::cos(turn);
      target_.second += step * std::sin(turn);
      add_action(
          mission_, "moves-" + std::to_string(i), "{time: " + whole(at) + "}", 0,
          "know_place: {name: T, at: " + on_ground(target_.first, target_.second) + ", radius: 5}");
    }
  }

  void draw_troubles() {
    if (kinds_.radio) add_radio_troubles(random_, mission_, kLatestForEscorts);
    if (kinds_.degrees && random_.chance(0.3))
      add_hands(random_, mission_, any_of(random_, mission_).name, kLatestForEscorts);
    if (kinds_.air && random_.chance(0.15))
      add_closing_air(random_, mission_, target_.first, target_.second, kLatestForEscorts);
    if (kinds_.faults && random_.chance(0.2))
      mission_.faults.push_back(draw_fault(
          random_, any_of(random_, mission_).name, [](Random&) { return std::string("visible"); },
          kLatestForEscorts));
    if (kinds_.deaths) add_death_of_one(random_, mission_, kLatestForEscorts);
  }

  Random random_;
  Kinds kinds_;
  EscortModel model_;
  Mission mission_;
  std::pair<double, double> target_;
  std::string joint_;
};

}  // namespace

Mission generate_escorts(std::uint64_t seed, const Kinds& kinds) {
  return EscortDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
